#pragma once

// Rows of integers in two's complement of a width that provably suffices, so that no step allocates or
// overflows.

#include <blossom/rational/blossom_sums.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limbs/limb_sums.hpp"
#include "number/backend.hpp"
#include "number/uint128.hpp"

namespace blossom::fixed_width {

/// An upper bound on the bits of a product of positive numbers, in integer arithmetic: factors are multiplied
/// exactly while the product fits in a word, and each full word counts with its bit width.
class BitBound {
public:
    explicit BitBound(std::size_t bits = 0) : full_(bits) {}

    void multiply(std::uint64_t factor) {
        if (factor == 0) return;
        std::uint64_t product = 0;
        if (__builtin_mul_overflow(open_, factor, &product)) {
            full_ += width(open_);
            product = factor;
        }
        open_ = product;
    }
    void multiply(UInt128 factor) {
        if (factor >> 64 == 0) return multiply(static_cast<std::uint64_t>(factor));
        full_ += width(open_) + width(factor);
        open_ = 1;
    }
    std::size_t bits() const { return full_ + width(open_); }

private:
    static std::size_t width(UInt128 value) {
        const auto high = static_cast<std::uint64_t>(value >> 64);
        const auto low = static_cast<std::uint64_t>(value);
        return static_cast<std::size_t>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(low));
    }

    std::size_t full_;
    std::uint64_t open_ = 1;  ///< at least 1
};

/// A row whose entries have many words each. The width in use grows with the bound, level by level.
class LimbRow {
public:
    /// `start_bits` bounds the bits of the entries before the first level, `final_bits` those after the last.
    LimbRow(std::size_t size, std::size_t start_bits, std::size_t final_bits);

    void set_weights(std::int64_t own, std::int64_t neighbours);
    void combine(std::size_t k, std::size_t neighbour);
    void scale(std::size_t k) { combine(k, k, 0); }

    /// Multiplies the polynomial in entries 0..degree by `factor`, whose magnitudes sum to less than 2^63.
    void multiply(std::span<const std::int64_t> factor, std::size_t degree);

    /// Multiplies entry 0, the others being zero, by the factors in as few passes as possible: factors whose
    /// product has coefficients of one word are multiplied first.
    void multiply_out(std::span<const WordFactor> factors);

    void set(std::size_t k, const Integer& value);
    Integer integer(std::size_t k) const;
    /// The entries as stored; `negated` tells whether they stand for their negatives.
    LimbView limbs() const { return {words_.data(), width_, stride_}; }
    bool negated() const { return negated_; }

private:
    static std::size_t words_for(std::size_t bits) { return bits / 64 + 1; }
    std::uint64_t* entry(std::size_t k) { return words_.data() + k * stride_; }
    void combine(std::size_t k, std::size_t neighbour, std::uint64_t neighbours);
    void widen();

    std::size_t stride_;
    std::size_t width_;
    BitBound bound_;
    std::vector<std::uint64_t> words_;
    std::uint64_t own_ = 0;  ///< the magnitudes of the weights; the sign of the level is moved to `negated_`
    std::uint64_t neighbours_ = 0;
    bool subtract_ = false;
    bool negated_ = false;  ///< whether every entry stands for its negative
};

}  // namespace blossom::fixed_width
