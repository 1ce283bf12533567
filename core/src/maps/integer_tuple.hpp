#pragma once

// What the kernels of patches need of arguments: integers, with the denominators that were cleared.

#include <blossom/core/constructions/net_constructions.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/net_sums.hpp>

#include <cstdint>
#include <span>
#include <utility>

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

/// Tuples as words, as long as these and the places in the object suffice.
// The unused part of the arrays is left uninitialized: clearing it would cost more than the work.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class WordTuples {
public:
    /// Whether there is room and words hold the tuple over its least denominator; otherwise the object is of
    /// no more use.
    bool add(const Coordinates& tuple);
    /// The entries and the scale of the tuple that was added last.
    std::pair<std::span<const std::int64_t>, std::int64_t> last() const {
        return {{entries_ + last_, size_ - last_}, scales_[count_ - 1]};
    }
    NetArguments<std::int64_t> arguments() const { return {{entries_, size_}, {scales_, count_}}; }

private:
    static constexpr std::size_t most_entries = 128;

    std::size_t size_ = 0;
    std::size_t last_ = 0;  ///< the first entry of the last tuple
    std::size_t count_ = 0;
    std::int64_t entries_[most_entries];
    std::int64_t scales_[most_entries];
};

/// Tuples as integers.
class IntegerTuples {
public:
    /// For a tuple that counts `times`.
    void add(const Coordinates& tuple, std::size_t times);
    /// The entries and the scale of the tuple that was added last.
    std::pair<std::span<const Integer>, const Integer&> last() const {
        return {std::span(entries_).subspan(last_), scales_.back()};
    }
    /// Bounds the bits of the product of the sums of absolute values of the entries of each tuple.
    std::size_t bits() const { return bits_; }
    NetArguments<Integer> arguments() const { return {entries_, scales_}; }

private:
    std::vector<Integer> entries_;
    std::vector<Integer> scales_;
    std::size_t last_ = 0;  ///< the first entry of the last tuple
    std::size_t bits_ = 0;
};

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
/// The greatest absolute value of a numerator.
Integer greatest_magnitude(const PointArray& points);

/// Numerators over one denominator, those of each of the coordinates after the other, made canonical.
PointArray canonical_points(std::size_t dimension, std::vector<Integer> numerators,
                            const Integer& denominator);
/// One row of numerators a coordinate.
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
