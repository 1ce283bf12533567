#include <blossom/core/spline/spline_elevation.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include "core_test.hpp"

namespace {

/// The mean of the blossom of one segment over all choices of arguments with one omitted, one degree at a
/// time.
Coordinates mean_of_omissions(const textbook::Spline& plain, std::size_t span,
                              const std::vector<Argument>& arguments) {
    if (arguments.size() == plain.degree) return textbook::segment_blossom(plain, span, arguments);
    Coordinates mean(plain.points.front().size());
    for (std::size_t omitted = 0; omitted < arguments.size(); ++omitted) {
        std::vector<Argument> others = arguments;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(omitted));
        const Coordinates value = mean_of_omissions(plain, span, others);
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += value[i] / Rational(arguments.size());
    }
    return mean;
}

}  // namespace

TEST_CASE("a raised spline is the same map, with each knot of the domain repeated r times more",
          "[elevation]") {
    Random random(71);
    for (int round = 0; round < 120; ++round) {
        const SplineRecipe recipe = spline(random, random.below(5));
        const BSplineCurve curve = recipe.curve();
        const std::size_t r = random.below(4);
        const BSplineCurve raised = elevate(curve, r);
        CHECK(raised.degree() == recipe.degree + r);
        CHECK(raised.knots().convention() == curve.knots().convention());
        CHECK(raised.control_points().size() == recipe.points.size() + r * curve.knots().spans().size());
        const Interval domain = curve.knots().domain();
        for (const auto& [knot, multiplicity] : curve.knots().distinct()) {
            const bool inside = domain.a() <= knot && knot <= domain.b();
            CHECK(raised.knots().multiplicity(knot) == multiplicity + (inside ? r : 0));
        }
        CHECK(textbook::same_map(oracle(raised), recipe.oracle()));
        if (r == 2) CHECK(raised == elevate(elevate(curve, 1), 1));
        std::vector<BezierCurve> segments = bezier_segments(curve);
        for (BezierCurve& segment : segments) segment = elevate(segment, r);
        CHECK(bezier_segments(raised) == segments);
        CHECK(join(segments, raised.knots()) == raised);
    }
}

TEST_CASE(
    "control points of a raised spline are means of blossoms with arguments omitted, as derose-raise-general "
    "says",
    "[elevation][derose]") {
    Random random(72);
    for (int round = 0; round < 20; ++round) {
        const SplineRecipe recipe = spline(random, random.below(4));
        const textbook::Spline plain = recipe.oracle();
        const BSplineCurve raised = elevate(recipe.curve(), 1 + random.below(2));
        const textbook::Spline finer = oracle(raised);
        const std::size_t n = raised.degree();
        for (std::size_t j = 0; j < finer.points.size(); ++j) {
            std::vector<Argument> window;
            for (std::size_t i = 0; i < n; ++i) window.emplace_back(Parameter(finer.knots[j + 1 + i]));
            for (std::size_t span = recipe.degree; span < plain.points.size(); ++span) {
                if (std::max(plain.knots[span], finer.knots[j]) <
                    std::min(plain.knots[span + 1], finer.knots[j + n + 1])) {
                    CHECK(finer.points[j] == mean_of_omissions(plain, span, window));
                }
            }
        }
    }
}

TEST_CASE("raising is refused beyond the limit of the degree before it begins", "[elevation]") {
    const BSplineCurve curve(1, {0, 1, 2}, {{1}, {2}, {4}});
    CHECK(elevate(curve, 0) == curve);
    CHECK(failure_code([&] { elevate(curve, SIZE_MAX); }) == ErrorCode::limit_exceeded);
    Limits limits;
    limits.degree = 4;
    CHECK_FALSE(failure([&] { elevate(curve, 3, limits); }));
    CHECK(failure_code([&] { elevate(curve, 4, limits); }) == ErrorCode::limit_exceeded);
}
