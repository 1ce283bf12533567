#pragma once

// Arguments and intervals as the kernels need them: integers, with the denominators that were cleared.

#include <blossom/core/constructions/constructions.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// Arguments (u, v) as integer pairs: the value of a blossom at `pairs` is `denominator()` times the value at
/// the arguments.
struct ClearedArguments {
    std::vector<HomogeneousPair<Integer>> pairs;
    std::vector<Integer> scales;  ///< the factors by which the arguments were multiplied
    std::size_t bits = 0;         ///< a bound on the bits of prod (|u_i| + |v_i|)

    /// The product of the scales. It can be large; callers first check that `bits` is within the limits.
    Integer denominator() const;
};

/// Clears each argument by its own denominator, which gives the fewest bits.
ClearedArguments cleared_one_by_one(std::span<const Argument> arguments);

/// The interval [a/q, b/q].
struct ClearedInterval {
    Integer a;
    Integer b;
    Integer q;
    std::size_t bits() const { return std::max(a.bit_length(), b.bit_length()) + q.bit_length() + 1; }
};
ClearedInterval cleared(const Interval& interval);

/// Coordinates numerators / denominator in lowest terms.
Coordinates reduced(const Quotients<Integer>& value, const Integer& denominator);

/// Points from rows of integers, one row per coordinate, each over its own factor of the common denominator,
/// to which they are scaled.
PointArray point_array(std::vector<Quotients<Integer>> rows, const Integer& denominator);

}  // namespace blossom
