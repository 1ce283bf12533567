#pragma once

#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace blossom {

/// Polynomials sum_k c_jk t^k of one formal degree n over one denominator D, prepared to be evaluated many
/// times.
///
/// With t = u/v a value is N / (D v^n), N = sum_k C_k u^k v^(n-k): words while they provably hold N, then
/// rows of words, then integers by halves, each half over its own denominator. What N shares with the
/// denominator follows mostly from the coefficients: a prime that divides N and v divides C_n, and one that
/// divides D but all C_k except C_j divides N only with u or v. Copies share what was prepared.
class PreparedPolynomial {
public:
    /// `numbers` are `rows` rows of n + 1 coefficients, lowest first, one after the other.
    PreparedPolynomial(RationalVector numbers, std::size_t rows);

    std::size_t rows() const;
    /// n
    std::size_t degree() const;
    /// A bound on the bits of the numerators and of the denominator of a value at t with so many bits.
    std::size_t value_bits(std::size_t bits_of_t) const;

    /// The values of all rows at t, as many as there are places.
    /// Cost: 2 n multiply-adds in words, or products of halves of n h bits, h the bits of t, and gcds of
    /// numbers of the size of t or of what denominators of the coefficients share.
    void evaluate(const Rational& t, std::span<Rational> values) const;
    /// The same at numerator / denominator in lowest terms, the denominator positive, neither of them the
    /// least value of 64 bits.
    void evaluate(std::int64_t numerator, std::int64_t denominator, std::span<Rational> values) const;

    struct Forms;  ///< defined in the private sources

private:
    std::shared_ptr<const Forms> prepared_;
};

}  // namespace blossom
