#include "core_test.hpp"

namespace {

std::function<Coordinates(const Rational&)> values_of(const PolynomialCurve& curve) {
    return [&curve](const Rational& t) { return evaluate(curve, t); };
}

/// The distinct fractions I / N with 0 <= I <= N <= n, N >= 1: 1 plus Euler's totients.
std::size_t node_count(std::size_t n) {
    std::set<Rational> fractions;
    for (std::size_t count = 1; count <= n; ++count) {
        for (std::size_t i = 0; i <= count; ++i) fractions.emplace(i, count);
    }
    return fractions.size();
}

/// A map that is not a polynomial: a formula that uses other values gives another result.
Rational reciprocal(const Rational& t) { return 1 / (t * t + 1); }

}  // namespace

TEST_CASE("the inverse formula is exact for every polynomial of at most its degree", "[inverse_formula]") {
    Random random(331);
    for (std::size_t i = 0; i < 270; ++i) {
        const std::size_t n = i % 9;
        const Size size = i % 4 == 0 ? Size::any : Size::small;
        const PolynomialCurve curve = polynomial_map(random, n, size).curve();
        const Interval over = interval(random, size);
        const std::size_t raised = n + random.below(3);
        CAPTURE(i, n, raised, over.a(), over.b());
        CHECK(control_points_from_values(n, over, values_of(curve)) == control_points(curve, over));
        CHECK(control_points_from_values(raised, over, values_of(curve)) ==
              control_points(elevate(curve, raised - n), over));
    }
}

TEST_CASE("the weights of a control point are those of polarization at (a^(n-i), b^i)", "[inverse_formula]") {
    Random random(332);
    for (std::size_t i = 0; i < 60; ++i) {
        const std::size_t n = 1 + i % 8;
        const Interval over = interval(random, Size::small);
        const BezierCurve points =
            control_points_from_values(n, over, [](const Rational& t) { return Coordinates{reciprocal(t)}; });
        for (std::size_t k = 0; k <= n; ++k) {
            std::vector<Parameter> label(n - k, over.a());
            label.insert(label.end(), k, over.b());
            CHECK(points.control_points()[k] ==
                  blossom_from_values([](const Rational& t) { return Coordinates{reciprocal(t)}; }, label));
        }
    }
}

TEST_CASE("the nodes run from a to b, and there are as many as fractions of denominators up to n",
          "[inverse_formula]") {
    Random random(333);
    const std::vector<std::size_t> counts{1, 2, 3, 5, 7, 11, 13, 19, 23};
    for (std::size_t n = 0; n <= 12; ++n) {
        const Interval over = interval(random, Size::any);
        const InverseFormula formula = inverse_formula(n, over);
        if (n < counts.size()) CHECK(formula.nodes.size() == counts[n]);
        if (n > 0) {
            CHECK(formula.nodes.size() == node_count(n));
            CHECK(formula.nodes.back() == over.b());
        }
        CHECK(formula.nodes.front() == over.a());
        const int direction = (over.b() - over.a()).sign();
        for (std::size_t j = 1; j < formula.nodes.size(); ++j) {
            CHECK((formula.nodes[j] - formula.nodes[j - 1]).sign() == direction);
        }
    }
}

TEST_CASE("rows of weights sum to one, mirror each other, and the end rows are unit vectors",
          "[inverse_formula]") {
    for (std::size_t n = 0; n <= 14; ++n) {
        const InverseFormula formula = inverse_formula(n, {});
        REQUIRE(formula.weights.size() == n + 1);
        const std::size_t nodes = formula.nodes.size();
        for (std::size_t i = 0; i <= n; ++i) {
            const auto& row = formula.weights[i];
            REQUIRE(row.size() == nodes);
            CHECK(std::accumulate(row.begin(), row.end(), Rational()) == 1);
            for (std::size_t j = 0; j < nodes; ++j) {
                CHECK(row[j] == formula.weights[n - i][nodes - 1 - j]);
                if (i == 0) CHECK(row[j] == (j == 0 ? 1 : 0));
            }
        }
        for (std::size_t j = 0; j < nodes; ++j) {
            if (n > 0) CHECK(formula.nodes[j] + formula.nodes[nodes - 1 - j] == 1);
        }
    }
}

TEST_CASE("a map is evaluated once per node", "[inverse_formula]") {
    std::vector<Rational> asked;
    const Interval over(2, -1);
    control_points_from_values(5, over, [&](const Rational& t) {
        asked.push_back(t);
        return Coordinates{t};
    });
    CHECK(asked == inverse_formula(5, over).nodes);
}

TEST_CASE("samples at the nodes give the same control points as the map", "[inverse_formula]") {
    Random random(334);
    for (std::size_t i = 0; i < 45; ++i) {
        const std::size_t n = i % 9;
        const PolynomialCurve curve = polynomial_map(random, n + 2, Size::small).curve();
        const Interval over = interval(random, Size::small);
        std::map<Rational, Coordinates> samples;
        for (const Rational& node : inverse_formula(n, over).nodes) samples[node] = evaluate(curve, node);
        const BezierCurve points = control_points_from_samples(n, over, samples);
        CHECK(points == control_points_from_values(n, over, values_of(curve)));

        samples[over.a() - 1000] = Coordinates(curve.dimension());
        CHECK(control_points_from_samples(n, over, samples) == points);

        const Rational missing =
            inverse_formula(n, over).nodes[random.below(inverse_formula(n, over).nodes.size())];
        samples.erase(missing);
        const auto error = failure([&] { control_points_from_samples(n, over, samples); });
        REQUIRE(error);
        CHECK(error->code() == ErrorCode::missing_sample);
        CHECK(error->message().find("at " + to_string(missing) + ",") != std::string::npos);
        CHECK(error->place() == Part::values);
    }
}

TEST_CASE("the first missing node is the one that is named", "[inverse_formula]") {
    const std::map<Rational, Coordinates> samples{{0, {1}}, {Rational(1, 2), {1}}};
    const auto error = failure([&] { control_points_from_samples(3, {}, samples); });
    REQUIRE(error);
    CHECK(error->message().find("at 1/3,") != std::string::npos);
}

TEST_CASE("samples of different dimensions and immense degrees are refused", "[inverse_formula]") {
    const std::map<Rational, Coordinates> samples{{0, {1}}, {1, {1, 2}}};
    CHECK(failure_code([&] { control_points_from_samples(1, {}, samples); }) ==
          ErrorCode::mismatched_dimensions);
    Limits limits;
    limits.degree = 4;
    CHECK(failure_code([&] { inverse_formula(4, {}, limits); }) == std::nullopt);
    CHECK(failure_code([&] { inverse_formula(5, {}, limits); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([] { inverse_formula(9'000, {}); }) == ErrorCode::limit_exceeded);
}
