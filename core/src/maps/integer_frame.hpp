#pragma once

// What the kernels need of arguments and intervals: integers, with the denominators that were cleared.

#include <blossom/core/constructions/constructions.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// Arguments (u, v) as integer pairs: the value of a blossom at `pairs` is `denominator()` times that at the
/// arguments.
struct ClearedArguments {
    std::vector<HomogeneousPair<Integer>> pairs;
    std::vector<Integer> scales;  ///< what each argument was multiplied by
    std::size_t bits = 0;         ///< bounds the bits of prod (|u_i| + |v_i|)

    /// The product of the scales, large: asked for once `bits` has been found to be within the limits.
    Integer denominator() const;
};

/// Each argument over its own denominator, as few bits as possible.
ClearedArguments cleared_one_by_one(std::span<const Argument> arguments);

/// The interval [a/q, b/q].
struct ClearedInterval {
    Integer a;
    Integer b;
    Integer q;
    std::size_t bits() const { return std::max(a.bit_length(), b.bit_length()) + q.bit_length() + 1; }
};
ClearedInterval cleared(const Interval& interval);

/// numerators / denominator in lowest terms.
Coordinates reduced(const Quotients<Integer>& value, const Integer& denominator);

/// Rows of integers over one denominator as points, one row a coordinate; each is scaled to the common
/// denominator.
PointArray point_array(std::vector<Quotients<Integer>> rows, const Integer& denominator);

}  // namespace blossom
