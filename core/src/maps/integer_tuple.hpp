#pragma once

// What the kernels of patches need of arguments: integers, with the denominators that were cleared.

#include <blossom/core/constructions/net_constructions.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// A tuple as integers: `entries` is `scale` times the tuple.
struct IntegerTuple {
    Tuple<Integer> entries;
    Integer scale;

    /// Bounds the bits of the sum of the absolute values of the entries, and of the scale.
    std::size_t bits() const;
};

/// Over its own least denominator.
IntegerTuple cleared(const Coordinates& tuple);

/// Lists of tuples as integers: a blossom at `tuples` is `denominator` times that at the arguments.
struct IntegerArguments {
    TupleLists<Integer> tuples;
    Integer denominator = 1;
    std::size_t bits = 0;
};

/// Each tuple over its own denominator. Errors: `limit_exceeded` when a value at them, of a net with entries
/// of `net_bits` bits, would be too large.
IntegerArguments cleared_one_by_one(const PatchArguments& arguments, std::size_t net_bits,
                                    const Limits& limits);
/// The tuples of each factor over one denominator, so that their sums stay integers.
IntegerArguments cleared_together(const PatchArguments& arguments, std::size_t net_bits,
                                  const Limits& limits);

/// The largest bit length of the numerators of a net.
std::size_t bits_of(const PointArray& points);

/// One row of numerators a coordinate over one denominator, made canonical.
PointArray canonical_points(const std::vector<std::vector<Integer>>& rows, const Integer& denominator);

/// The same operation on the row of every coordinate.
template <class Row>
std::vector<std::vector<Integer>> each_row(const PointArray& points, const Row& row) {
    std::vector<std::vector<Integer>> rows;
    rows.reserve(points.dimension());
    for (const auto coordinate : points.rows()) rows.push_back(row(coordinate));
    return rows;
}

}  // namespace blossom
