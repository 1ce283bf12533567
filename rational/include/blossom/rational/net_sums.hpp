#pragma once

#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace blossom {

/// One factor of the domain of a patch: a simplex of some dimension, with the degree that the map has in it.
/// The multi-indices (i_0, ..., i_s) of sum n are in lexicographically descending order.
struct SimplexFactor {
    std::size_t dimension = 1;
    std::size_t degree = 0;

    friend bool operator==(const SimplexFactor&, const SimplexFactor&) = default;
};

/// Tuples of s + 1 integers for each factor of a net, in order: tuple i stands for its entries divided by
/// scales[i] > 0. Words are not the least value of 64 bits.
template <class R>
struct NetArguments {
    std::span<const R> entries;
    std::span<const R> scales;
};

/// Rows of numbers c_ji over one denominator in the shape of a net on a product of simplices, the index of
/// the last factor moving fastest, prepared for sums of products with weights,
///
///     s_j = sum_i c_ji w_0(i_0) w_1(i_1) ...,
///
/// one list of weights per factor. They are computed in 64 or 128 bits while these provably suffice, then
/// modulo primes, or in integers where the net is small. No denominator is inverted, and each sum is reduced
/// once. Copies share what was prepared.
class NetSums {
public:
    /// `rows` rows, one after the other. |s_j| is at most `greatest` times the sum of the absolute values of
    /// the entries of every tuple, those of `values` as often as the degree says.
    NetSums(RationalVector numbers, std::size_t rows, std::vector<SimplexFactor> shape, Integer greatest);

    std::size_t rows() const;
    std::span<const SimplexFactor> shape() const;

    /// A bound on the bits of a sum and of its denominator, where the entries of each tuple sum up to so many
    /// bits and its scale has as many.
    std::size_t sum_bits(std::size_t bits_of_tuple) const;

    /// The values of homogeneous polynomials with these coefficients: the weights are the monomials x^i at
    /// one tuple x per factor. There are as many sums as rows.
    ///
    /// Cost: (s + 2) multiplications for each weight and a multiply-add for each number of a row.
    void values(const NetArguments<std::int64_t>& tuples, std::span<Rational> sums) const;
    void values(const NetArguments<Integer>& tuples, std::span<Rational> sums) const;

    /// The values of the multilinear maps with these values at the unit vectors: the weights are the
    /// coefficients of prod_j sum_k x_jk X_k for n tuples x_j per factor of degree n.
    ///
    /// Cost: (s + 1) C(n + s, s + 1) multiply-adds per factor, s C(n + s, s) where all tuples are equal, and
    /// one for each number of a row.
    void multilinear_values(const NetArguments<std::int64_t>& tuples, std::span<Rational> sums) const;
    void multilinear_values(const NetArguments<Integer>& tuples, std::span<Rational> sums) const;

    struct Prepared;  ///< defined in the private sources

private:
    std::shared_ptr<const Prepared> prepared_;
};

/// C(n, i) for the multi-indices i of a factor of degree n, in order: n! / (i_0! ... i_s!).
std::vector<Integer> multinomial_row(const SimplexFactor& factor);

}  // namespace blossom
