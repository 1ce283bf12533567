// Curves and splines prepared to be evaluated at many parameters, with numbers that end where words do.

#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/spline/curve_values.hpp>

#include "each_case.hpp"
#include "support/horner.hpp"
#include "support/spline_generators.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

Rational rational_near(Random& random, std::size_t bits, std::size_t denominator_bits) {
    return {number_near(random, bits), abs(number_near(random, denominator_bits)) + 1};
}

}  // namespace

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
