#include <blossom/core/spline/progressive.hpp>
#include "core_test.hpp"

namespace {

using Symbol = SparsePolynomial;

Symbol variable(std::size_t index) { return SparsePolynomial::variable(index); }

/// The blossom sum_k c_k e_k(arguments) of a polynomial sum_k C(n, k) c_k t^k.
Symbol symbolic_blossom(std::span<const Symbol> normalised, std::span<const Symbol> arguments) {
    std::vector<Symbol> elementary{1};
    for (const Symbol& argument : arguments) {
        elementary.emplace_back();
        for (std::size_t k = elementary.size() - 1; k > 0; --k) elementary[k] += elementary[k - 1] * argument;
    }
    Symbol value;
    for (std::size_t k = 0; k < normalised.size(); ++k) value += normalised[k] * elementary[k];
    return value;
}

/// Knots, in no particular order, over which progressive values determine a map.
std::vector<Rational> legal_knots(Random& random, std::size_t n) {
    while (true) {
        std::vector<Rational> knots;
        for (std::size_t i = 0; i < 2 * n; ++i) {
            knots.push_back(!knots.empty() && random.one_in(4) ? knots[random.below(knots.size())]
                                                               : small_rational(random));
        }
        bool legal = true;
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t l = 0; l <= j; ++l) legal = legal && knots[j] != knots[n + l];
        }
        if (legal) return knots;
    }
}

/// Whether the n + 1 functionals P -> p(t_j, ..., t_(j+n-1)) are independent, by Gaussian elimination on
/// their values at the monomials.
bool independent(std::span<const Rational> knots, std::size_t n) {
    std::vector<std::vector<Rational>> rows;
    for (std::size_t j = 0; j <= n; ++j) {
        std::vector<Rational> elementary{1};
        for (const Rational& knot : knots.subspan(j, n)) {
            elementary.emplace_back();
            for (std::size_t k = elementary.size() - 1; k > 0; --k) elementary[k] += elementary[k - 1] * knot;
        }
        rows.push_back(elementary);
    }
    for (std::size_t column = 0; column <= n; ++column) {
        const auto pivot =
            std::ranges::find_if(rows.begin() + static_cast<std::ptrdiff_t>(column), rows.end(),
                                 [&](const auto& row) { return !row[column].is_zero(); });
        if (pivot == rows.end()) return false;
        std::swap(rows[column], *pivot);
        for (std::size_t i = column + 1; i <= n; ++i) {
            const Rational factor = rows[i][column] / rows[column][column];
            for (std::size_t k = column; k <= n; ++k) rows[i][k] -= factor * rows[column][k];
        }
    }
    return true;
}

}  // namespace

TEST_CASE("derose-fig10: the engine's triangle gives the blossom for all arguments and all maps",
          "[progressive][derose]") {
    Random random(11);
    for (std::size_t n = 0; n <= 4; ++n) {
        for (int round = 0; round < 5; ++round) {
            const std::vector<Rational> knots = legal_knots(random, n);
            std::vector<Symbol> coefficients;
            for (std::size_t k = 0; k <= n; ++k) coefficients.push_back(variable(k));
            std::vector<Symbol> values;
            for (std::size_t j = 0; j <= n; ++j) {
                std::vector<Symbol> at;
                for (std::size_t i = j; i < j + n; ++i) at.emplace_back(knots[i]);
                values.push_back(symbolic_blossom(coefficients, at));
            }
            std::vector<HomogeneousPair<Symbol>> pairs;
            std::vector<Symbol> points;
            for (std::size_t i = 0; i < n; ++i) {
                points.push_back(variable(n + 1 + i));
                pairs.push_back({points.back(), 1});
            }
            const std::vector<std::span<const Symbol>> rows{values};
            const auto value = constructions::by_progressive_values<Symbol>(rows, knots, pairs);
            CHECK(value.numerators.front() ==
                  symbolic_blossom(coefficients, points) * Symbol(value.denominator));
        }
    }
}

TEST_CASE(
    "derose-fig10-comment1, derose-fig10-comment2: every entry of the triangle is the blossom value of its "
    "knots",
    "[progressive][derose]") {
    Random random(12);
    for (int round = 0; round < 60; ++round) {
        const std::size_t n = 1 + random.below(5);
        const std::vector<Rational> knots = legal_knots(random, n);
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::small);
        const Blossom blossom(recipe.curve());
        const ProgressiveCurve curve = progressive_form(recipe.curve(), knots);
        std::vector<std::vector<Integer>> rows;
        for (const auto row : curve.control_points().rows()) rows.emplace_back(row.begin(), row.end());
        constructions::ProgressiveTriangle<Integer> triangle(rows, knots);
        std::vector<Argument> asked;
        for (std::size_t k = 0; k <= n; ++k) {
            for (std::size_t l = 0; l + k <= n; ++l) {
                std::vector<Argument> at = asked;
                for (std::size_t i = k + l; at.size() < n; ++i) at.emplace_back(Parameter(knots[i]));
                const auto entry = triangle.entry(l);
                Coordinates value;
                for (const Integer& numerator : entry.numerators) {
                    value.emplace_back(numerator, entry.denominator * curve.control_points().denominator());
                }
                CHECK(value == blossom(at));
            }
            if (k == n) break;
            const Integer u(random.between(-9, 9));
            asked.emplace_back(Parameter(Rational(u)));
            triangle.descend({u, 1});
        }
    }
}

TEST_CASE(
    "derose-46-progressive: progressive values determine a map exactly when no two knots of the triangle are "
    "equal",
    "[progressive][derose]") {
    Random random(13);
    std::size_t legal = 0;
    std::size_t illegal = 0;
    for (int round = 0; round < 600; ++round) {
        const std::size_t n = 1 + random.below(5);
        std::vector<Rational> knots;
        for (std::size_t i = 0; i < 2 * n; ++i)
            knots.emplace_back(random.between(0, static_cast<std::int64_t>(4 * n)));
        const auto refused =
            failure([&] { ProgressiveCurve(knots, std::vector<Coordinates>(n + 1, Coordinates{1})); });
        CHECK(!refused == independent(knots, n));
        ++(refused ? illegal : legal);
        if (refused) CHECK(refused->code() == ErrorCode::bad_knots);
    }
    CHECK(legal > 100);
    CHECK(illegal > 100);
    const auto refused =
        failure([] { ProgressiveCurve({0, 2, 2, 3}, std::vector<Coordinates>{{0}, {1}, {2}}); });
    REQUIRE(refused);
    CHECK(refused->message() ==
          "knots 1 and 2 are equal (2); progressive values determine a map only if knots j and n + l differ "
          "for l <= j < n = 2");
    CHECK(refused->place() == Part::knots / 2);
}

TEST_CASE("derose-progressive-vij: a map comes back from its progressive values, over knots in any order",
          "[progressive][derose]") {
    Random random(14);
    for (int round = 0; round < 200; ++round) {
        const std::size_t n = random.below(7);
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::small);
        const PolynomialCurve curve = recipe.curve();
        const ProgressiveCurve progressive = progressive_form(curve, legal_knots(random, n));
        const std::vector<Argument> asked = arguments(random, n, Size::small);
        CHECK(blossom_value(progressive, asked) == Blossom(curve)(asked));
        CHECK(monomial_form(control_points(progressive, interval(random, Size::small))) == curve);
    }
}

TEST_CASE(
    "derose-46-bezier-progressive: control points over [s, t] are the progressive values over (s^n, t^n)",
    "[progressive][derose]") {
    Random random(15);
    for (int round = 0; round < 100; ++round) {
        const BezierCurve curve = bezier_map(random, random.below(6), Size::small).curve();
        std::vector<Rational> knots(curve.degree(), curve.interval().a());
        knots.resize(2 * curve.degree(), curve.interval().b());
        const ProgressiveCurve progressive = progressive_form(curve, knots);
        CHECK(progressive.control_points() == curve.control_points());
        CHECK(control_points(progressive, curve.interval()) == curve);
    }
}

TEST_CASE("the shape of a progressive curve is checked", "[progressive]") {
    const std::vector<Coordinates> points{{0}, {2}, {6}};
    CHECK(failure_code([&] { ProgressiveCurve({0, 1, 2}, points); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { ProgressiveCurve({}, std::vector<Coordinates>{}); }) == ErrorCode::wrong_arity);
    const auto mixed = failure([] { ProgressiveCurve({0, 1}, std::vector<Coordinates>{{0}, {2, 3}}); });
    REQUIRE(mixed);
    CHECK(mixed->place() == Part::control_points / 1);
    const ProgressiveCurve curve({0, 1, 2, 3}, points);
    CHECK(failure_code([&] { blossom_value(curve, std::vector<Argument>{Parameter(1)}); }) ==
          ErrorCode::wrong_arity);
    CHECK(evaluate(ProgressiveCurve({}, std::vector<Coordinates>{{5, 6}}), 3) == Coordinates{5, 6});
    const PolynomialCurve square(Polynomial::monomial(2));
    CHECK(failure_code([&] { progressive_form(square, {0, 1, 2}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { progressive_form(square, {0, 1, 2, 3, 4}); }) == ErrorCode::wrong_arity);
    CHECK(progressive_form(square, {0, 1, 2, 3}) == curve);
}
