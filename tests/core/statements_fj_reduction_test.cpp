#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/rational/number_text.hpp>
#include "core_test.hpp"

#include "support/chebyshev_identity.hpp"
#include "support/reference_maps.hpp"

// Fernandez-Jambrina: Inverse Relations for Blossoms and Parametrisations of Rational Curves and Surfaces
// (2024), section 4: degree reduction, with example 2 exactly. Random curves are seeded; everything is
// decided in exact arithmetic.

namespace {

Rational r(int p, int q) { return {p, q}; }

BezierCurve example2() { return control_points(PolynomialCurve(degree_ten_curve()), {}); }

/// Example 2 by one method, with its error from the integral of the expanded polynomials.
struct Reduced {
    BezierCurve curve;
    Rational squared_error;

    explicit Reduced(ReductionMethod method) : curve(reduce(example2(), 6, method).curve) {
        const std::vector<Polynomial> approximation = expanded(curve);
        const std::vector<Polynomial> original = degree_ten_curve();
        for (std::size_t j = 0; j < 2; ++j) {
            const Polynomial lost = original[j] - approximation[j];
            squared_error += integral(lost * lost);
        }
        CHECK(reduce(example2(), 6, method).l2_squared == squared_error);
    }

    bool keeps_ends() const {
        return curve.control_points()[0] == Coordinates{-3, 0} &&
               curve.control_points()[6] == Coordinates{-2, 1};
    }
    /// The sum of the absolute k-th differences of one coordinate of the control polygon.
    Rational oscillation(std::size_t coordinate, std::size_t order) const {
        std::vector<Rational> values;
        for (const Coordinates& point : curve.control_points().to_points())
            values.push_back(point[coordinate]);
        for (std::size_t k = 0; k < order; ++k) {
            for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i] = values[i + 1] - values[i];
            values.pop_back();
        }
        Rational sum;
        for (const Rational& value : values) sum += abs(value);
        return sum;
    }
};

/// Column j of degree raising from m to n: the vertices of degree n of B_j^m.
std::vector<Rational> raised_basis(std::size_t m, std::size_t n, std::size_t j) {
    std::vector<Rational> column;
    for (std::size_t i = 0; i <= n; ++i) {
        column.push_back(i < j ? Rational()
                               : Rational(binomial(m, j) * binomial(n - m, i - j), binomial(n, i)));
    }
    return column;
}

/// The solution x of A x = b for an invertible matrix, by elimination.
std::vector<Rational> solution(std::vector<std::vector<Rational>> a, std::vector<Rational> b) {
    const std::size_t n = b.size();
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        while (a[pivot][column].is_zero()) ++pivot;
        std::swap(a[pivot], a[column]);
        std::swap(b[pivot], b[column]);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == column) continue;
            const Rational factor = a[i][column] / a[column][column];
            for (std::size_t k = column; k < n; ++k) a[i][k] -= factor * a[column][k];
            b[i] -= factor * b[column];
        }
    }
    for (std::size_t i = 0; i < n; ++i) b[i] /= a[i][i];
    return b;
}

Polynomial bernstein(std::size_t m, std::size_t i) {
    const Polynomial t = Polynomial::monomial(1);
    return Polynomial(Rational(binomial(m, i))) * pow(t, i) * pow(Polynomial(1) - t, m - i);
}

}  // namespace

TEST_CASE(
    "fj-ex2-reduction: the squared errors to degree 6, exactly; (b) < (c) < (a), and (a) and (c) keep the "
    "ends",
    "[statement]") {
    const Reduced a(ReductionMethod::inverse_formula);
    const Reduced b(ReductionMethod::least_squares);
    const Reduced c(ReductionMethod::least_squares_endpoints);
    CHECK(a.squared_error == parse_rational("1388556891384443659/15640084338278400000000"));
    CHECK(b.squared_error == parse_rational("154371277/33955122801600"));
    CHECK(c.squared_error == parse_rational("1283489/161691060960"));
    // In the first six digits 8.87819e-5, 4.54633e-6 and 7.93791e-6.
    CHECK(abs(a.squared_error - parse_rational("8.87819e-5")) < parse_rational("5e-11"));
    CHECK(abs(b.squared_error - parse_rational("4.54633e-6")) < parse_rational("5e-12"));
    CHECK(abs(c.squared_error - parse_rational("7.93791e-6")) < parse_rational("5e-12"));
    CHECK(b.squared_error < c.squared_error);
    CHECK(c.squared_error < a.squared_error);
    CHECK(a.keeps_ends());
    CHECK_FALSE(b.keeps_ends());
    CHECK(c.keeps_ends());
}

TEST_CASE(
    "fj-ex2-oscillation: the polygon of the inverse formula has the least total variation and second "
    "differences",
    "[statement]") {
    const Reduced a(ReductionMethod::inverse_formula);
    const Reduced b(ReductionMethod::least_squares);
    const Reduced c(ReductionMethod::least_squares_endpoints);
    for (std::size_t coordinate = 0; coordinate < 2; ++coordinate) {
        for (std::size_t order = 1; order <= 2; ++order) {
            CHECK(a.oscillation(coordinate, order) < b.oscillation(coordinate, order));
            CHECK(a.oscillation(coordinate, order) < c.oscillation(coordinate, order));
        }
    }
    CHECK(a.oscillation(0, 1) == parse_rational("87069473/51840000"));
    CHECK(b.oscillation(0, 1) == parse_rational("188528/109395"));
    CHECK(c.oscillation(0, 1) == parse_rational("4525/2652"));
}

TEST_CASE(
    "fj-chebyshev: b - a_n 2^(1-2n) T_n(2t-1) is the best uniform approximation by one degree, n = 2..7",
    "[statement]") {
    Random random(411);
    for (std::size_t n = 2; n <= 7; ++n) {
        REQUIRE(is_chebyshev(chebyshev_on_unit_interval(n), n, 1));
        for (int i = 0; i < 10; ++i) {
            const Polynomial b =
                polynomial(random, n - 1, Size::any) + Polynomial::monomial(n) * Polynomial(1 + i);
            const Reduction reduction =
                reduce(control_points(PolynomialCurve(b), {}), n - 1, ReductionMethod::uniform);
            const Rational factor = b[n] / pow(Rational(2), 2 * n - 1);
            const Polynomial expected = b - Polynomial(factor) * chebyshev_on_unit_interval(n);
            CHECK(expected.degree() < n);
            CHECK(expanded(reduction.curve) == std::vector<Polynomial>{expected});
            CHECK(reduction.maximum == Coordinates{abs(factor)});
            CHECK(is_chebyshev(b - expected, n, factor));
        }
    }
}

TEST_CASE(
    "fj-dual-bernstein: vertex i of least squares is the integral of b D_i, D_i dual to B_i^m, m = 1..4",
    "[statement]") {
    Random random(412);
    for (std::size_t m = 1; m <= 4; ++m) {
        std::vector<std::vector<Rational>> gram(m + 1, std::vector<Rational>(m + 1));
        for (std::size_t i = 0; i <= m; ++i) {
            for (std::size_t j = 0; j <= m; ++j) gram[i][j] = integral(bernstein(m, i) * bernstein(m, j));
        }
        std::vector<Polynomial> dual;
        for (std::size_t i = 0; i <= m; ++i) {
            std::vector<Rational> unit(m + 1);
            unit[i] = 1;
            const std::vector<Rational> combination = solution(gram, unit);
            Polynomial& element = dual.emplace_back();
            for (std::size_t j = 0; j <= m; ++j) element += Polynomial(combination[j]) * bernstein(m, j);
            for (std::size_t j = 0; j <= m; ++j)
                CHECK(integral(element * bernstein(m, j)) == (i == j ? 1 : 0));
        }
        for (int repeat = 0; repeat < 10; ++repeat) {
            const Polynomial b = polynomial(random, m + 2, Size::any);
            const Reduction reduction =
                reduce(control_points(PolynomialCurve(b, m + 2), {}), m, ReductionMethod::least_squares);
            for (std::size_t i = 0; i <= m; ++i) {
                CHECK(reduction.curve.control_points()[i] == Coordinates{integral(b * dual[i])});
            }
        }
    }
}

TEST_CASE("fj-uniform-norm: the p-th power of the p-norm is a rational integral for even p", "[statement]") {
    const Polynomial lost = univariate("t^2 - t + 1/6");
    CHECK(integral_over_unit_interval(lost * lost) == r(1, 180));
    CHECK(integral_over_unit_interval(pow(lost, 4)) == integral(pow(lost, 4)));
    const Reduction reduction = reduce(control_points(PolynomialCurve(Polynomial::monomial(2)), {}), 1,
                                       ReductionMethod::least_squares);
    CHECK(expanded(reduction.curve) == std::vector<Polynomial>{univariate("t - 1/6")});
    CHECK(reduction.l2_squared == r(1, 180));
}

TEST_CASE("fj-lutterkort: least squares in L2 is the best Euclidean approximation by raised polygons, n <= 7",
          "[statement]") {
    Random random(413);
    for (std::size_t i = 0; i < 160; ++i) {
        const std::size_t n = 1 + i % 7;
        const std::size_t m = random.below(n);
        const BezierCurve curve = bezier_map(random, n, i % 4 == 0 ? Size::any : Size::small).curve();
        const auto given = curve.control_points().to_points();
        const auto reduced =
            reduce(curve, m, ReductionMethod::least_squares).curve.control_points().to_points();
        CAPTURE(i, n, m);
        // The normal equations: the difference of the polygons is orthogonal to every raised polygon.
        std::vector<Coordinates> difference = given;
        for (std::size_t j = 0; j <= m; ++j) {
            const std::vector<Rational> column = raised_basis(m, n, j);
            for (std::size_t k = 0; k <= n; ++k) {
                for (std::size_t d = 0; d < curve.dimension(); ++d)
                    difference[k][d] -= column[k] * reduced[j][d];
            }
        }
        for (std::size_t j = 0; j <= m; ++j) {
            const std::vector<Rational> column = raised_basis(m, n, j);
            for (std::size_t d = 0; d < curve.dimension(); ++d) {
                Rational product;
                for (std::size_t k = 0; k <= n; ++k) product += column[k] * difference[k][d];
                CHECK(product == 0);
            }
        }
    }
}

TEST_CASE("fj-lutterkort with fixed ends: the plain Euclidean version fails, for t^4 to degree 2",
          "[statement]") {
    const BezierCurve curve = control_points(PolynomialCurve(Polynomial::monomial(4)), {});
    const BezierCurve reduced = reduce(curve, 2, ReductionMethod::least_squares_endpoints).curve;
    Rational product;
    for (std::size_t k = 0; k <= 4; ++k) {
        Rational difference = curve.control_points()[k][0];
        for (std::size_t j = 0; j <= 2; ++j)
            difference -= raised_basis(2, 4, j)[k] * reduced.control_points()[j][0];
        product += raised_basis(2, 4, 1)[k] * difference;
    }
    CHECK(product != 0);
}

TEST_CASE("fj-l2-endpoints: least squares of t^3 to degree 1 misses both ends unless they are imposed",
          "[statement]") {
    const BezierCurve cube = control_points(PolynomialCurve(Polynomial::monomial(3)), {});
    const BezierCurve free = reduce(cube, 1, ReductionMethod::least_squares).curve;
    CHECK(expanded(free) == std::vector<Polynomial>{univariate("9/10t - 1/5")});
    CHECK(free.control_points()[0] != cube.control_points()[0]);
    CHECK(free.control_points()[1] != cube.control_points()[3]);
    CHECK(expanded(reduce(cube, 1, ReductionMethod::least_squares_endpoints).curve) ==
          std::vector<Polynomial>{univariate("t")});
}
