#pragma once

// Sums over products of linear factors of few bits, in digits in vector lanes, if the processor has them.

#include <blossom/rational/blossom_sums.hpp>

#include <algorithm>
#include <vector>

#include "factor_blocks.hpp"
#include "limbs/limb_sums.hpp"
#include "quotients/small_primes.hpp"
#include "vectors/factor_products.hpp"
#include "vectors/fold_blocks.hpp"

namespace blossom {

/// The most words of a sum and its sign.
inline constexpr std::size_t most_digit_words = fold_blocks::most_digits * fold_blocks::digit_bits / 64;

/// Rows of numbers in the form that fold_blocks reads.
class SumDigits {
public:
    SumDigits() = default;
    /// Prepares rows of `size` numbers of at most `bits` bits, `count` numbers in all. Stays empty if a row
    /// has too few or too many numbers, or if the processor lacks the vector instructions.
    SumDigits(LimbView numbers, std::size_t count, std::size_t size, std::size_t bits);

    bool empty() const { return digits_.empty(); }
    /// Whether the digits suffice for numerators of `bits` bits over these factors.
    bool suffice(std::span<const WordFactor> factors, std::size_t bits) const;
    fold_blocks::Columns row(std::size_t j) const {
        return {digits_.data() + j * width_ * stride_, width_, stride_, size_};
    }
    std::size_t bits() const { return bits_; }

private:
    std::size_t size_ = 0;
    std::size_t bits_ = 0;
    std::size_t width_ =
        0;  ///< digits per number, one more than needed, because the first fold reads one more
    std::size_t stride_ = 0;
    std::vector<std::uint64_t> digits_;
};

/// Blocks of factors in the order in which they are folded.
/// The unused part of the array is left uninitialized, because clearing it would take longer than the
/// computation.
/// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class DigitFolds {
public:
    void add(const fold_blocks::Block& block) { blocks_[size_++] = block; }

    /// The sum of one row in two's complement, in as many words as it and its sign need.
    void sum(const fold_blocks::Columns& row, std::span<std::uint64_t> words) const;

    /// The magnitudes of two adjacent blocks sum to at least 2^51, except for two full blocks.
    static constexpr std::size_t most_blocks =
        2 * (fold_blocks::most_digits * fold_blocks::digit_bits / (fold_blocks::digit_bits - 1) + 1) + 3;

private:
    std::size_t size_ = 0;
    fold_blocks::Block blocks_[most_blocks];
};

/// Factors for which `suffice` holds, multiplied in blocks.
class DigitBlocks {
public:
    DigitBlocks(const SumDigits& rows, std::span<const WordFactor> factors, std::size_t bits);

    const DigitFolds& folds() const { return folds_; }

private:
    FactorBlock products_[DigitFolds::most_blocks];
    DigitFolds folds_;
};

/// Factors of few bits, multiplied in vector lanes.
/// The unused part of the product is left uninitialized, because clearing it would take longer than the
/// computation.
/// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class LaneBlocks {
public:
    /// Returns false if the processor has no lanes or they do not suffice; then no other member may be
    /// called.
    bool multiply(const SumDigits& rows, std::span<const WordFactor> factors);

    const DigitFolds& folds() const { return folds_; }
    /// A bound on the bits of the sums.
    std::size_t bits() const { return bits_; }
    /// Words with the same product as the denominators of the factors, and the primes of these words.
    std::span<const std::uint64_t> denominators() const { return {product_.denominators, product_.blocks}; }
    small_primes::Set primes() const { return product_.primes; }

private:
    bool set_folds(const SumDigits& rows, std::size_t count);

    factor_products::Product product_;
    std::size_t bits_ = 0;
    DigitFolds folds_;
};

}  // namespace blossom
