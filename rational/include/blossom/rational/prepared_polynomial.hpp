#pragma once

#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace blossom {

/// Polynomials sum_k c_jk t^k of one formal degree n over one denominator D, prepared for many evaluations.
///
/// At t = u/v the value is N / (D v^n), N = sum_k C_k u^k v^(n-k). N is computed in words if they provably
/// hold it, otherwise in rows of words or, for long numbers, recursively by halves of the coefficients, each
/// half over its own denominator. The common factors of N and the denominator follow mostly from the
/// coefficients: a prime that divides N and v divides C_n, and one that divides D and all C_k except C_j
/// divides N only with u or v. Copies share the prepared data.
class PreparedPolynomial {
public:
    /// `numbers` holds `rows` rows of n + 1 coefficients, lowest first, one after the other.
    PreparedPolynomial(RationalVector numbers, std::size_t rows);

    std::size_t rows() const;
    /// n
    std::size_t degree() const;
    /// A bound on the bits of the numerators and of the denominator of a value at a t of this many bits.
    std::size_t value_bits(std::size_t bits_of_t) const;

    /// The values of all rows at t, one per element of `values`.
    /// Cost: 2 n multiply-adds in words; or products of halves of n h bits, h the bits of t, and gcds of
    /// numbers of the size of t or of the common factors of the coefficients' denominators.
    void evaluate(const Rational& t, std::span<Rational> values) const;
    /// The same at numerator / denominator in lowest terms with a positive denominator; neither is the least
    /// 64-bit value.
    void evaluate(std::int64_t numerator, std::int64_t denominator, std::span<Rational> values) const;

    struct Forms;  ///< defined in the private sources

private:
    std::shared_ptr<const Forms> prepared_;
};

}  // namespace blossom
