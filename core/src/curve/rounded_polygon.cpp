#include "rounded_polygon.hpp"

#include <blossom/rational/resource_budget.hpp>

#include <algorithm>

namespace blossom {

RoundedPolygon::RoundedPolygon(std::span<const Integer> polygon) {
    constexpr std::size_t bits = 120;
    constexpr std::size_t low_bits = 60;
    std::size_t longest = 0;
    for (const Integer& point : polygon) longest = std::max(longest, point.bit_length());
    const std::size_t surplus = longest > bits ? longest - bits : 0;
    points_.reserve(polygon.size());
    for (const Integer& point : polygon) {
        const Integer rounded = abs(point) >> surplus;
        const Integer high = rounded >> low_bits;
        const Word magnitude = (Word{high.word()} << low_bits) + (rounded - (high << low_bits)).word();
        points_.push_back(point.sign() < 0 ? -magnitude : magnitude);
    }
}

// Points of unknown sign are counted with the least and with the greatest possible number of changes: a run
// of them between two known points adds none, or one or two per point.
SignChanges RoundedPolygon::sign_changes() const {
    SignChanges changes;
    int last = 0;
    std::size_t unknown = 0;
    const auto error = static_cast<Word>(error_);
    for (const Word point : points_) {
        if (point <= error && point >= -error) {
            ++unknown;
            continue;
        }
        const int sign = point > 0 ? 1 : -1;
        const bool change = last != 0 && sign != last;
        changes.least += change ? 1 : 0;
        // All u + 1 steps over u unknown points may be changes, as far as the parity permits.
        const std::size_t steps = last == 0 ? unknown : unknown + 1;
        changes.most += last == 0 || (steps % 2 == 1) == change ? steps : steps - 1;
        last = sign;
        unknown = 0;
    }
    changes.most += last == 0 ? points_.size() : unknown;
    return changes;
}

std::pair<RoundedPolygon, RoundedPolygon> RoundedPolygon::halves() && {
    const std::size_t n = points_.size() - 1;
    spend_work(n * (n + 1));
    std::vector<Word> left(n + 1);
    std::vector<Word>& points = points_;
    for (std::size_t r = 0; r <= n; ++r) {
        left[r] = points[0];
        for (std::size_t i = 0; i + r < n; ++i) points[i] = (points[i] + points[i + 1]) >> 1;
    }
    // Position i finally holds the last point of level n - i: the right half.
    const std::size_t error = error_ + n / 2 + 1;
    return {RoundedPolygon(std::move(left), error), RoundedPolygon(std::move(points_), error)};
}

}  // namespace blossom
