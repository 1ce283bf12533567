#pragma once

// Progressive values on integers: what evaluation, insertion and extraction of splines run on, one window at
// a time.

#include <blossom/core/spline/progressive.hpp>

#include "maps/integer_frame.hpp"

namespace blossom {

/// 2n knots, which live as long as the frame, and n + 1 points over one denominator.
class ProgressiveFrame {
public:
    ProgressiveFrame(std::span<const Rational> knots, std::span<const Coordinates> points,
                     const Limits& limits);
    ProgressiveFrame(const ProgressiveCurve& curve, const Limits& limits);

    std::size_t degree() const { return knots_.size() / 2; }
    /// f(arguments), as many as the degree, by `constructions::ProgressiveTriangle`: one value needs the
    /// lengths of all intervals below the line in any case, so that nothing is divided on the way.
    Coordinates value(std::span<const Argument> arguments) const;
    /// P_k = f(a^(n-k), b^k) over the knots in the middle, a = t_(n-1) and b = t_n.
    ///
    /// The triangle at a has f(a^k, t_n, ..., t_(2n-k-1)) at its edge: progressive values over n copies of a
    /// and the last n knots, for which the triangle at b has P_k at its edge. Cost: n^2 combinations of
    /// points. Degree 0 has no knots and is not taken.
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

/// De Boor's triangle on its way down, see `constructions::ProgressiveTriangle`, over a denominator that
/// grows by little more than the entries need.
class ProgressiveDescent {
public:
    explicit ProgressiveDescent(const ProgressiveFrame& frame);

    /// Cost: n - k combinations and divisions a coordinate at level k. Errors: `limit_exceeded`.
    void descend(const Argument& argument);
    /// f(u_1, ..., u_k, t_(k+l), ..., t_(n+l-1)) for the arguments so far.
    Coordinates entry(std::size_t l) const;
    /// The entries, one row a coordinate, over `denominator()`, which each level multiplies.
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
