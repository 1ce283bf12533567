// Curves and splines prepared to be evaluated at many parameters, with numbers that end where words do.

#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/core/spline/curve_values.hpp>

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

TEST_CASE("curve values: values that end where words do", "[differential]") {
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

TEST_CASE("spline values: knots and points that end where words do", "[differential]") {
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
