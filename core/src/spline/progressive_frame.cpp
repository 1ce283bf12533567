#include "progressive_frame.hpp"

#include <algorithm>

#include "divided_rows.hpp"

namespace blossom {

namespace {

/// Common denominators of at most this many bits multiply a whole level; with longer ones each entry is
/// divided by its own.
constexpr std::size_t bits_of_small_denominator = 16;

/// An edge of a triangle, which has one entry per level: the entries over one denominator, one row per
/// coordinate.
class Edge {
public:
    explicit Edge(std::size_t coordinates) : rows_(coordinates) {}

    void take(const ProgressiveDescent& triangle, std::size_t entry) {
        for (std::size_t j = 0; j < rows_.size(); ++j) rows_[j].push_back(triangle.rows()[j][entry]);
        denominators_.push_back(triangle.denominator());
    }
    /// Each denominator divides the next one, so that the last is a common denominator.
    std::vector<std::vector<Integer>> rows() && {
        for (std::size_t k = 0; k < denominators_.size(); ++k) {
            const Integer scale = divide_exactly(denominators_.back(), denominators_[k]);
            if (scale.is_one()) continue;
            for (auto& row : rows_) row[k] *= scale;
        }
        return std::move(rows_);
    }

private:
    std::vector<std::vector<Integer>> rows_;
    std::vector<Integer> denominators_;
};

}  // namespace

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

ProgressiveFrame::ProgressiveFrame(std::span<const Rational> knots, std::vector<std::vector<Integer>> rows,
                                   Integer denominator, const Limits& limits)
    : knots_(knots), rows_(std::move(rows)), denominator_(std::move(denominator)), limits_(limits) {}

Coordinates ProgressiveFrame::value(std::span<const Argument> arguments) const {
    constructions::ProgressiveTriangle<Integer> triangle(rows_, knots_);
    Integer denominator = denominator_;
    for (const Argument& argument : arguments) {
        const ClearedArguments cleared = cleared_one_by_one({&argument, 1});
        triangle.descend(cleared.pairs.front());
        denominator *= cleared.scales.front();
        std::size_t bits = 0;
        for (const auto& row : triangle.rows()) bits = std::max(bits, greatest_bit_length(row));
        require_result_bits(bits, limits_);
    }
    return reduced(triangle.entry(0), denominator);
}

PointArray ProgressiveFrame::control_points() const {
    const std::size_t n = degree();
    ProgressiveDescent at_a(*this);
    Edge behind(rows_.size());
    behind.take(at_a, n);
    for (std::size_t k = 1; k <= n; ++k) {
        at_a.descend(Parameter(knots_[n - 1]));
        behind.take(at_a, n - k);
    }
    std::vector<std::vector<Integer>> rows = std::move(behind).rows();
    for (auto& row : rows) std::ranges::reverse(row);
    std::vector<Rational> knots(knots_.begin(), knots_.end());
    std::fill_n(knots.begin(), n, knots_[n - 1]);
    const ProgressiveFrame clamped(knots, std::move(rows), at_a.denominator(), limits_);

    ProgressiveDescent at_b(clamped);
    Edge points(rows_.size());
    points.take(at_b, 0);
    for (std::size_t k = 1; k <= n; ++k) {
        at_b.descend(Parameter(knots_[n]));
        points.take(at_b, 0);
    }
    std::vector<Integer> numerators;
    for (const auto& row : std::move(points).rows())
        numerators.insert(numerators.end(), row.begin(), row.end());
    PointArray result(rows_.size(), RationalVector(std::move(numerators), at_b.denominator()));
    result.make_canonical();
    return result;
}

ProgressiveDescent::ProgressiveDescent(const ProgressiveFrame& frame)
    : knots_(frame.knots_), rows_(frame.rows_), denominator_(frame.denominator_), limits_(frame.limits_) {}

void ProgressiveDescent::descend(const Argument& argument) {
    const Integer cleared = lcm(argument.u.denominator(), argument.mass.denominator());
    const Integer mass = argument.mass.numerator() * divide_exactly(cleared, argument.mass.denominator());
    const Integer parameter =
        knots_.denominator() * argument.u.numerator() * divide_exactly(cleared, argument.u.denominator());
    const std::vector<Integer>& knots = knots_.numerators();
    const std::size_t n = knots.size() / 2;
    const std::size_t entries = n - level_;
    std::vector<Integer> divisors;
    divisors.reserve(entries);
    Integer common = 1;
    for (std::size_t l = 0; l < entries; ++l) {
        divisors.push_back(knots[n + l] - knots[level_ + l]);
        if (common.bit_length() <= bits_of_small_denominator) common = lcm(common, divisors[l]);
    }
    const bool small = common.bit_length() <= bits_of_small_denominator;
    for (std::size_t l = 0; l < entries; ++l) {
        Integer left = knots[n + l] * mass - parameter;
        Integer right = parameter - knots[level_ + l] * mass;
        if (small && common != divisors[l]) {
            const Integer scale = divide_exactly(common, divisors[l]);
            left *= scale;
            right *= scale;
        }
        for (auto& row : rows_) {
            row[l] *= left;
            row[l].add_product(right, row[l + 1]);
        }
    }
    for (auto& row : rows_) row.pop_back();
    denominator_ *= cleared * (small ? common : divide_entries(rows_, divisors));
    ++level_;
    std::size_t bits = denominator_.bit_length();
    for (const auto& row : rows_) bits = std::max(bits, greatest_bit_length(row));
    require_result_bits(bits, limits_);
}

Coordinates ProgressiveDescent::entry(std::size_t l) const {
    Coordinates point;
    point.reserve(rows_.size());
    for (const auto& row : rows_) point.emplace_back(row[l], denominator_);
    return point;
}

}  // namespace blossom
