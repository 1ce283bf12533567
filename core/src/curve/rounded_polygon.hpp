#pragma once

#include <blossom/rational/integer.hpp>

#include <span>
#include <utility>
#include <vector>

namespace blossom {

/// A bound for the sign changes of a control polygon from below and from above.
struct SignChanges {
    std::size_t least = 0;
    std::size_t most = 0;
};

/// The control polygon of a polynomial up to a positive factor, its points rounded to words of 128 bits, with
/// a bound for their errors. What it says of signs holds for the exact polygon.
class RoundedPolygon {
public:
    explicit RoundedPolygon(std::span<const Integer> polygon);

    SignChanges sign_changes() const;

    /// The polygons over both halves: de Casteljau at the midpoint, where each level adds half a unit to the
    /// errors at most. Cost: n^2 / 2 additions of words.
    std::pair<RoundedPolygon, RoundedPolygon> halves() &&;

private:
    __extension__ using Word = __int128;

    RoundedPolygon(std::vector<Word> points, std::size_t error) : points_(std::move(points)), error_(error) {}

    std::vector<Word> points_;
    std::size_t error_ = 1;  ///< each exact point lies at most this far from its word
};

}  // namespace blossom
