#include <blossom/core/blossom/change_of_basis.hpp>
#include "core_test.hpp"

#include "support/symbolic.hpp"

// The constructions agree for all polynomials and all arguments: coefficients and arguments are variables.

namespace {

struct Frame {
    Integer a;
    Integer b;
    Integer q;
};

/// [0, 1], [-2/3, 5/3], the latter reversed, and one with a large denominator.
const Frame frames[] = {{0, 1, 1}, {-2, 5, 3}, {5, -2, 3}, {INT64_MIN, 7, INT64_MAX}};

/// Control points over [a/q, b/q], by a change of basis that does not use symmetric functions.
Symbols control_points(const Symbols& coefficients, const Frame& frame) {
    const auto points = constructions::bernstein_from_monomial(std::span<const Symbol>(coefficients), frame.a,
                                                               frame.b, frame.q);
    Symbols result = points.numerators;
    for (Symbol& point : result) point *= Symbol(Rational(1, points.denominator));
    return result;
}

}  // namespace

TEST_CASE("symbolic agreement of the three constructions at any points, degrees 0 to 8", "[symbolic]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        Variables variables;
        const Symbols symbols = variables.next(n);
        const SymbolicArguments arguments = points(symbols);
        const Symbols coefficients = variables.next(n + 1);
        const Symbol expected = by_symmetric_functions(coefficients, arguments);
        CAPTURE(n);
        CHECK(by_polarization(coefficients, arguments) == expected);
        CHECK(by_casteljau(control_points(coefficients, frames[0]), 0, 1, 1, arguments) == expected);
        Symbols terms;
        for (std::size_t k = 0; k <= n; ++k) terms.push_back(coefficients[k] * subset_average(symbols, k));
        CHECK(sum(terms) == expected);
    }
}

TEST_CASE("symbolic agreement of the three constructions at any pairs, degrees 0 to 5", "[symbolic]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        Variables variables;
        const SymbolicArguments arguments = generic_pairs(variables, n);
        const Symbols coefficients = variables.next(n + 1);
        const Symbol expected = by_symmetric_functions(coefficients, arguments);
        CAPTURE(n);
        CHECK(by_polarization(coefficients, arguments) == expected);
        for (const Frame& frame : frames) {
            CHECK(by_casteljau(control_points(coefficients, frame), frame.a, frame.b, frame.q, arguments) ==
                  expected);
        }
    }
}

TEST_CASE("symbolic agreement at repeated arguments, points and vectors mixed", "[symbolic]") {
    for (std::size_t n = 0; n <= 7; ++n) {
        for (std::size_t deltas = 0; deltas <= n; ++deltas) {
            Variables variables;
            const Symbol t = variables.next();
            const Symbol u = variables.next();
            const Symbols coefficients = variables.next(n + 1);
            const std::size_t rest = n - deltas;
            const SymbolicArguments arguments =
                joined({copies(rest / 2, t), copies(deltas, symbolic_delta), copies(rest - rest / 2, u)});
            const Symbol expected = by_symmetric_functions(coefficients, arguments);
            CAPTURE(n, deltas);
            CHECK(by_polarization(coefficients, arguments) == expected);
            CHECK(by_casteljau(control_points(coefficients, frames[2]), 5, -2, 3, arguments) == expected);
        }
    }
}

TEST_CASE("the bases change into each other and back for all coefficients", "[symbolic]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        Variables variables;
        const Symbol t = variables.next();
        const Symbols coefficients = variables.next(n + 1);
        for (const Frame& frame : frames) {
            CAPTURE(n, frame.a, frame.b, frame.q);
            const Symbols points = control_points(coefficients, frame);
            const auto back = constructions::monomial_from_bernstein(std::span<const Symbol>(points), frame.a,
                                                                     frame.b, frame.q);
            for (std::size_t k = 0; k <= n; ++k) {
                CHECK(back.numerators[k] * Symbol(Rational(1, back.denominator)) == coefficients[k]);
            }
            // The Bernstein sum over [a/q, b/q] times (b - a)^n is P.
            const Symbol x = scaled(frame.q, t) - Symbol(frame.a);
            const Symbol y = Symbol(frame.b) - scaled(frame.q, t);
            CHECK(bernstein_value(points, x, y) ==
                  scaled(pow(frame.b - frame.a, n), polynomial_value(coefficients, t)));
        }
    }
}
