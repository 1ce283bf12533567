#pragma once

// Arguments as the kernels of patches need them: integers, with the denominators that were cleared.

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

    /// A bound on the bits of the scale and of the sum of the absolute values of the entries.
    std::size_t bits() const;
};

/// Clears a tuple by its least denominator.
IntegerTuple cleared(const Coordinates& tuple);

/// Tuples as words, if they fit in words and in the fixed-size arrays.
/// The unused part of the arrays is left uninitialized, because clearing it would take longer than the
/// computation.
/// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class WordTuples {
public:
    /// Adds a tuple over its least denominator. Returns whether there is room and words hold it; otherwise
    /// the object must not be used any more.
    bool add(const Coordinates& tuple);
    /// The entries and the scale of the tuple added last.
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
    /// Adds a tuple that counts `times`.
    void add(const Coordinates& tuple, std::size_t times);
    /// The entries and the scale of the tuple added last.
    std::pair<std::span<const Integer>, const Integer&> last() const {
        return {std::span(entries_).subspan(last_), scales_.back()};
    }
    /// A bound on the bits of the product, over the tuples, of the sums of absolute values of the entries.
    std::size_t bits() const { return bits_; }
    NetArguments<Integer> arguments() const { return {entries_, scales_}; }

private:
    std::vector<Integer> entries_;
    std::vector<Integer> scales_;
    std::size_t last_ = 0;  ///< the first entry of the last tuple
    std::size_t bits_ = 0;
};

/// Lists of tuples as integers: a blossom value at `tuples` is `denominator` times the value at the
/// arguments.
struct IntegerArguments {
    TupleLists<Integer> tuples;
    Integer denominator = 1;
    std::size_t bits = 0;
};

/// Clears each tuple by its own denominator. Errors: `limit_exceeded` if the value of a net with entries of
/// `net_bits` bits at these arguments would be too large.
IntegerArguments cleared_one_by_one(const PatchArguments& arguments, std::size_t net_bits,
                                    const Limits& limits);
/// Clears the tuples of each factor by one denominator, so that their sums are integers.
IntegerArguments cleared_together(const PatchArguments& arguments, std::size_t net_bits,
                                  const Limits& limits);

/// The largest bit length of the numerators of a net.
std::size_t bits_of(const PointArray& points);
/// The largest absolute value of a numerator.
Integer greatest_magnitude(const PointArray& points);

/// Points from numerators over one denominator, stored coordinate by coordinate, made canonical.
PointArray canonical_points(std::size_t dimension, std::vector<Integer> numerators,
                            const Integer& denominator);
/// The same from one row of numerators per coordinate.
PointArray canonical_points(const std::vector<std::vector<Integer>>& rows, const Integer& denominator);

/// Applies the same operation to the row of every coordinate.
template <class Row>
std::vector<std::vector<Integer>> each_row(const PointArray& points, const Row& row) {
    std::vector<std::vector<Integer>> rows;
    rows.reserve(points.dimension());
    for (const auto coordinate : points.rows()) rows.push_back(row(coordinate));
    return rows;
}

}  // namespace blossom
