#pragma once

#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// A piecewise polynomial map into Q^d of degree n. On each non-empty span of its knots, the control points
/// are the values of the polynomial's blossom at n consecutive knots.
///
/// Unlike those of a Bezier curve, the control points keep their own denominators: a common denominator of
/// ten thousand unrelated points would have as many digits as all of them together. Source: DeRose, section
/// 4.6. Statements: derose-46-cubic-scheme, hart-four-points.
class BSplineCurve {
public:
    /// Errors: those of `KnotVector`; `mismatched_dimensions`, below `Part::control_points`.
    BSplineCurve(Count degree, std::vector<Rational> knots, std::vector<Coordinates> control_points);
    /// Errors: `wrong_arity` unless the number of points is that of the knot vector; `mismatched_dimensions`.
    BSplineCurve(KnotVector knots, std::vector<Coordinates> control_points);

    std::size_t degree() const { return knots_.degree(); }
    std::size_t dimension() const { return control_points_.front().size(); }
    const KnotVector& knots() const { return knots_; }
    const std::vector<Coordinates>& control_points() const { return control_points_; }
    /// The n + 1 control points that determine the polynomial on a span. Errors: `outside_domain` unless it
    /// is a span of the domain, possibly an empty one.
    std::span<const Coordinates> points_of(std::size_t span) const {
        require_index(knots_.first_point(span), knots_.points() - degree());
        return std::span(control_points_).subspan(knots_.first_point(span), degree() + 1);
    }

    friend bool operator==(const BSplineCurve&, const BSplineCurve&) = default;
    /// "degree 1, knots 0, 0, 1, 1, control points (0, 0), (1, 2)".
    friend std::string to_string(const BSplineCurve& curve);
    friend std::size_t hash_value(const BSplineCurve& curve) {
        return hash_of(curve.knots_, curve.control_points_);
    }

private:
    KnotVector knots_;
    std::vector<Coordinates> control_points_;
};

/// The interval of a spline is its domain.
inline std::optional<Interval> own_interval(const BSplineCurve& curve) { return curve.knots().domain(); }

}  // namespace blossom
