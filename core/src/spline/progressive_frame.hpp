#pragma once

// Progressive values in integers, one window at a time: evaluation, insertion and extraction of splines use
// them.

#include <blossom/core/spline/progressive.hpp>

#include "maps/integer_frame.hpp"

namespace blossom {

/// 2n knots, which must outlive this object, and n + 1 points over one denominator.
class ProgressiveFrame {
public:
    ProgressiveFrame(std::span<const Rational> knots, std::span<const Coordinates> points,
                     const Limits& limits);
    ProgressiveFrame(const ProgressiveCurve& curve, const Limits& limits);

    std::size_t degree() const { return knots_.size() / 2; }
    /// f(arguments) for as many arguments as the degree, by `constructions::ProgressiveTriangle`.
    Coordinates value(std::span<const Argument> arguments) const;
    /// P_k = f(a^(n-k), b^k) over the middle knots a = t_(n-1) and b = t_n.
    ///
    /// The triangle at a has f(a^k, t_n, ..., t_(2n-k-1)) at its edge: progressive values over n copies of a
    /// and the last n knots. The triangle at b over these values has P_k at its edge. Cost: n^2 combinations
    /// of points. The degree must not be 0, which has no knots.
    PointArray control_points() const;

private:
    friend class ProgressiveDescent;

    ProgressiveFrame(std::span<const Rational> knots, std::vector<std::vector<Integer>> rows,
                     Integer denominator, const Limits& limits);

    std::span<const Rational> knots_;
    std::vector<std::vector<Integer>> rows_;
    Integer denominator_;
    Limits limits_;
};

/// De Boor's triangle level by level, see `constructions::ProgressiveTriangle`. Each level has one common
/// denominator, which grows by little more than the entries need.
class ProgressiveDescent {
public:
    explicit ProgressiveDescent(const ProgressiveFrame& frame);

    /// Adds one level. Cost: n - k combinations and divisions per coordinate at level k. Errors:
    /// `limit_exceeded`.
    void descend(const Argument& argument);
    /// f(u_1, ..., u_k, t_(k+l), ..., t_(n+l-1)) for the arguments u_1, ..., u_k so far.
    Coordinates entry(std::size_t l) const;
    /// The entries, one row per coordinate, over `denominator()`, which grows with each level.
    const std::vector<std::vector<Integer>>& rows() const { return rows_; }
    const Integer& denominator() const { return denominator_; }

private:
    RationalVector knots_;
    std::vector<std::vector<Integer>> rows_;
    Integer denominator_;
    std::size_t level_ = 0;
    Limits limits_;
};

}  // namespace blossom
