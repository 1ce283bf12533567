// DeRose, Goldman, Lounsbery: A Tutorial Introduction to Blossoming (1991), section 4.5: derivatives and
// continuity of first order.
//
// Coefficients and arguments are symbols: each case decides its statement for all of them, at the degrees
// that it names.

#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/rational/combinatorics.hpp>

#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// A section F of generic coefficients with blossom f, and a parameter s.
struct Section {
    Variables variables;
    Symbols c;
    SymbolicBlossom f;
    Symbol s;

    explicit Section(std::size_t d)
        : c(variables.next(d + 1)), f(SymbolicBlossom::of_coefficients(c)), s(variables.next()) {}

    /// F^(i)(s) from the coefficients.
    Symbol derivative_value(std::size_t i) const {
        return polynomial_value(derivative_coefficients(c, i), s);
    }
    /// f(arguments, s, ..., s).
    Symbol with_s(const SymbolicArguments& arguments) const {
        return f(joined({arguments, copies(f.degree() - arguments.size(), s)}));
    }
};

/// The derivative by u at u = 0, for u the variable of the given number.
Symbol slope_at_zero(const Symbol& symbol, std::size_t u) {
    Symbols values;
    for (std::size_t i = 0; i < u; ++i) values.push_back(Symbol::variable(i));
    values.emplace_back(0);
    return substitute(derivative(symbol, u), values);
}

/// The coefficients of sum_j e_j (t - s)^j.
Symbols around(const Symbols& e, const Symbol& s) {
    Symbols coefficients(e.size(), 0);
    for (std::size_t j = 0; j < e.size(); ++j) {
        for (std::size_t k = 0; k <= j; ++k) coefficients[k] += scaled(binomial(j, k), e[j] * pow(-s, j - k));
    }
    return coefficients;
}

/// The blossom g of G = F + sum_{j >= first} e_j (t - s)^j, every curve that agrees with F at s to the order
/// first - 1.
SymbolicBlossom neighbour(Section& section, std::size_t first) {
    Symbols e(section.c.size(), 0);
    for (std::size_t j = first; j < e.size(); ++j) e[j] = section.variables.next();
    Symbols coefficients = around(e, section.s);
    for (std::size_t k = 0; k < coefficients.size(); ++k) coefficients[k] += section.c[k];
    return SymbolicBlossom::of_coefficients(std::move(coefficients));
}

}  // namespace

TEST_CASE("derose-F1-def: F'(s) is the slope of f(s+u,..,s+u) at u = 0, degrees 1 to 5", "[statement]") {
    for (std::size_t d = 1; d <= 5; ++d) {
        Section section(d);
        const std::size_t u = section.variables.used();
        const Symbol moved = section.s + section.variables.next();
        CHECK(slope_at_zero(section.f(copies(d, moved)), u) == section.derivative_value(1));
        CHECK(slope_at_zero(polynomial_value(section.c, moved), u) == section.derivative_value(1));
    }
}

TEST_CASE(
    "derose-chain: the slope of f(s+u,..,s+u) is the sum of the partial derivatives of f, degrees 1 to 5",
    "[statement]") {
    for (std::size_t d = 1; d <= 5; ++d) {
        Section section(d);
        const std::size_t first = section.variables.used();
        const Symbols u = section.variables.next(d);
        const Symbol step = section.variables.next();
        Symbols moved;
        for (std::size_t i = 0; i < first; ++i) moved.push_back(Symbol::variable(i));
        for (std::size_t i = 0; i < d; ++i) moved.push_back(section.s + step);
        Symbol total;
        for (std::size_t i = 0; i < d; ++i)
            total += substitute(derivative(section.f(points(u)), first + i), moved);
        CHECK(derivative(section.f(copies(d, section.s + step)), first + d) == total);
    }
}

TEST_CASE("derose-partial: df/du_i at (s,..,s) is f(1,s,..) - f(0,s,..), degrees 1 to 5", "[statement]") {
    for (std::size_t d = 1; d <= 5; ++d) {
        Section section(d);
        const std::size_t first = section.variables.used();
        const Symbols u = section.variables.next(d);
        Symbols at_s;
        for (std::size_t i = 0; i < first; ++i) at_s.push_back(Symbol::variable(i));
        for (std::size_t i = 0; i < d; ++i) at_s.push_back(section.s);
        for (std::size_t i = 0; i < d; ++i) {
            const SymbolicArguments arguments = points(u);
            const Symbol at_zero = section.f(replaced(arguments, i, 0));
            const Symbol at_one = section.f(replaced(arguments, i, 1));
            CHECK(section.f(arguments) == (1 - u[i]) * at_zero + u[i] * at_one);
            CHECK(substitute(derivative(section.f(arguments), first + i), at_s) ==
                  section.with_s({1}) - section.with_s({0}));
        }
    }
}

TEST_CASE("derose-F1: F'(s) = d (f(1,s,..) - f(0,s,..)), degrees 1 to 7", "[statement]") {
    for (std::size_t d = 1; d <= 7; ++d) {
        const Section section(d);
        CHECK(scaled(d, section.with_s({1}) - section.with_s({0})) == section.derivative_value(1));
    }
}

TEST_CASE("derose-F2: F''(s) = d (d-1) (f(1,1,s..) - 2f(1,0,s..) + f(0,0,s..)), degrees 2 to 7",
          "[statement]") {
    for (std::size_t d = 2; d <= 7; ++d) {
        const Section section(d);
        CHECK(scaled(d * (d - 1), section.with_s({1, 1}) - 2 * section.with_s({1, 0}) +
                                      section.with_s({0, 0})) == section.derivative_value(2));
    }
}

TEST_CASE("derose-eq4: the i-th derivative as an alternating sum of blossom values, degrees 0 to 6, all i",
          "[statement]") {
    for (std::size_t n = 0; n <= 6; ++n) {
        const Section section(n);
        for (std::size_t i = 0; i <= n; ++i) {
            Symbol total;
            for (std::size_t j = 0; j <= i; ++j) {
                const Symbol term = scaled(binomial(i, j), section.with_s(runs(i - j, 1, j, 0)));
                total += j % 2 == 0 ? term : -term;
            }
            CHECK(scaled(falling_factorial(n, i), total) == section.derivative_value(i));
        }
        CHECK(section.derivative_value(n + 1).is_zero());
    }
}

TEST_CASE("derose-eq5: C^1 at s gives equal values and equal differences f(1,s..)-f(0,s..), degrees 2 to 5",
          "[statement]") {
    for (std::size_t n = 2; n <= 5; ++n) {
        Section section(n);
        const SymbolicBlossom g = neighbour(section, 2);
        const SymbolicArguments tail = copies(n - 1, section.s);
        CHECK(section.with_s({}) == g(copies(n, section.s)));
        CHECK(section.with_s({1}) - section.with_s({0}) == g(joined({{1}, tail})) - g(joined({{0}, tail})));
        // Without C^1 the differences differ, by e_1.
        const SymbolicBlossom h = neighbour(section, 1);
        CHECK(section.with_s({1}) - section.with_s({0}) != h(joined({{1}, tail})) - h(joined({{0}, tail})));
    }
}

TEST_CASE("derose-eq5-sum: f(1,s..) - f(0,s..) + f(s,s..) = f(s+1,s..), degrees 1 to 6", "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        const Section section(n);
        CHECK(section.with_s({1}) - section.with_s({0}) + section.with_s({section.s}) ==
              section.with_s({section.s + 1}));
    }
}

TEST_CASE("derose-eq6: C^1 at s gives f(s,..) = g(s,..) and f(s+1,s..) = g(s+1,s..), degrees 2 to 5",
          "[statement]") {
    for (std::size_t n = 2; n <= 5; ++n) {
        Section section(n);
        const SymbolicBlossom g = neighbour(section, 2);
        CHECK(section.with_s({}) == g(copies(n, section.s)));
        CHECK(section.with_s({section.s + 1}) == g(joined({{section.s + 1}, copies(n - 1, section.s)})));
    }
}

TEST_CASE("derose-eq7: f(x,s..) = g(x,s..) for all x exactly when F and G meet C^1 at s, degrees 1 to 5",
          "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        Section section(n);
        const Symbol x = section.variables.next();
        const Symbols e = section.variables.next(n + 1);
        // The blossom of the generic difference D = sum e_j (t - s)^j at (x, s, ..) is e_0 + e_1 (x - s) / n,
        // which is zero for all x exactly when e_0 = e_1 = 0.
        const auto difference = SymbolicBlossom::of_coefficients(around(e, section.s));
        CHECK(difference(joined({{x}, copies(n - 1, section.s)})) ==
              e[0] + e[1] * (x - section.s) * fraction(1, n));
        // Every x is an affine combination of s and s + 1.
        const Symbol weight = x - section.s;
        CHECK(section.with_s({x}) ==
              (1 - weight) * section.with_s({section.s}) + weight * section.with_s({section.s + 1}));
    }
}
