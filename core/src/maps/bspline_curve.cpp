#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/error.hpp>

#include <string>

namespace blossom {

namespace {

void require_points_of_one_space(std::span<const Coordinates> points) {
    const std::size_t dimension = points.front().size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].size() == dimension && dimension > 0) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "control point " + std::to_string(i) + " has " + std::to_string(points[i].size()) +
                        " coordinates; every point needs the same number, at least 1, and point 0 has " +
                        std::to_string(dimension),
                    Part::control_points / i);
    }
}

}  // namespace

BSplineCurve::BSplineCurve(Count degree, std::vector<Rational> knots, std::vector<Coordinates> control_points)
    : knots_(degree, std::move(knots), control_points.size()), control_points_(std::move(control_points)) {
    require_points_of_one_space(control_points_);
}

BSplineCurve::BSplineCurve(KnotVector knots, std::vector<Coordinates> control_points)
    : knots_(std::move(knots)), control_points_(std::move(control_points)) {
    if (control_points_.size() != knots_.points()) {
        throw Error(ErrorCode::wrong_arity,
                    "the knots are for " + std::to_string(knots_.points()) + " control points, not " +
                        std::to_string(control_points_.size()),
                    Part::control_points);
    }
    require_points_of_one_space(control_points_);
}

}  // namespace blossom
