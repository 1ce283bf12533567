#pragma once

#include <cstdint>
#include <vector>

namespace blossom::worked {

/// Lengths on paper are integers, tenths of a pixel.
using Length = std::int64_t;

/// A point on paper, y downwards.
struct Spot {
    Length x = 0;
    Length y = 0;

    friend bool operator==(const Spot&, const Spot&) = default;
};

struct Box {
    Length left = 0;
    Length top = 0;
    Length right = 0;
    Length bottom = 0;

    friend bool operator==(const Box&, const Box&) = default;
};

struct Segment {
    Spot begin;
    Spot end;
};

bool overlap(const Box& a, const Box& b);
/// Whether a segment enters the inside of a box. Exact.
bool crosses(const Segment& segment, const Box& box);

/// A label of the given size for a point.
struct LabelSize {
    Spot anchor;
    Length width = 0;
    Length height = 0;
};

struct PlacedLabel {
    Box box;
    bool away = false;  ///< so far from its point that a line should lead to it
};

/// Places for the labels within `paper`, off the dots around all anchors, each other and, as far as there is
/// room, the segments.
///
/// Greedy: each label in turn takes the cheapest of the places around its point; then each is moved again
/// with the others in place, until nothing changes. Cost: candidates times obstacles, a few rounds.
std::vector<PlacedLabel> place_labels(const std::vector<LabelSize>& labels,
                                      const std::vector<Segment>& segments, const Box& paper);

/// From the point to the nearest place of its label's box.
Segment leader(const Spot& anchor, const Box& box);

}  // namespace blossom::worked
