// Fernandez-Jambrina, corollary 1: the blossom from values of the parametrisation. Coefficients and arguments
// are variables except where a case counts calls.

#include <blossom/core/blossom/blossom.hpp>

#include "support/map_printing.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

Symbol mean(const Symbols& symbols) { return Symbol(Rational(1, symbols.size())) * sum(symbols); }

/// Equation (20) as printed, for n >= 1.
Symbol equation_20(const GenericPolynomial& b, const Symbols& t) {
    const std::size_t n = t.size();
    Symbols terms;
    for (std::size_t subset = 1; subset < std::size_t{1} << n; ++subset) {
        Symbols chosen;
        for (std::size_t i = 0; i < n; ++i) {
            if ((subset >> i & 1) != 0) chosen.push_back(t[i]);
        }
        const Integer weight =
            pow(Integer(chosen.size()), n) * Integer((n - chosen.size()) % 2 == 0 ? 1 : -1);
        terms.push_back(scaled(weight, b(mean(chosen))));
    }
    return Symbol(Rational(1, factorial(n))) * sum(terms);
}

}  // namespace

TEST_CASE("fj-cor1", "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        GenericPolynomial b(n);
        const Symbols t = b.variables.next(n);
        CHECK(equation_20(b, t) == b.p(points(t)));
        CHECK(by_polarization(b.c, points(t)) == b.p(points(t)));
    }
    // b must be a polynomial: for the arc x = (1 - t^2) / (1 + t^2) the formula gives 7/10 where the control
    // point has 1.
    const auto arc = [](const Rational& t) -> Coordinates {
        return {(Rational(1) - t * t) / (Rational(1) + t * t)};
    };
    const std::vector<Parameter> ends{Parameter(0), Parameter(1)};
    CHECK(blossom_from_values(arc, ends) == Coordinates{Rational(7, 10)});
}

TEST_CASE("fj-cor1-n2", "[statement]") {
    GenericPolynomial b(2);
    const Symbols t = b.variables.next(2);
    CHECK(b.p(points(t)) == Symbol(Rational(1, 2)) * (scaled(4, b(mean(t))) - b(t[0]) - b(t[1])));
}

TEST_CASE("fj-cor1-n3", "[statement]") {
    GenericPolynomial b(3);
    const Symbols t = b.variables.next(3);
    CHECK(b.p(points(t)) ==
          Symbol(Rational(1, 6)) *
              (scaled(27, b(mean(t))) + b(t[0]) + b(t[1]) + b(t[2]) -
               scaled(8, b(mean({t[0], t[1]})) + b(mean({t[1], t[2]})) + b(mean({t[0], t[2]})))));
}

TEST_CASE("fj-cost", "[statement]") {
    // 2^n - 1 evaluations for n different arguments, which is the sum of C(n, N) over N >= 1.
    for (std::size_t n = 1; n <= 16; ++n) {
        std::size_t calls = 0;
        const auto counted = [&](const Rational& t) -> Coordinates {
            ++calls;
            return {t};
        };
        std::vector<Parameter> arguments;
        for (std::size_t i = 0; i < n; ++i) arguments.emplace_back(i * i);
        blossom_from_values(counted, arguments);
        CHECK(calls == (std::size_t{1} << n) - 1);
        Integer total;
        for (std::size_t k = 1; k <= n; ++k) total += binomial(n, k);
        CHECK(total == calls);
        // Fewer when they coincide: it is an upper bound.
        calls = 0;
        blossom_from_values(counted, std::vector<Parameter>(n, Parameter(3)));
        CHECK(calls == n);
    }
}
