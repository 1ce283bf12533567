#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/spline/progressive.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "maps/stated_points.hpp"
#include "progressive_frame.hpp"

namespace blossom {

namespace {

PointArray values(std::span<const Coordinates> points) {
    return within(Part::control_points, [&] { return PointArray(points); });
}

void require_determined(std::span<const Rational> knots, std::size_t n) {
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t l = 0; l <= j; ++l) {
            if (knots[j] != knots[n + l]) continue;
            throw Error(ErrorCode::bad_knots,
                        "knots " + std::to_string(j) + " and " + std::to_string(n + l) + " are equal (" +
                            to_string(knots[j]) +
                            "); progressive values determine a map only if knots j and n + l differ for l <= "
                            "j < n = " +
                            std::to_string(n),
                        Part::knots / (n + l));
        }
    }
}

void require_arity(std::span<const Argument> arguments, std::size_t degree) {
    if (arguments.size() == degree) return;
    throw Error(ErrorCode::wrong_arity,
                "the blossom of a map of formal degree " + std::to_string(degree) + " takes " +
                    std::to_string(degree) + " arguments, not " + std::to_string(arguments.size()),
                Part::arguments);
}

}  // namespace

ProgressiveCurve::ProgressiveCurve(std::vector<Rational> knots, std::span<const Coordinates> control_points)
    : knots_(std::move(knots)), control_points_(values(control_points)) {
    if (knots_.size() != 2 * degree()) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(degree() + 1) + " progressive values need " +
                        std::to_string(2 * degree()) + " knots, not " + std::to_string(knots_.size()),
                    Part::knots);
    }
    require_determined(knots_, degree());
}

Coordinates blossom_value(const ProgressiveCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits) {
    require_arity(arguments, curve.degree());
    return ProgressiveFrame(curve, limits).value(arguments);
}

std::vector<std::vector<Coordinates>> de_boor_pyramid(const ProgressiveCurve& curve,
                                                      std::span<const Argument> arguments,
                                                      const Limits& limits) {
    const std::size_t n = curve.degree();
    require_arity(arguments, n);
    require_within((n + 1) * (n + 2) / 2 * curve.dimension(), limits.numbers, "numbers",
                   "the count of numbers");
    const ProgressiveFrame frame(curve, limits);
    ProgressiveDescent descent(frame);
    std::vector<std::vector<Coordinates>> levels{curve.control_points().to_points()};
    for (std::size_t k = 0; k < n; ++k) {
        descent.descend(arguments[k]);
        std::vector<Coordinates> level;
        level.reserve(n - k);
        for (std::size_t l = 0; l < n - k; ++l) level.push_back(descent.entry(l));
        levels.push_back(std::move(level));
    }
    return levels;
}

Coordinates evaluate(const ProgressiveCurve& curve, const Parameter& t, const Limits& limits) {
    return blossom_value(curve, with_copies({}, curve.degree(), t), limits);
}

std::optional<Interval> own_interval(const ProgressiveCurve& curve) {
    const std::size_t n = curve.degree();
    return n == 0 ? Interval() : Interval(curve.knots()[n - 1], curve.knots()[n]);
}

std::vector<StatedValue> stated_values(const ProgressiveCurve& curve) {
    const std::vector<Coordinates> points = curve.control_points().to_points();
    const auto arguments = [&](std::size_t k) {
        std::vector<Argument> window;
        for (const Rational& knot : std::span(curve.knots()).subspan(k, curve.degree()))
            window.emplace_back(Parameter(knot));
        return window;
    };
    return stated_points("control point", points, arguments, [](std::size_t) { return Integer(1); });
}

BezierCurve control_points(const ProgressiveCurve& curve, const Interval& interval, const Limits& limits) {
    if (curve.degree() == 0) return {curve.control_points(), interval};
    const BezierCurve own(ProgressiveFrame(curve, limits).control_points(), interval_of(curve));
    return own.interval() == interval ? own : control_points(own, interval, limits);
}

ProgressiveCurve progressive_form(const PolynomialMap& map, std::vector<Rational> knots,
                                  const Limits& limits) {
    const Blossom blossom(map, limits);
    const std::size_t n = blossom.degree();
    const std::vector<Argument> arguments(knots.begin(), knots.end());
    std::vector<Coordinates> points;
    for (std::size_t j = 0; j + n <= arguments.size() && j <= n; ++j) {
        points.push_back(blossom(std::span(arguments).subspan(j, n)));
    }
    if (points.size() != n + 1) {
        throw Error(ErrorCode::wrong_arity,
                    "progressive values of degree " + std::to_string(n) + " need " + std::to_string(2 * n) +
                        " knots, not " + std::to_string(knots.size()),
                    Part::knots);
    }
    return {std::move(knots), points};
}

}  // namespace blossom
