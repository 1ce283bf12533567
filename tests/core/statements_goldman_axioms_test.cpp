// Goldman, Lecture 26, sections 1 and 2: each case decides the statement of its name, with all coefficients
// and all arguments as variables, for the degrees in its loop.

#include <utility>

#include "support/map_printing.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

TEST_CASE("goldman-linear", "[statement]") {
    Variables variables;
    const Symbol a = variables.next(), mu = variables.next(), lambda = variables.next();
    const Symbol s = variables.next(), t = variables.next();
    const auto map = [&](const Symbol& x) { return a * x; };
    CHECK(map(mu * s + lambda * t) == mu * map(s) + lambda * map(t));
}

TEST_CASE("goldman-affine", "[statement]") {
    Variables variables;
    const Symbol a = variables.next(), b = variables.next(), lambda = variables.next();
    const Symbol s = variables.next(), t = variables.next();
    const auto map = [&](const Symbol& x) { return a * x + b; };
    CHECK(map((Symbol(1) - lambda) * s + lambda * t) == (Symbol(1) - lambda) * map(s) + lambda * map(t));
}

TEST_CASE("goldman-nonaffine", "[statement]") {
    // The conditions on the coefficients for the affine defect to vanish have rank n - 1, and hold when only
    // c0 and c1 are not zero: they say exactly that c2 = ... = cn = 0.
    for (std::size_t n = 2; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const Symbol lambda = curve.variables.next(), s = curve.variables.next(), t = curve.variables.next();
        const auto defect = [&](const Symbols& c) {
            return polynomial_value(c, (Symbol(1) - lambda) * s + lambda * t) -
                   (Symbol(1) - lambda) * polynomial_value(c, s) - lambda * polynomial_value(c, t);
        };
        CHECK(rank_of_conditions({defect(curve.c)}, n + 1) == n - 1);
        CHECK(defect({curve.c[0], curve.c[1]}).is_zero());
    }
}

TEST_CASE("goldman-axiom-sym", "[statement]") {
    // Adjacent transpositions generate all permutations.
    for (std::size_t n = 2; n <= 7; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArguments arguments = points(curve.variables.next(n));
        for (std::size_t i = 0; i + 1 < n; ++i) {
            SymbolicArguments swapped = arguments;
            std::swap(swapped[i], swapped[i + 1]);
            CHECK(curve.p(swapped) == curve.p(arguments));
        }
    }
}

TEST_CASE("goldman-axiom-affine", "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArguments arguments = points(curve.variables.next(n));
        const Symbol alpha = curve.variables.next(), v = curve.variables.next();
        for (std::size_t k = 0; k < n; ++k) {
            const Symbol u = arguments[k].u;
            CHECK(curve.p(replaced(arguments, k, (Symbol(1) - alpha) * u + alpha * v)) ==
                  (Symbol(1) - alpha) * curve.p(arguments) + alpha * curve.p(replaced(arguments, k, v)));
        }
    }
}

TEST_CASE("goldman-axiom-diag", "[statement]") {
    for (std::size_t n = 0; n <= 12; ++n) {
        GenericPolynomial curve(n);
        const Symbol t = curve.variables.next();
        CHECK(curve.p(copies(n, t)) == curve(t));
    }
}

TEST_CASE("goldman-primary", "[statement]") {
    // Dual functionals and differentiation; symmetry, multiaffinity and diagonal are the axioms above.
    GenericPolynomial curve(3);
    const Symbol a = curve.variables.next(), b = curve.variables.next(), t = curve.variables.next();
    Symbols dual;
    for (std::size_t k = 0; k <= 3; ++k) dual.push_back(curve.p(joined({copies(3 - k, a), copies(k, b)})));
    CHECK(bernstein_value(dual, t - a, b - t) == pow(b - a, 3) * curve(t));
    CHECK(scaled(3, curve.p({t, t, symbolic_delta})) ==
          polynomial_value(derivative_coefficients(curve.c, 1), t));
}

TEST_CASE("goldman-degree-one", "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const Symbol value = curve.p(points(curve.variables.next(n)));
        for (std::size_t k = 0; k < n; ++k) CHECK(value.degree_in(n + 1 + k) == 1);
    }
}

TEST_CASE("goldman-ex1-monomials", "[statement]") {
    Variables variables;
    const Symbols u = variables.next(3);
    const Symbol third(Rational(1, 3));
    const auto cubic = [&](const Symbols& c) { return by_symmetric_functions(c, points(u)); };
    CHECK(cubic({1, 0, 0, 0}) == Symbol(1));
    CHECK(cubic({0, 1, 0, 0}) == third * (u[0] + u[1] + u[2]));
    CHECK(cubic({0, 0, 1, 0}) == third * (u[0] * u[1] + u[1] * u[2] + u[2] * u[0]));
    CHECK(cubic({0, 0, 0, 1}) == u[0] * u[1] * u[2]);
}

TEST_CASE("goldman-ex1-cubic", "[statement]") {
    GenericPolynomial curve(3);
    const Symbols u = curve.variables.next(3);
    const Symbol third(Rational(1, 3));
    CHECK(curve.p(points(u)) == curve.c[3] * u[0] * u[1] * u[2] +
                                    curve.c[2] * third * (u[0] * u[1] + u[1] * u[2] + u[2] * u[0]) +
                                    curve.c[1] * third * (u[0] + u[1] + u[2]) + curve.c[0]);
}

TEST_CASE("goldman-degree-decides", "[statement]") {
    Variables variables;
    const Symbols u = variables.next(2);
    CHECK(by_symmetric_functions({0, 1}, {u[0]}) == u[0]);
    CHECK(by_symmetric_functions({0, 1, 0}, points(u)) == Symbol(Rational(1, 2)) * (u[0] + u[1]));
}

TEST_CASE("goldman-prop1", "[statement]") {
    // Against the average over all k-subsets, from the definition, by each construction from coefficients.
    for (std::size_t n = 0; n <= 7; ++n) {
        for (std::size_t k = 0; k <= n; ++k) {
            Variables variables;
            const Symbols u = variables.next(n);
            Symbols monomial(n + 1);
            monomial[k] = 1;
            CHECK(by_symmetric_functions(monomial, points(u)) == subset_average(u, k));
            CHECK(by_polarization(monomial, points(u)) == subset_average(u, k));
        }
    }
}

TEST_CASE("goldman-thm2", "[statement]") {
    // The map by symmetric functions satisfies the three axioms: a blossom of every polynomial exists.
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArguments u = points(curve.variables.next(n));
        const Symbol t = curve.variables.next(), alpha = curve.variables.next();
        CHECK(curve.p(copies(n, t)) == curve(t));
        SymbolicArguments reversed(u.rbegin(), u.rend());
        CHECK(curve.p(reversed) == curve.p(u));
        CHECK(curve.p(replaced(u, 0, (Symbol(1) - alpha) * u[0].u + alpha * t)) ==
              (Symbol(1) - alpha) * curve.p(u) + alpha * curve.p(replaced(u, 0, t)));
    }
}

namespace {

/// A polynomial of degree at most one in each of n arguments, with its 2^n coefficients as the first
/// variables.
struct Multiaffine {
    explicit Multiaffine(std::size_t n) : degree(n), w(variables.next(std::size_t{1} << n)) {}
    Symbol operator()(const Symbols& u, const Symbols& mass) const {
        Symbols terms;
        for (std::size_t subset = 0; subset < w.size(); ++subset) {
            Symbol term = w[subset];
            for (std::size_t i = 0; i < degree; ++i) term *= (subset >> i & 1) != 0 ? u[i] : mass[i];
            terms.push_back(term);
        }
        return sum(terms);
    }

    std::size_t degree;
    Variables variables;
    Symbols w;
};

/// Symmetry and a zero diagonal leave only the zero polynomial.
void check_unique(std::size_t n, bool homogeneous) {
    Multiaffine q(n);
    const Symbols u = q.variables.next(n);
    const Symbols mass = homogeneous ? q.variables.next(n) : Symbols(n, Symbol(1));
    const Symbol t = q.variables.next();
    const Symbol v = homogeneous ? q.variables.next() : Symbol(1);
    Symbols identities{q(Symbols(n, t), Symbols(n, v))};
    for (std::size_t i = 0; i + 1 < n; ++i) {
        Symbols swapped = u;
        Symbols swapped_mass = mass;
        std::swap(swapped[i], swapped[i + 1]);
        std::swap(swapped_mass[i], swapped_mass[i + 1]);
        identities.push_back(q(u, mass) - q(swapped, swapped_mass));
    }
    CHECK(rank_of_conditions(identities, q.w.size()) == q.w.size());
    // Without symmetry there are others.
    CHECK((n == 1 || rank_of_conditions({identities[0]}, q.w.size()) < q.w.size()));
}

}  // namespace

TEST_CASE("goldman-thm5", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) check_unique(n, false);
}

TEST_CASE("derose-thm1-unique", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) check_unique(n, false);
}

TEST_CASE("goldman-hunique", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) check_unique(n, true);
}

TEST_CASE("goldman-ex-1", "[statement]") {
    for (std::size_t n = 0; n <= 6; ++n) {
        Variables variables;
        const Symbols c = variables.next(n + 1), d = variables.next(n + 1);
        const Symbol factor = variables.next();
        const SymbolicArguments u = points(variables.next(n));
        Symbols added;
        Symbols multiplied;
        for (std::size_t k = 0; k <= n; ++k) {
            added.push_back(c[k] + d[k]);
            multiplied.push_back(factor * c[k]);
        }
        CHECK(by_symmetric_functions(added, u) ==
              by_symmetric_functions(c, u) + by_symmetric_functions(d, u));
        CHECK(by_symmetric_functions(multiplied, u) == factor * by_symmetric_functions(c, u));
    }
}

TEST_CASE("goldman-ex-2", "[statement]") {
    for (std::size_t n = 0; n <= 6; ++n) {
        Variables variables;
        const Symbol a = variables.next();
        const Symbols u = variables.next(n);
        Symbols coefficients;
        Symbols factors;
        for (std::size_t k = 0; k <= n; ++k) coefficients.push_back(scaled(binomial(n, k), pow(-a, n - k)));
        for (const Symbol& argument : u) factors.push_back(argument - a);
        CHECK(by_symmetric_functions(coefficients, points(u)) == product(factors));
    }
}

TEST_CASE("goldman-ex-4", "[statement]") {
    // All 2^n coefficients are variables.
    for (std::size_t n = 1; n <= 4; ++n) {
        Multiaffine q(n);
        const Symbols u = q.variables.next(n);
        const Symbol alpha = q.variables.next(), v = q.variables.next();
        const Symbols masses(n, Symbol(1));
        for (std::size_t k = 0; k < n; ++k) {
            Symbols mean = u;
            Symbols other = u;
            mean[k] = (Symbol(1) - alpha) * u[k] + alpha * v;
            other[k] = v;
            CHECK(q(mean, masses) == (Symbol(1) - alpha) * q(u, masses) + alpha * q(other, masses));
        }
    }
}

TEST_CASE("goldman-ex-5", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        Multiaffine q(n);
        const Symbols u = q.variables.next(n), mass = q.variables.next(n);
        const Symbol a = q.variables.next(), b = q.variables.next(), x = q.variables.next(),
                     y = q.variables.next();
        for (std::size_t k = 0; k < n; ++k) {
            Symbols combined = u, combined_mass = mass, other = u, other_mass = mass;
            combined[k] = a * u[k] + b * x;
            combined_mass[k] = a * mass[k] + b * y;
            other[k] = x;
            other_mass[k] = y;
            CHECK(q(combined, combined_mass) == a * q(u, mass) + b * q(other, other_mass));
        }
    }
}
