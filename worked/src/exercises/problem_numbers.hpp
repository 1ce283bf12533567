#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace blossom::worked {

/// Small numbers for problems, the same for a seed on every platform: the standard fixes the engine.
class ProblemNumbers {
public:
    ProblemNumbers(std::uint64_t seed, std::size_t level) : engine_(seed), level_(level) {}

    std::size_t level() const { return level_; }
    std::size_t degree() const { return level_ == 1 ? 2 : 3; }
    /// Of this degree, no coefficient of which is zero.
    PolynomialCurve polynomial();
    /// In the plane over [0, 1], neither with equal neighbours nor on a line.
    BezierCurve polygon();
    /// In the plane, over uniform knots.
    BSplineCurve spline();
    /// In the plane, two segments that meet at 1 with one of the possible multiplicities.
    BSplineCurve joint();
    /// A polygon with positive weights as homogeneous coordinates; not all weights are equal.
    BezierCurve weighted_polygon();
    /// A net in the plane whose corners make a triangle.
    BezierPatch triangle();
    /// Barycentric coordinates, all positive.
    Coordinates inside_triangle();
    /// Distinct parameters.
    std::vector<Argument> arguments(std::size_t n);
    /// A parameter between the ends, which are integers, and none itself.
    Rational inside(const Interval& interval);
    /// Other than [0, 1], increasing.
    Interval interval();

private:
    std::int64_t between(std::int64_t least, std::int64_t greatest);
    std::int64_t not_zero(std::int64_t size);
    std::vector<Coordinates> plane_points(std::size_t count);

    std::mt19937_64 engine_;
    std::size_t level_;
};

}  // namespace blossom::worked
