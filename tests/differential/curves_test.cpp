// Curves and splines prepared for evaluation at many parameters, with numbers near the limits of words.

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/curve_values.hpp>
#include <blossom/core/spline/progressive.hpp>

#include "each_case.hpp"
#include "support/horner.hpp"
#include "support/map_generators.hpp"
#include "support/spline_generators.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

Rational rational_near(Random& random, std::size_t bits, std::size_t denominator_bits) {
    return {number_near(random, bits), abs(number_near(random, denominator_bits)) + 1};
}

/// f(arguments) for the values over 2n knots, by the plain triangle.
Coordinates value_of(std::span<const Rational> knots, std::span<const Coordinates> points,
                     const std::vector<Argument>& arguments) {
    const PointArray values(points);
    std::vector<HomogeneousPair<Integer>> pairs;
    Integer denominator = values.denominator();
    for (const Argument& argument : arguments) {
        const Integer cleared = lcm(argument.u.denominator(), argument.mass.denominator());
        pairs.push_back({(argument.u * cleared).numerator(), (argument.mass * cleared).numerator()});
        denominator *= cleared;
    }
    const auto rows = values.rows();
    const auto value = constructions::by_progressive_values<Integer>(rows, knots, pairs);
    Coordinates point;
    for (const Integer& numerator : value.numerators)
        point.emplace_back(numerator, value.denominator * denominator);
    return point;
}

/// f(a^(n-k), b^k) over the knots of a span, each by a triangle of its own.
std::vector<Coordinates> segment_points(const KnotVector& knots, std::size_t span,
                                        std::span<const Coordinates> points) {
    const std::size_t n = knots.degree();
    std::vector<Coordinates> result;
    for (std::size_t k = 0; k <= n; ++k) {
        result.push_back(value_of(
            knots.around(span), points,
            with_copies(with_copies({}, n - k, Parameter(knots[span])), k, Parameter(knots[span + 1]))));
    }
    return result;
}

/// n + 1 points in dimension 1: all 0 but one.
std::vector<Coordinates> unit_points(std::size_t n, std::size_t one) {
    std::vector<Coordinates> points(n + 1, Coordinates(1));
    points[one].front() = 1;
    return points;
}

/// A spline whose knots are random, evenly spaced, or of many bits.
BSplineCurve uneven_spline(Random& random) {
    SplineRecipe recipe = spline(random, random.below(random.one_in(8) ? 16 : 7));
    const std::size_t kind = random.below(3);
    const Rational scale = abs(rational_near(random, 1 + random.below(70), 1 + random.below(70))) + 1;
    for (std::size_t i = 0; i < recipe.knots.size(); ++i) {
        if (kind == 1) recipe.knots[i] = i;
        if (kind == 2) recipe.knots[i] = recipe.knots[i] * scale + scale / 3;
    }
    return recipe.curve();
}

/// The integral of a b (s (1 - s))^k over [0, 1].
Rational inner_product(const Polynomial& a, const Polynomial& b, std::size_t k) {
    const Polynomial s = Polynomial::monomial(1);
    const Polynomial product = a * b * pow(s - s * s, k);
    Rational sum;
    for (std::size_t i = 0; i <= product.degree(); ++i) sum += product[i] / Rational(i + 1);
    return sum;
}

/// By the monic orthogonal polynomials: Q_{j+1} = (s - 1/2) Q_j - (|Q_j|^2 / |Q_{j-1}|^2) Q_{j-1}.
Polynomial projected(const Polynomial& polynomial, std::size_t m, std::size_t k) {
    const Polynomial step = Polynomial::monomial(1) - Polynomial(Rational(1, 2));
    Polynomial previous;
    Polynomial current = 1;
    Rational previous_norm = 1;
    Polynomial projection;
    for (std::size_t j = 0; j <= m; ++j) {
        const Rational norm = inner_product(current, current, k);
        projection += Polynomial(inner_product(polynomial, current, k) / norm) * current;
        Polynomial next = step * current - Polynomial(norm / previous_norm) * previous;
        previous = std::move(current);
        current = std::move(next);
        previous_norm = norm;
    }
    return projection;
}

}  // namespace

TEST_CASE("segments: two triangles for all control points, and one for each", "[differential]") {
    each_case("segments", [&](Random& random) {
        const BSplineCurve curve = uneven_spline(random);
        const std::vector<std::size_t> spans = curve.knots().spans();
        const std::size_t span = spans[random.below(spans.size())];
        CHECK(sablonniere(curve, span).control_points().to_points() ==
              segment_points(curve.knots(), span, curve.points_of(span)));
        const Rational t = parameter(random, curve.knots());
        const std::size_t around = curve.knots().span_at(t);
        const ProgressiveCurve segment(
            std::vector<Rational>(curve.knots().around(around).begin(), curve.knots().around(around).end()),
            curve.points_of(around));
        std::vector<Argument> arguments;
        for (std::size_t i = 0; i < curve.degree(); ++i) {
            arguments.push_back(random.one_in(3)
                                    ? Argument(rational_near(random, 8, 8), rational_near(random, 8, 8))
                                    : Argument(Parameter(parameter(random, curve.knots()))));
        }
        CHECK(blossom_value(segment, arguments) ==
              value_of(curve.knots().around(around), curve.points_of(around), arguments));
    });
}

TEST_CASE("basis functions: by divided differences and by unit control points", "[differential]") {
    each_case("basis functions", [&](Random& random) {
        const KnotVector knots = uneven_spline(random).knots();
        const std::size_t n = knots.degree();
        const std::size_t point = random.below(knots.points());
        std::size_t pieces = 0;
        for (const std::size_t span : knots.spans()) {
            const std::size_t first = knots.first_point(span);
            if (point < first || point > first + n) continue;
            const Interval interval(knots[span], knots[span + 1]);
            const BezierCurve unit(segment_points(knots, span, unit_points(n, point - first)), interval);
            const auto function = basis_function(knots, point);
            REQUIRE(pieces < function.size());
            CHECK(function[pieces].span == span);
            CHECK(function[pieces].interval == interval);
            CHECK(function[pieces].polynomial == Polynomial(monomial_form(unit).coefficients().numbers()));
            ++pieces;
        }
        CHECK(basis_function(knots, point).size() == pieces);

        const Rational t = parameter(random, knots);
        const BasisValues values = basis_values(knots, t);
        const std::size_t span = knots.span_at(t);
        CHECK(values.first_point == knots.first_point(span));
        for (std::size_t i = 0; i <= n; ++i) {
            CHECK(values.values[i] ==
                  value_of(knots.around(span), unit_points(n, i), with_copies({}, n, Parameter(t)))[0]);
        }
    });
}

TEST_CASE("projection: by orthogonal polynomials from below and from above", "[differential]") {
    each_case("projection", [&](Random& random) {
        const std::size_t n = random.below(random.one_in(8) ? 24 : 10);
        const Polynomial given = polynomial(random, n, random.one_in(4) ? Size::any : Size::small);
        const std::size_t m = random.below(n + 2);
        const std::size_t k = random.below(4);
        CHECK(project(given, m, k) == projected(given, m, k));
    });
}

TEST_CASE("reduction by the inverse formula: from values at its nodes", "[differential]") {
    each_case("reduction by the inverse formula", [&](Random& random) {
        const std::size_t n = random.below(random.one_in(8) ? 20 : 9);
        const std::size_t m = random.one_in(2) ? n - std::min<std::size_t>(n, 1) : random.below(n + 1);
        const BezierCurve curve = bezier_map(random, n, random.one_in(4) ? Size::any : Size::small).curve();
        const auto value = [&](const Rational& t) { return evaluate(curve, t); };
        CHECK(reduce(curve, m, ReductionMethod::inverse_formula).curve ==
              control_points_from_values(m, curve.interval(), value));
    });
}

TEST_CASE("curve values: values near the limits of words", "[differential]") {
    each_case("curve values", [&](Random& random) {
        const std::size_t limits[] = {63, 127, 256, 512};
        const std::size_t limit = limits[random.below(4)];
        const std::size_t n = random.below(13);
        const std::size_t t_bits = std::min<std::size_t>(1 + random.below(limit / (n + 1) + 1), 63);
        const std::size_t bits = limit + 4 - std::min(limit + 3, n * t_bits + random.below(8));
        const Integer denominator = random.one_in(2) ? Integer(1) : abs(number_near(random, 20)) + 1;
        std::vector<Rational> coefficients;
        std::vector<Coordinates> points;
        for (std::size_t k = 0; k <= n; ++k) {
            coefficients.emplace_back(number_near(random, bits), denominator);
            points.push_back({coefficients.back()});
        }
        std::vector<Rational> parameters;
        for (std::size_t i = 1 + random.below(12); i > 0; --i)
            parameters.push_back(rational_near(random, t_bits, t_bits));
        const CurveValues curve{PolynomialCurve(points)};
        const std::vector<Rational> values = curve.at(parameters);
        REQUIRE(values.size() == parameters.size());
        for (std::size_t i = 0; i < parameters.size(); ++i)
            CHECK(values[i] == horner_value(coefficients, parameters[i]));
    });
}

TEST_CASE("spline values: knots and points near the limits of words", "[differential]") {
    each_case("spline values", [&](Random& random) {
        SplineRecipe recipe = spline(random, random.below(5));
        const std::size_t bits = random.below(random.one_in(4) ? 62 : 20);
        const std::size_t denominator_bits = random.below(12);
        Rational scale = abs(rational_near(random, bits, denominator_bits));
        if (scale.is_zero()) scale = 1;
        const Rational shift = rational_near(random, bits, denominator_bits);
        for (Rational& knot : recipe.knots) knot = knot * scale + shift;
        for (Coordinates& point : recipe.points)
            for (Rational& number : point) number *= rational_near(random, bits, denominator_bits);
        const BSplineCurve curve = recipe.curve();
        const SplineValues values(curve);
        const textbook::Spline expected = recipe.oracle();
        std::vector<Rational> parameters;
        for (int i = 0; i < 4; ++i) parameters.push_back(parameter(random, curve.knots()));
        const std::vector<Rational> batch = values.at(parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const Coordinates value = textbook::value(expected, parameters[i]);
            CHECK(values(parameters[i]) == value);
            const auto place = batch.begin() + static_cast<std::ptrdiff_t>(i * values.dimension());
            CHECK(std::equal(value.begin(), value.end(), place));
        }
    });
}

TEST_CASE("subdivision: control points of both parts by de Casteljau's steps", "[differential]") {
    each_case("subdivision", [&](Random& random) {
        const std::size_t n = random.below(14);
        const std::size_t dimension = 1 + random.below(3);
        const std::size_t bits = random.below(80);
        const std::size_t t_bits = 1 + random.below(random.one_in(4) ? 70 : 20);
        std::vector<Coordinates> points(n + 1, Coordinates(dimension));
        for (Coordinates& point : points) {
            for (Rational& coordinate : point) coordinate = rational_near(random, bits, random.below(30));
        }
        const Rational a = rational_near(random, 8, 4);
        const Rational b = a + 1 + abs(rational_near(random, 8, 4));
        const Rational t = rational_near(random, t_bits, t_bits);
        if (t == a || t == b) return;

        std::vector<Coordinates> left, right, level = points;
        while (true) {
            left.push_back(level.front());
            right.insert(right.begin(), level.back());
            if (level.size() == 1) break;
            for (std::size_t j = 0; j + 1 < level.size(); ++j) {
                for (std::size_t c = 0; c < dimension; ++c)
                    level[j][c] = ((b - t) * level[j][c] + (t - a) * level[j + 1][c]) / (b - a);
            }
            level.pop_back();
        }
        const auto halves = subdivide(BezierCurve(points, {a, b}), t);
        CHECK(halves.first == BezierCurve(left, {a, t}));
        CHECK(halves.second == BezierCurve(right, {t, b}));
    });
}
