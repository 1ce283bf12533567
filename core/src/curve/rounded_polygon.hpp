#pragma once

#include <blossom/rational/integer.hpp>

#include <span>
#include <utility>
#include <vector>

namespace blossom {

/// A lower and an upper bound on the sign changes of a control polygon.
struct SignChanges {
    std::size_t least = 0;
    std::size_t most = 0;
};

/// The control polygon of a polynomial up to a positive factor, with points rounded to words of 128 bits and
/// a bound on their errors. Its statements about signs hold for the exact polygon.
class RoundedPolygon {
public:
    explicit RoundedPolygon(std::span<const Integer> polygon);

    SignChanges sign_changes() const;

    /// The polygons over both halves: de Casteljau's algorithm at the midpoint, where each level adds at most
    /// half a unit to the errors. Cost: n^2 / 2 additions of words.
    std::pair<RoundedPolygon, RoundedPolygon> halves() &&;

private:
    __extension__ using Word = __int128;

    RoundedPolygon(std::vector<Word> points, std::size_t error) : points_(std::move(points)), error_(error) {}

    std::vector<Word> points_;
    std::size_t error_ = 1;  ///< a bound on the distance of each exact point from its word
};

}  // namespace blossom
