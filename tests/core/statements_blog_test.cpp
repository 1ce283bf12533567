// A web article on de Casteljau's algorithm and blossoms: its formulas.
//
// Control points and arguments are symbols: each case decides its statement for all of them, at the degrees
// that it names. Printed forms that do not hold are refuted before the corrected form is shown.

#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>
#include <numeric>

#include "support/map_generators.hpp"
#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Generic control points a_0..a_n, their blossom, and symbols beside them.
struct Generic {
    Variables variables;
    Symbols a;
    SymbolicBlossom blossom;
    Symbol t;

    explicit Generic(std::size_t n)
        : a(variables.next(n + 1)), blossom(SymbolicBlossom::of_control_points(a)), t(variables.next()) {}

    std::size_t degree() const { return a.size() - 1; }
    /// The blossom from the monomial coefficients of the curve, by symmetric functions: no recursion.
    Symbol direct(const SymbolicArguments& arguments) const {
        return by_symmetric_functions(
            constructions::local_monomial_from_bernstein(std::span<const Symbol>(a)), arguments);
    }
    Symbol curve(const Symbol& parameter) const { return bezier_value(a, 0, 1, parameter); }
};

/// The article's recursion: level r from level r - 1 with t_r.
std::vector<Symbols> recursion(const Symbols& a, const Symbols& t) {
    std::vector<Symbols> levels{a};
    for (const Symbol& parameter : t) {
        const Symbols& below = levels.back();
        Symbols level;
        for (std::size_t i = 0; i + 1 < below.size(); ++i) {
            level.push_back((1 - parameter) * below[i] + parameter * below[i + 1]);
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

}  // namespace

TEST_CASE(
    "blog-bezier-def: the Bernstein polynomials C(n,i) t^i (1-t)^(n-i) are a basis that sums to one, n = "
    "0..8",
    "[statement]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        const Generic g(n);
        Symbols terms;
        for (std::size_t i = 0; i <= n; ++i) {
            const Integer quotient = divide_exactly(factorial(n), factorial(i) * factorial(n - i));
            terms.push_back(scaled(quotient, g.a[i] * pow(g.t, i) * pow(1 - g.t, n - i)));
        }
        CHECK(sum(terms) == g.curve(g.t));
        CHECK(bezier_value(Symbols(n + 1, 1), 0, 1, g.t) == Symbol(1));
        // A basis: the combination that gives t^k exists for every k = 0..n.
        for (std::size_t k = 0; k <= n; ++k) {
            Symbols unit(n + 1, 0);
            unit[k] = 1;
            CHECK(bezier_value(end_values(SymbolicBlossom::of_coefficients(unit), 0, 1), 0, 1, g.t) ==
                  pow(g.t, k));
        }
    }
}

TEST_CASE(
    "blog-dimension: as printed the dimension is the degree; a planar cubic refutes it, any dimension will "
    "do",
    "[statement]") {
    const BezierCurve planar_cubic(std::vector<Coordinates>{{0, 0}, {0, 1}, {1, 1}, {1, 0}});
    CHECK(planar_cubic.degree() == 3);
    CHECK(planar_cubic.dimension() == 2);
    CHECK(evaluate(planar_cubic, Rational(1, 2)) == Coordinates{Rational(1, 2), Rational(3, 4)});
    for (std::size_t k = 1; k <= 6; ++k) {
        const BezierCurve line(std::vector<Coordinates>(2, Coordinates(k, 1)));
        CHECK(evaluate(line, Rational(1, 3)) == Coordinates(k, 1));
    }
}

TEST_CASE("blog-basis-eval: the basis functions evaluate C(t), random curves of degrees 0 to 8",
          "[statement]") {
    Random random(381);
    for (std::size_t i = 0; i < 90; ++i) {
        const std::size_t n = i % 9;
        BezierRecipe recipe = bezier_map(random, n, Size::any);
        const Rational t = number(random, Size::any);
        Coordinates expected(recipe.dimension());
        for (std::size_t k = 0; k <= n; ++k) {
            const Rational basis = Rational(binomial(n, k)) * pow(t, k) * pow(1 - t, n - k);
            for (std::size_t j = 0; j < expected.size(); ++j)
                expected[j] += basis * recipe.control_points[k][j];
        }
        CHECK(evaluate(BezierCurve(recipe.control_points), t) == expected);
    }
}

TEST_CASE("blog-decasteljau: the apex of the recursion with one t is C(t), n = 0..7", "[statement]") {
    for (std::size_t n = 0; n <= 7; ++n) {
        const Generic g(n);
        CHECK(recursion(g.a, Symbols(n, g.t)).back() == Symbols{g.curve(g.t)});
    }
}

TEST_CASE("blog-blossom-recursion: the apex of the recursion with t_1..t_n is the blossom, n = 0..5",
          "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        Generic g(n);
        const Symbols t = g.variables.next(n);
        CHECK(recursion(g.a, t).back().front() == g.direct(points(t)));
    }
}

TEST_CASE("blog-intermediate: a_i^r[t1..tr] = a_0^n[0^(n-r-i),1^i,t1..tr], n = 1..4, all r and i",
          "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        Generic g(n);
        const Symbols t = g.variables.next(n);
        const auto levels = recursion(g.a, t);
        for (std::size_t r = 0; r <= n; ++r) {
            REQUIRE(levels[r].size() == n - r + 1);
            const SymbolicArguments used(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(r));
            for (std::size_t i = 0; i + r <= n; ++i) {
                CHECK(levels[r][i] == g.direct(joined({runs(n - r - i, 0, i, 1), used})));
            }
        }
    }
}

TEST_CASE("blog-special-case: equal arguments give C(t), n = 0..7", "[statement]") {
    for (std::size_t n = 0; n <= 7; ++n) {
        const Generic g(n);
        CHECK(g.blossom(copies(n, g.t)) == g.curve(g.t));
    }
}

TEST_CASE("blog-symmetric: the recursion does not depend on the order, n = 1..4, adjacent transpositions",
          "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        Generic g(n);
        const Symbols t = g.variables.next(n);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            Symbols exchanged = t;
            std::swap(exchanged[i], exchanged[i + 1]);
            CHECK(recursion(g.a, exchanged).back() == recursion(g.a, t).back());
        }
    }
}

TEST_CASE(
    "blog-multiaffine: without b + c = 1 the sides differ by (b+c-1) a[0,..]; with it they agree, n = 1..4",
    "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        Generic g(n);
        const Symbols t = g.variables.next(n + 1);
        const Symbol b = g.variables.next();
        const Symbol c = g.variables.next();
        const SymbolicArguments rest(t.begin() + 2, t.end());
        const auto value = [&](const SymbolicArgument& first) { return g.blossom(joined({{first}, rest})); };
        const Symbol right = b * value(t[0]) + c * value(t[1]);
        CHECK(right - value(b * t[0] + c * t[1]) == (b + c - 1) * value(0));
        CHECK(value(b * t[0] + (1 - b) * t[1]) == b * value(t[0]) + (1 - b) * value(t[1]));
    }
    const auto one = SymbolicBlossom::of_control_points({1, 1});
    CHECK(one({2}) == Symbol(1));
    CHECK(one({1}) + one({1}) == Symbol(2));
}

TEST_CASE("blog-control-point: a_i is the value at n-i zeros and i ones, n = 0..8", "[statement]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        const Generic g(n);
        for (std::size_t i = 0; i <= n; ++i) CHECK(g.direct(runs(n - i, 0, i, 1)) == g.a[i]);
    }
}

TEST_CASE("blog-subcurve: the values at n-i copies of c and i of d control the curve on [c,d], n = 1..4",
          "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        Generic g(n);
        const Symbol c = g.variables.next();
        const Symbol d = g.variables.next();
        CHECK(bezier_value(end_values(g.blossom, c, d), c, d, g.t) == pow(d - c, n) * g.curve(g.t));
    }
}

TEST_CASE("blog-derivative: n a[t^(n-1),1] exceeds C' by n a[t^(n-1),0]; the vector delta is right, n = 1..6",
          "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        const Generic g(n);
        const Symbol slope = polynomial_value(
            derivative_coefficients(
                constructions::local_monomial_from_bernstein(std::span<const Symbol>(g.a)), 1),
            g.t);
        const auto with = [&](const SymbolicArgument& last) {
            return scaled(n, g.blossom(runs(n - 1, g.t, 1, last)));
        };
        CHECK(with(1) - slope == with(0));
        CHECK(with(symbolic_delta) == slope);
        // The defect is a curve of degree n - 1 with control points a_0..a_(n-1), so that it vanishes exactly
        // when they do.
        CHECK(with(0) == scaled(n, bezier_value(Symbols(g.a.begin(), g.a.end() - 1), 0, 1, g.t)));
    }
    CHECK(SymbolicBlossom::of_control_points({1, 1})({1}) == Symbol(1));
    const Symbol t = Symbol::variable(0);
    CHECK(2 * SymbolicBlossom::of_coefficients({1, 0, 1})({t, 1}) == 2 * (t + 1));
}

TEST_CASE(
    "blog-elevation: the sum over i = 1..n+1 is right; n + 2 terms would not reproduce constants, n = 0..5",
    "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        Generic g(n);
        const SymbolicArguments t = points(g.variables.next(n + 1));
        Symbols raised = constructions::local_monomial_from_bernstein(std::span<const Symbol>(g.a));
        raised.emplace_back(0);
        Symbol total;
        for (std::size_t i = 0; i <= n; ++i) total += g.blossom(without(t, i));
        CHECK(total * fraction(1, n + 1) == by_symmetric_functions(raised, t));
        // There is no t_0; whichever argument the term for i = 0 omits, for C = 1 the n + 2 terms give (n +
        // 2) / (n + 1).
        const auto one = SymbolicBlossom::of_control_points(Symbols(n + 1, 1));
        for (std::size_t omitted = 0; omitted <= n; ++omitted) {
            Symbol printed = one(without(t, omitted));
            for (std::size_t i = 0; i <= n; ++i) printed += one(without(t, i));
            CHECK(printed * fraction(1, n + 1) == fraction(n + 2, n + 1));
        }
    }
}

TEST_CASE(
    "blog-elevated-points: the value at n+1-i zeros and i ones is i/(n+1) a_(i-1) + (n+1-i)/(n+1) a_i, n = "
    "0..6",
    "[statement]") {
    for (std::size_t n = 0; n <= 6; ++n) {
        const Generic g(n);
        Symbols raised = constructions::local_monomial_from_bernstein(std::span<const Symbol>(g.a));
        raised.emplace_back(0);
        for (std::size_t i = 0; i <= n + 1; ++i) {
            const Symbol before = i > 0 ? g.a[i - 1] : Symbol(0);
            const Symbol at = i <= n ? g.a[i] : Symbol(0);
            CHECK(by_symmetric_functions(raised, runs(n + 1 - i, 0, i, 1)) ==
                  before * fraction(i, n + 1) + at * fraction(n + 1 - i, n + 1));
        }
    }
}

TEST_CASE("blog-unique-form: the blossom is unique for each formal degree, and another for each, D = 1..4",
          "[statement]") {
    // The mean over all permutations of a generic multiaffine map is the blossom of its diagonal: a symmetric
    // one is its own mean.
    for (std::size_t n = 1; n <= 4; ++n) {
        Variables variables;
        const Symbols x = variables.next(std::size_t{1} << n);
        Symbols u = variables.next(n);
        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), std::size_t{0});
        Symbols values;
        Symbols diagonal(n + 1, 0);
        do {
            for (std::size_t subset = 0; subset < x.size(); ++subset) {
                Symbol term = x[subset];
                for (std::size_t i = 0; i < n; ++i) {
                    if ((subset >> i & 1) != 0) term *= u[order[i]];
                }
                values.push_back(std::move(term));
            }
        } while (std::ranges::next_permutation(order).found);
        for (std::size_t subset = 0; subset < x.size(); ++subset) {
            diagonal[static_cast<std::size_t>(std::popcount(subset))] += x[subset];
        }
        CHECK(sum(values) * fraction(1, factorial(n)) == by_symmetric_functions(diagonal, points(u)));
    }
    const Symbol u1 = Symbol::variable(0);
    const Symbol u2 = Symbol::variable(1);
    CHECK(by_symmetric_functions({0, 1}, {u1}) == u1);
    CHECK(by_symmetric_functions({0, 1, 0}, {u1, u2}) == (u1 + u2) * fraction(1, 2));
}

TEST_CASE("blog-quadratic-form: equating on the diagonal gives c1 = c1' + c2' and c2 = c3', not halves",
          "[statement]") {
    Variables variables;
    const Symbols c = variables.next(4);
    const Symbol t = variables.next();
    const auto a = [&](const Symbol& t1, const Symbol& t2) {
        return c[0] + c[1] * t1 + c[2] * t2 + c[3] * t1 * t2;
    };
    CHECK(a(t, t) == polynomial_value({c[0], c[1] + c[2], c[3]}, t));
    CHECK(a(t, t) != polynomial_value({c[0], (c[1] + c[2]) * fraction(1, 2), c[3]}, t));
    // Symmetry leaves c1' = c2' = c1 / 2.
    const Symbol t1 = variables.next();
    const Symbol t2 = variables.next();
    CHECK(a(t1, t2) - a(t2, t1) == (c[1] - c[2]) * (t1 - t2));
}
