#include "label_placement.hpp"
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace blossom::worked {

namespace {

constexpr Length dot_radius = 50;
constexpr Length clearance = 20;

// What each fault of a place counts.
constexpr std::int64_t off_paper = 100'000;
constexpr std::int64_t on_label = 20'000;
constexpr std::int64_t on_dot = 5'000;
constexpr std::int64_t leader_on_label = 4'000;
constexpr std::int64_t on_line = 600;
constexpr std::int64_t each_step_away = 90;

Box dot(const Spot& spot) {
    return {spot.x - dot_radius, spot.y - dot_radius, spot.x + dot_radius, spot.y + dot_radius};
}

Box grown(const Box& box, Length by) {
    return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

bool inside(const Box& box, const Box& paper) {
    return box.left >= paper.left && box.right <= paper.right && box.top >= paper.top &&
           box.bottom <= paper.bottom;
}

/// On which side of the line through the segment a point lies.
std::int64_t side(const Segment& segment, Length x, Length y) {
    return (segment.end.x - segment.begin.x) * (y - segment.begin.y) -
           (segment.end.y - segment.begin.y) * (x - segment.begin.x);
}

struct Direction8 {
    int x;
    int y;
};

/// The places around a point, the preferred ones first.
constexpr std::array<Direction8, 8> directions{
    {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}}};
constexpr Length distances_tried = 9;

Box candidate(const LabelSize& label, const Direction8& direction, Length step) {
    const Length reach = dot_radius + clearance + step * 110;
    const bool slanted = direction.x != 0 && direction.y != 0;
    const Length away = slanted ? reach * 7 / 10 : reach;
    const auto from = [&](int sign, Length anchor, Length size) {
        if (sign > 0) return anchor + away;
        return sign < 0 ? anchor - away - size : anchor - size / 2;
    };
    const Length left = from(direction.x, label.anchor.x, label.width);
    const Length top = from(direction.y, label.anchor.y, label.height);
    return {left, top, left + label.width, top + label.height};
}

class Placement {
public:
    Placement(const std::vector<LabelSize>& labels, const std::vector<Segment>& segments, const Box& paper)
        : labels_(labels), segments_(segments), paper_(paper), placed_(labels.size()) {}

    std::vector<PlacedLabel> run() {
        for (int round = 0; round < 6; ++round) {
            bool changed = false;
            for (std::size_t i = 0; i < labels_.size(); ++i) changed = improve(i) || changed;
            if (!changed) break;
        }
        return mapped(placed_, [&](const auto& label) { return *label; });
    }

private:
    /// Puts label i at its cheapest place; whether that moved it.
    bool improve(std::size_t i) {
        std::optional<PlacedLabel> best;
        std::int64_t lowest = 0;
        for (Length step = 0; step < distances_tried; ++step) {
            for (std::size_t d = 0; d < directions.size(); ++d) {
                const PlacedLabel label{candidate(labels_[i], directions[d], step), step > 1};
                const std::int64_t cost =
                    this->cost(i, label) + step * each_step_away + static_cast<std::int64_t>(d);
                if (!best || cost < lowest) {
                    best = label;
                    lowest = cost;
                }
            }
        }
        const bool changed = !placed_[i] || placed_[i]->box != best->box;
        placed_[i] = best;
        return changed;
    }

    std::int64_t cost(std::size_t i, const PlacedLabel& label) const {
        std::int64_t cost = inside(label.box, paper_) ? 0 : off_paper;
        const Box roomy = grown(label.box, clearance);
        const Segment lead = leader(labels_[i].anchor, label.box);
        for (std::size_t j = 0; j < labels_.size(); ++j) {
            if (overlap(roomy, dot(labels_[j].anchor))) cost += on_dot;
            if (j == i || !placed_[j]) continue;
            if (overlap(roomy, placed_[j]->box)) cost += on_label;
            if (label.away && crosses(lead, placed_[j]->box)) cost += leader_on_label;
            if (placed_[j]->away && crosses(leader(labels_[j].anchor, placed_[j]->box), label.box)) {
                cost += leader_on_label;
            }
        }
        for (const Segment& segment : segments_) {
            if (crosses(segment, roomy)) cost += on_line;
        }
        return cost;
    }

    const std::vector<LabelSize>& labels_;
    const std::vector<Segment>& segments_;
    const Box& paper_;
    std::vector<std::optional<PlacedLabel>> placed_;
};

}  // namespace

bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool crosses(const Segment& segment, const Box& box) {
    const Box around{std::min(segment.begin.x, segment.end.x), std::min(segment.begin.y, segment.end.y),
                     std::max(segment.begin.x, segment.end.x), std::max(segment.begin.y, segment.end.y)};
    const bool apart = around.right <= box.left || around.left >= box.right || around.bottom <= box.top ||
                       around.top >= box.bottom;
    if (apart) return false;
    const std::array<std::int64_t, 4> sides{
        side(segment, box.left, box.top), side(segment, box.right, box.top),
        side(segment, box.left, box.bottom), side(segment, box.right, box.bottom)};
    const auto [lowest, highest] = std::ranges::minmax(sides);
    return lowest < 0 && highest > 0;
}

Segment leader(const Spot& anchor, const Box& box) {
    return {anchor, {std::clamp(anchor.x, box.left, box.right), std::clamp(anchor.y, box.top, box.bottom)}};
}

std::vector<PlacedLabel> place_labels(const std::vector<LabelSize>& labels,
                                      const std::vector<Segment>& segments, const Box& paper) {
    return Placement(labels, segments, paper).run();
}

}  // namespace blossom::worked
