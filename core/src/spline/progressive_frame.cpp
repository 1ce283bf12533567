#include "progressive_frame.hpp"

#include <algorithm>

namespace blossom {

ProgressiveFrame::ProgressiveFrame(std::span<const Rational> knots, std::span<const Coordinates> points,
                                   const Limits& limits)
    : knots_(knots), denominator_(1), limits_(limits) {
    require_within(degree(), limits.degree, "degree", "the formal degree", Part::degree);
    for (const Coordinates& point : points) {
        for (const Rational& coordinate : point) {
            if (!coordinate.is_integer()) denominator_ = lcm(denominator_, coordinate.denominator());
        }
    }
    rows_.resize(points.front().size());
    for (std::size_t j = 0; j < rows_.size(); ++j) {
        rows_[j].reserve(points.size());
        for (const Coordinates& point : points) {
            rows_[j].push_back(point[j].numerator() * divide_exactly(denominator_, point[j].denominator()));
        }
    }
}

ProgressiveFrame::ProgressiveFrame(const ProgressiveCurve& curve, const Limits& limits)
    : knots_(curve.knots()), denominator_(curve.control_points().denominator()), limits_(limits) {
    require_within(degree(), limits.degree, "degree", "the formal degree", Part::degree);
    for (const auto row : curve.control_points().rows()) rows_.emplace_back(row.begin(), row.end());
}

Coordinates ProgressiveFrame::value(std::span<const Argument> arguments) const {
    ProgressiveDescent descent(*this);
    for (const Argument& argument : arguments) descent.descend(argument);
    return descent.entry(0);
}

BezierCurve ProgressiveFrame::control_points(const Interval& interval) const {
    const std::size_t n = degree();
    std::vector<Coordinates> points(n + 1);
    ProgressiveDescent at_a(*this);
    for (std::size_t k = n + 1; k-- > 0;) {
        ProgressiveDescent at_both = at_a;
        at_both.descend(Parameter(interval.b()), k);
        points[k] = at_both.entry(0);
        if (k > 0) at_a.descend(Parameter(interval.a()));
    }
    return BezierCurve(points, interval);
}

ProgressiveDescent::ProgressiveDescent(const ProgressiveFrame& frame)
    : triangle_(frame.rows_, frame.knots_), denominator_(frame.denominator_), limits_(frame.limits_) {}

void ProgressiveDescent::descend(const Argument& argument) {
    const ClearedArguments cleared = cleared_one_by_one({&argument, 1});
    triangle_.descend(cleared.pairs.front());
    std::size_t bits = 0;
    for (const auto& row : triangle_.rows()) bits = std::max(bits, greatest_bit_length(row));
    require_result_bits(bits, limits_);
    denominator_ *= cleared.scales.front();
}

}  // namespace blossom
