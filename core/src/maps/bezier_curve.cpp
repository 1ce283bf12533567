#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/rational/error.hpp>

#include <utility>

namespace blossom {

namespace {

PointArray polygon(std::span<const Coordinates> points) {
    return within(Part::control_points, [&] { return PointArray(points); });
}

}  // namespace

BezierCurve::BezierCurve(std::span<const Coordinates> control_points, Interval interval)
    : interval_(std::move(interval)), control_points_(polygon(control_points)) {}

BezierCurve::BezierCurve(PointArray control_points, Interval interval)
    : interval_(std::move(interval)), control_points_(std::move(control_points)) {}

}  // namespace blossom
