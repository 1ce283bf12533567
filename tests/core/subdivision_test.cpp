#include "core_test.hpp"

namespace {

/// (a^(n-r-i), b^i, u_1, ..., u_r), the arguments of node i on level r.
std::vector<Argument> label(const BezierCurve& curve, std::span<const Argument> arguments, std::size_t r,
                            std::size_t i) {
    std::vector<Argument> all = with_copies({}, curve.degree() - r - i, Parameter(curve.interval().a()));
    all = with_copies(std::move(all), i, Parameter(curve.interval().b()));
    all.insert(all.end(), arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(r));
    return all;
}

/// Any number except the ends: inside, outside or close to them.
Rational splitting_parameter(Random& random, const Interval& interval, Size size) {
    Rational t = number(random, size);
    if (random.one_in(3)) t = interval.a() + (interval.b() - interval.a()) * Rational(1 + random.below(8), 9);
    while (t == interval.a() || t == interval.b()) t += Rational(1, 1000);
    return t;
}

}  // namespace

TEST_CASE("every node of the pyramid is the blossom value of its label", "[subdivision]") {
    Random random(301);
    for (std::size_t i = 0; i < 270; ++i) {
        const std::size_t n = i % 9;
        const Size size = i % 4 == 0 ? Size::any : Size::small;
        const BezierCurve curve = bezier_map(random, n, size).curve();
        const std::vector<Argument> given = arguments(random, n, size);
        const Pyramid pyramid = casteljau_pyramid(curve, given);
        CAPTURE(i, n, given);
        REQUIRE(pyramid.levels.size() == n + 1);
        CHECK(pyramid.levels.front() == curve.control_points());
        for (std::size_t r = 0; r <= n; ++r) {
            REQUIRE(pyramid.levels[r].size() == n + 1 - r);
            for (std::size_t k = 0; k + r <= n; ++k) {
                CHECK(pyramid.levels[r][k] ==
                      blossom_value(curve, label(curve, given, r, k), Construction::symmetric));
            }
        }
        CHECK(pyramid.apex() == Blossom(curve)(given));
    }
}

TEST_CASE("the points of a pyramid have their least common denominator", "[subdivision]") {
    const BezierCurve curve(std::vector<Coordinates>{{4}, {8}, {6}}, Interval(0, 2));
    const Pyramid pyramid = casteljau_pyramid(curve, with_copies({}, 2, Parameter(1)));
    CHECK(pyramid.levels[1].denominator() == 1);
    CHECK(pyramid.levels[1].to_points() == std::vector<Coordinates>{{6}, {7}});
    CHECK(pyramid.levels[2].to_points() == std::vector<Coordinates>{{Rational(13, 2)}});
}

TEST_CASE("a pyramid takes as many arguments as the degree", "[subdivision]") {
    const BezierCurve curve(std::vector<Coordinates>{{1}, {2}, {3}});
    for (const std::size_t count : {0U, 1U, 3U}) {
        const auto error = failure([&] { casteljau_pyramid(curve, with_copies({}, count, Parameter(0))); });
        REQUIRE(error);
        CHECK(error->code() == ErrorCode::wrong_arity);
        CHECK(error->place() == Part::arguments);
    }
    Limits limits;
    limits.digits = 5;
    const auto refused =
        failure([&] { casteljau_pyramid(curve, with_copies({}, 2, Parameter(1'000'000)), limits); });
    REQUIRE(refused);
    CHECK(refused->code() == ErrorCode::limit_exceeded);
    CHECK(refused->message().find("digits") != std::string::npos);
}

TEST_CASE("the pieces of a subdivision are the same polynomial over their own intervals", "[subdivision]") {
    Random random(302);
    for (std::size_t i = 0; i < 360; ++i) {
        const std::size_t n = i % 9;
        const Size size = i % 4 == 0 ? Size::any : Size::small;
        const BezierCurve curve = bezier_map(random, n, size).curve();
        const Interval& interval = curve.interval();
        const Rational t = splitting_parameter(random, interval, size);
        CAPTURE(i, n, t);
        const auto [left, right] = subdivide(curve, t);
        CHECK(left.interval() == Interval(interval.a(), t));
        CHECK(right.interval() == Interval(t, interval.b()));
        CHECK(left.degree() == n);
        CHECK(right.degree() == n);
        CHECK(expanded(left) == expanded(curve));
        CHECK(expanded(right) == expanded(curve));
        CHECK(left == control_points(curve, left.interval()));
        CHECK(right == control_points(curve, right.interval()));
        CHECK(left.control_points()[n] == right.control_points()[0]);
        CHECK(left.control_points()[n] == evaluate(curve, t));
    }
}

TEST_CASE("a curve is not subdivided at its ends", "[subdivision]") {
    const BezierCurve curve(std::vector<Coordinates>{{1, 2}, {2, 0}, {3, 5}}, Interval(3, Rational(1, 2)));
    CHECK(failure_code([&] { subdivide(curve, 3); }) == ErrorCode::empty_interval);
    CHECK(failure_code([&] { subdivide(curve, Rational(1, 2)); }) == ErrorCode::empty_interval);
    CHECK(failure_code([&] { subdivide(curve, 0); }) == std::nullopt);
}
