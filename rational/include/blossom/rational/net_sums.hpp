#pragma once

#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace blossom {

/// One factor of the domain of a patch: a simplex of some dimension, and the degree of the map in it. The
/// multi-indices (i_0, ..., i_s) of sum n are in descending lexicographic order.
struct SimplexFactor {
    std::size_t dimension = 1;
    std::size_t degree = 0;

    friend bool operator==(const SimplexFactor&, const SimplexFactor&) = default;
    friend std::string to_string(const SimplexFactor& factor) {
        return "degree " + std::to_string(factor.degree) + " on a simplex of dimension " +
               std::to_string(factor.dimension);
    }
    friend std::size_t hash_value(const SimplexFactor& factor) {
        return hash_of(factor.dimension, factor.degree);
    }
};

/// Tuples of s + 1 integers for each factor of a net, in order: tuple i stands for its entries divided by
/// scales[i] > 0. Machine words are not the least 64-bit value.
template <class R>
struct NetArguments {
    std::span<const R> entries;
    std::span<const R> scales;
};

/// Rows of numbers c_ji over one denominator in the shape of a net on a product of simplices, where the index
/// of the last factor changes fastest, prepared for sums of products with weights,
///
///     s_j = sum_i c_ji w_0(i_0) w_1(i_1) ...,
///
/// with one list of weights per factor. The sums are computed in 64 or 128 bits if these provably suffice,
/// otherwise modulo primes, or in integers if the net is small. No denominator is inverted, and each sum is
/// reduced once. Copies share the prepared data.
class NetSums {
public:
    /// `numbers` holds `rows` rows, one after the other. |s_j| is at most `greatest` times the sum of the
    /// absolute values of the entries of every tuple; a tuple of `values` counts as often as its degree.
    NetSums(RationalVector numbers, std::size_t rows, std::vector<SimplexFactor> shape, Integer greatest);

    std::size_t rows() const;
    std::span<const SimplexFactor> shape() const;

    /// A bound on the bits of a sum and of its denominator, if the sum of the entries and the scale of each
    /// tuple have at most this many bits.
    std::size_t sum_bits(std::size_t bits_of_tuple) const;

    /// The values of homogeneous polynomials with these coefficients: the weights are the monomials x^i at
    /// one tuple x per factor. There is one sum per row.
    ///
    /// Cost: (s + 2) multiplications per weight and one multiply-add per number of a row.
    void values(const NetArguments<std::int64_t>& tuples, std::span<Rational> sums) const;
    void values(const NetArguments<Integer>& tuples, std::span<Rational> sums) const;

    /// The values of the multilinear maps with these values at the unit vectors: the weights are the
    /// coefficients of prod_j sum_k x_jk X_k for n tuples x_j per factor of degree n.
    ///
    /// Cost: (s + 1) C(n + s, s + 1) multiply-adds per factor, or s C(n + s, s) if all its tuples are equal,
    /// and one per number of a row.
    void multilinear_values(const NetArguments<std::int64_t>& tuples, std::span<Rational> sums) const;
    void multilinear_values(const NetArguments<Integer>& tuples, std::span<Rational> sums) const;

    struct Prepared;  ///< defined in the private sources

private:
    std::shared_ptr<const Prepared> prepared_;
};

/// C(n, i) for the multi-indices i of a factor of degree n, in order: n! / (i_0! ... i_s!).
std::vector<Integer> multinomial_row(const SimplexFactor& factor);

}  // namespace blossom
