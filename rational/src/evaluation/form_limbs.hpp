#pragma once

// Homogeneous polynomials at pairs of words, on rows of words of fixed length.

#include <blossom/rational/integer.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace blossom {

/// sum_k C_k u^k v^(n-k) by Horner's rule in powers of u and v that fill a word.
class FormLimbs {
public:
    /// The most words of a coefficient and of a value.
    static constexpr std::size_t most_coefficient_words = 8;
    static constexpr std::size_t most_words = 64;

    FormLimbs() = default;
    /// Only for coefficients of at most 64 most_coefficient_words bits.
    explicit FormLimbs(std::span<const Integer> coefficients);

    bool empty() const { return parts_.empty(); }
    /// The magnitude of the value into `value`, whose length is enough for it and its sign; whether it is
    /// negative. Neither u nor v is the least value of 64 bits, and v > 0.
    bool evaluate(std::int64_t u, std::int64_t v, std::span<std::uint64_t> value) const;

private:
    std::size_t bits_ = 0;             ///< of the greatest magnitude
    std::size_t width_ = 0;            ///< parts a coefficient
    std::vector<std::int64_t> parts_;  ///< of 62 bits with the sign of the coefficient: sums of products fit
};

}  // namespace blossom
