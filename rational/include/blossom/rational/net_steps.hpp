#pragma once

#include <blossom/rational/net_sums.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// Integers in the shape of nets of one factor of a product of simplices, one net after the other, with
/// `behind` numbers per multi-index.
struct FactorNets {
    std::span<const Integer> numbers;
    SimplexFactor factor;
    std::size_t behind = 1;
};

/// The nets with the degree n of the factor raised by one, times n + 1: entry i is sum_k i_k * entry (i -
/// e_k).
///
/// Cost: s + 1 multiply-adds per number, in words of a width that provably suffices.
std::vector<Integer> raised_by_one(const FactorNets& nets);

/// For each vertex, the nets over the frame in which the argument with the coordinates entries[k] / scale
/// replaces this vertex, times scale^n: entry i is entry i - i_v e_v of level i_v of de Casteljau's pyramid
/// at the argument.
///
/// Cost: one pyramid for all vertices, C(n + s, s + 1) entries of s + 1 multiply-adds, in words of a width
/// that provably suffices on each level, and one product per number of the result.
std::vector<std::vector<Integer>> with_vertices_replaced(const FactorNets& nets,
                                                         std::span<const Integer> entries,
                                                         const Integer& scale,
                                                         std::span<const std::size_t> vertices);

}  // namespace blossom
