#pragma once

// Sums over few linear factors of any size, in limbs.

#include <blossom/rational/blossom_sums.hpp>

#include <algorithm>
#include <span>
#include <vector>

#include "limbs/limb_sums.hpp"

namespace blossom {

/// The exponent of a power of two above the sum of the magnitudes of both coefficients.
inline std::size_t bits_of(const IntegerFactor& factor) {
    return std::max(factor.constant.bit_length(), factor.slope.bit_length()) + 1;
}

/// The coefficients of a product of linear factors in two's complement, multiplied in place by one factor
/// after the other.
class FactorRow {
public:
    /// The magnitudes of the coefficients sum to less than 2^bits.
    FactorRow(std::span<const IntegerFactor> factors, std::size_t bits);

    LimbView limbs() const { return {words_.data(), width_, stride_}; }

private:
    /// A magnitude in `size` limbs and its sign.
    struct Weight {
        const std::uint64_t* limbs;
        std::size_t size;
        bool negative;
    };

    std::uint64_t* entry(std::size_t k) { return words_.data() + k * stride_; }
    void multiply(const IntegerFactor& factor, std::size_t degree, std::size_t next_width);
    /// own * entry k + neighbours * entry k - 1 in `width` words. A weight without limbs omits its term.
    void combine(std::size_t k, const Weight& own, const Weight& neighbours, std::size_t width);
    void weighted(const std::uint64_t* entry, const Weight& weight, std::size_t width, std::uint64_t* to);

    std::size_t stride_;
    std::size_t width_ = 1;
    std::vector<std::uint64_t> words_;
    std::vector<std::uint64_t> weights_;
    std::vector<std::uint64_t> room_;
};

/// sum_k numbers[k] entries_k in two's complement, modulo 2^64 to the power of sum.size().
void large_dot(std::span<const Integer> numbers, const LimbView& entries, std::span<std::uint64_t> sum);

}  // namespace blossom
