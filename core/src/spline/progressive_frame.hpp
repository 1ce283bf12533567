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
    /// f(arguments), as many as the degree.
    Coordinates value(std::span<const Argument> arguments) const;
    /// P_k = f(a^(n-k), b^k). The levels at a are shared.
    BezierCurve control_points(const Interval& interval) const;

private:
    friend class ProgressiveDescent;

    std::span<const Rational> knots_;
    std::vector<std::vector<Integer>> rows_;
    Integer denominator_;
    Limits limits_;
};

/// A triangle on its way down, which minds what its arguments were cleared of and how large its numbers are.
/// It looks at the knots of its frame.
class ProgressiveDescent {
public:
    explicit ProgressiveDescent(const ProgressiveFrame& frame);
    explicit ProgressiveDescent(ProgressiveFrame&&) = delete;

    /// Errors: `limit_exceeded`.
    void descend(const Argument& argument);
    void descend(const Argument& argument, std::size_t levels) {
        for (std::size_t k = 0; k < levels; ++k) descend(argument);
    }
    /// f(u_1, ..., u_k, t_(k+l), ..., t_(n+l-1)) for the arguments so far.
    Coordinates entry(std::size_t l) const { return reduced(triangle_.entry(l), denominator_); }

private:
    constructions::ProgressiveTriangle<Integer> triangle_;
    Integer denominator_;
    Limits limits_;
};

}  // namespace blossom
