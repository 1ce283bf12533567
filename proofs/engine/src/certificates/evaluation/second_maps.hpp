#pragma once

#include "second_counting.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace blossom::proofs::second {

/// One direction of a map: the exponents of the monomials of degree at most `degree` in `dimension`
/// coordinates.
struct Direction {
    std::size_t dimension = 1;
    std::size_t degree = 0;
    std::vector<std::vector<std::size_t>> monomials;
    std::map<std::vector<std::size_t>, std::size_t>
        places;  ///< of the monomials, if there are several coordinates

    std::size_t place(const std::vector<std::size_t>& exponents) const;
};

/// A map of one case: its coefficients are numbered by products of monomials, one per direction; the last
/// direction changes fastest.
struct MapShape {
    std::vector<Direction> directions;

    std::size_t size() const;
    /// The exponents, in all directions, of a coefficient.
    std::vector<std::size_t> exponents(std::size_t place) const;
    /// ".1.0"
    std::string suffix(std::size_t place) const;
};

Direction direction_of(std::size_t dimension, std::size_t degree, const Limits& limits);

/// degree! / (e_1! ... e_s! (degree - sum e)!)
Rational multinomial(std::size_t degree, const std::vector<std::size_t>& exponents);

/// The degrees and dimensions of a map in the case of `counting`.
MapShape shape_of_map(const Reading& reading, std::uint32_t map, Counting& counting);

}  // namespace blossom::proofs::second
