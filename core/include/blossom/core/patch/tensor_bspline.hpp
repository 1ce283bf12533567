#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// A tensor product of B-splines in any number of directions: a grid of control points. Each row of the grid
/// in any direction is a spline curve over the knots of this direction.
///
/// The index of the last direction changes fastest in the sequence of points. On each box of spans the map is
/// one polynomial, and the control points are the values of its blossom at consecutive knots in every
/// direction. A rational (NURBS) map has its weight as last coordinate, see `rational_curve.hpp`. Every
/// algorithm is the algorithm for curves, applied along the rows. Source: DeRose, section 5;
/// Fernandez-Jambrina, equation (9). Statements: derose-tensor-allresults, fj-eq9.
class TensorBSpline {
public:
    /// Errors: `wrong_arity` if there is no direction, or if the number of points does not match the knots;
    /// `mismatched_dimensions`. The places are below `Part::control_points`.
    TensorBSpline(std::vector<KnotVector> knots, std::vector<Coordinates> control_points);

    std::size_t directions() const { return knots_.size(); }
    std::size_t dimension() const { return control_points_.front().size(); }
    const KnotVector& knots(std::size_t direction) const { return knots_[direction]; }
    const std::vector<KnotVector>& knots() const { return knots_; }
    const std::vector<Coordinates>& control_points() const { return control_points_; }

    friend bool operator==(const TensorBSpline&, const TensorBSpline&) = default;
    /// "degree 1, knots 0, 0, 1, 1; degree 0, knots 0, 1; control points (0), (1)".
    friend std::string to_string(const TensorBSpline& spline);
    friend std::size_t hash_value(const TensorBSpline& spline) {
        return hash_of(spline.knots_, spline.control_points_);
    }

private:
    std::vector<KnotVector> knots_;
    std::vector<Coordinates> control_points_;
};

/// The blossom of the polynomial on a box of spans, one per direction, at any arguments, one list per
/// direction: first the values of the rows in the last direction, then in the one before, and so on.
///
/// Cost: for degrees n the (n + 1)^d points of the box, n^2 / 2 combinations per row. Errors: `wrong_arity`,
/// `outside_domain`, `limit_exceeded`. Source: Fernandez-Jambrina, equation (9).
Coordinates segment_blossom(const TensorBSpline& spline, std::span<const std::size_t> spans,
                            std::span<const std::vector<Argument>> arguments, const Limits& limits = {});

/// The spans to the right of the parameters; at the end of a domain, the last span. Errors: `outside_domain`
/// at `Part::at / d`, `wrong_arity`.
std::vector<std::size_t> spans_at(const TensorBSpline& spline, std::span<const Rational> parameters);

/// The value at parameters, on the spans of `spans_at`. Errors: as for `spans_at`.
Coordinates evaluate(const TensorBSpline& spline, std::span<const Rational> parameters,
                     const Limits& limits = {});

/// The partial derivative of order orders[d] in direction d: n! / (n - k)! times the blossom with k unit
/// vectors in each direction; zero if k > n.
Coordinates derivative(const TensorBSpline& spline, std::span<const std::size_t> orders,
                       std::span<const Rational> parameters, const Limits& limits = {});

/// The same map over more knots in one direction. Cost and errors: those of `insert_knots` in
/// knot_insertion.hpp for the curve along the direction.
TensorBSpline insert_knots(const TensorBSpline& spline, std::size_t direction,
                           std::span<const Rational> knots, const Limits& limits = {});

/// The polynomial on a box of spans as a Bezier patch over this box. Errors: `outside_domain`,
/// `limit_exceeded`.
BezierPatch bezier_segment(const TensorBSpline& spline, std::span<const std::size_t> spans,
                           const Limits& limits = {});

/// The control points on which the polynomial on a box of spans depends, n + 1 per direction, the last
/// direction fastest. Errors: `outside_domain`, `wrong_arity`.
std::vector<Coordinates> points_of_box(const TensorBSpline& spline, std::span<const std::size_t> spans);

/// The intervals of a box of spans.
std::vector<Interval> box_of(const TensorBSpline& spline, std::span<const std::size_t> spans);

}  // namespace blossom
