#pragma once

#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>

namespace blossom {

/// A polynomial map t -> Q^d of formal degree n by its control polygon over [a, b]:
/// P(t) = sum_k P_k C(n, k) (b - t)^(n-k) (t - a)^k / (b - a)^n. It can be evaluated at any t.
class BezierCurve {
public:
    /// Takes n + 1 control points. Errors: those of `PointArray`, with places below `Part::control_points`.
    explicit BezierCurve(std::span<const Coordinates> control_points, Interval interval = {});
    BezierCurve(std::initializer_list<Coordinates> control_points, Interval interval = {})
        : BezierCurve(std::span(control_points.begin(), control_points.size()), std::move(interval)) {}
    BezierCurve(PointArray control_points, Interval interval);

    std::size_t degree() const { return control_points_.size() - 1; }
    std::size_t dimension() const { return control_points_.dimension(); }
    const Interval& interval() const { return interval_; }
    const PointArray& control_points() const { return control_points_; }

    friend bool operator==(const BezierCurve&, const BezierCurve&) = default;
    /// "control points (0, 0), (1, 2) over [0, 1]".
    friend std::string to_string(const BezierCurve& curve);
    friend std::size_t hash_value(const BezierCurve& curve) {
        return hash_of(curve.interval_, curve.control_points_);
    }

private:
    Interval interval_;
    PointArray control_points_;
};

}  // namespace blossom
