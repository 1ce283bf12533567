#pragma once

// Homogeneous polynomials at pairs of words, evaluated in rows of words of fixed length.

#include <blossom/rational/integer.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace blossom {

/// sum_k C_k u^k v^(n-k) by Horner's rule in blocks of powers of u and v that fill a word.
class FormLimbs {
public:
    /// The most words of a coefficient and of a value.
    static constexpr std::size_t most_coefficient_words = 8;
    static constexpr std::size_t most_words = 64;

    FormLimbs() = default;
    /// For coefficients of at most 64 most_coefficient_words bits.
    explicit FormLimbs(std::span<const Integer> coefficients);

    bool empty() const { return parts_.empty(); }
    /// Writes the magnitude of the value to `value`, which is long enough for it and a sign, and returns
    /// whether it is negative. Neither u nor v is the least 64-bit value, and v > 0.
    bool evaluate(std::int64_t u, std::int64_t v, std::span<std::uint64_t> value) const;

private:
    std::size_t bits_ = 0;             ///< of the largest magnitude
    std::size_t width_ = 0;            ///< parts per coefficient
    std::vector<std::int64_t> parts_;  ///< signed parts of 62 bits, so that sums of products fit
};

}  // namespace blossom
