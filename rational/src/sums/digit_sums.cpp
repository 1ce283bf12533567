#include "digit_sums.hpp"

#include <bit>

#include "fixed_width_rows.hpp"
#include "vectors/vector_table.hpp"

namespace blossom {

namespace {

constexpr std::size_t fold_bits = fold_blocks::digit_bits;

constexpr std::uint64_t fold_mask = (std::uint64_t{1} << fold_bits) - 1;
constexpr int block_bits = fold_bits - 1;

/// Up to this many factors, there is room for denominators of any word size.
constexpr std::size_t factors_of_any_denominators = 64;

constexpr factor_products::Primes factor_primes{small_primes::table.of, small_primes::greatest_known};

/// Writes the number with these digits (see fold_blocks::Fold) in two's complement to `words`.
void set_words(std::span<const std::int64_t> digits, std::span<std::uint64_t> words) {
    std::uint64_t proper[fold_blocks::most_digits];  // each below 2^52
    std::int64_t carry = 0;
    for (std::size_t d = 0; d < digits.size(); ++d) {
        const std::int64_t sum = digits[d] + carry;
        proper[d] = static_cast<std::uint64_t>(sum) & fold_mask;
        carry = sum >> fold_bits;
    }
    const std::uint64_t sign = proper[digits.size() - 1] >> (fold_bits - 1) == 0 ? 0 : fold_mask;
    const auto digit = [&](std::size_t d) { return d < digits.size() ? proper[d] : sign; };
    // A word begins in digit d at bit `shift`, and ends in the next digit or the one after it.
    std::size_t d = 0;
    std::size_t shift = 0;
    for (std::uint64_t& word : words) {
        word = digit(d) >> shift | digit(d + 1) << (fold_bits - shift);
        ++d;
        shift += 64 - fold_bits;
        if (shift < fold_bits) continue;
        if (shift > fold_bits) word |= digit(d + 1) << (fold_bits + 64 - shift);
        ++d;
        shift -= fold_bits;
    }
}

}  // namespace

SumDigits::SumDigits(LimbView numbers, std::size_t count, std::size_t size, std::size_t bits)
    : size_(size), bits_(bits), width_(bits / fold_bits + 2) {
    if (vectors::table().fold_blocks == nullptr || size <= factor_products::least_factors ||
        size > fold_blocks::most_factors + 1)
        return;
    // Whole vectors, and one more at the end.
    stride_ = (size + 7) / 8 * 8 + 8;
    digits_.resize(count / size * width_ * stride_);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t* const words = numbers.words + i * numbers.stride;
        const std::uint64_t sign = words[numbers.width - 1] >> 63 == 0 ? 0 : ~std::uint64_t{0};
        const auto word = [&](std::size_t k) { return k < numbers.width ? words[k] : sign; };
        std::uint64_t* const place = digits_.data() + i / size * width_ * stride_ + i % size;
        for (std::size_t d = 0; d < width_; ++d) {
            const std::size_t bit = d * fold_bits;
            const UInt128 pair = UInt128{word(bit / 64 + 1)} << 64 | word(bit / 64);
            place[d * stride_] = static_cast<std::uint64_t>(pair >> (bit % 64)) & fold_mask;
        }
    }
}

bool SumDigits::suffice(std::span<const WordFactor> factors, std::size_t bits) const {
    if (digits_.empty() || bits >= fold_blocks::most_digits * fold_bits) return false;
    constexpr std::uint64_t most_denominator = std::uint64_t{1} << 31;
    const bool any_denominators = factors.size() <= factors_of_any_denominators;
    return std::ranges::all_of(factors, [&](const WordFactor& factor) {
        return l1_norm(factor) >> block_bits == 0 &&
               (any_denominators || static_cast<std::uint64_t>(factor.denominator) < most_denominator);
    });
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only what is used of the arrays is set
DigitBlocks::DigitBlocks(const SumDigits& rows, std::span<const WordFactor> factors, std::size_t bits) {
    fixed_width::BitBound bound(rows.bits());
    std::size_t size = 0;
    while (!factors.empty()) {
        FactorBlock& product = products_[size++];
        product.fill(factors, fold_blocks::most_factors, block_bits);
        factors = factors.subspan(product.degree());
        bound.multiply(product.bound());
        // The bound from the single factors may be closer.
        const std::size_t digits = std::min(bound.bits(), bits) / fold_bits + 1;
        folds_.add({product.coefficients().data(), 1, product.degree(), digits});
    }
}

bool LaneBlocks::multiply(const SumDigits& rows, std::span<const WordFactor> factors) {
    return !rows.empty() &&
           vectors::table().factor_products(factors.data(), factors.size(), factor_primes, product_) &&
           set_folds(rows, factors.size());
}

bool LaneBlocks::set_folds(const SumDigits& rows, std::size_t count) {
    bits_ = rows.bits();
    for (std::size_t b = 0; b < product_.blocks; ++b) {
        const std::size_t degree = (count + product_.blocks - 1 - b) >> std::countr_zero(product_.blocks);
        bits_ += static_cast<std::size_t>(std::bit_width(product_.bounds[b]));
        const std::size_t digits = bits_ / fold_bits + 1;
        if (b + 1 < product_.blocks) {
            folds_.add({product_.coefficients[0] + b, factor_products::most_blocks, degree, digits});
        } else {
            folds_.add({product_.last, 1, degree, digits});
        }
    }
    return bits_ < fold_blocks::most_digits * fold_bits;
}

void DigitFolds::sum(const fold_blocks::Columns& row, std::span<std::uint64_t> words) const {
    std::int64_t digits[fold_blocks::most_digits];
    vectors::table().fold_blocks(row, blocks_, size_, digits);
    set_words(std::span(digits).first(blocks_[size_ - 1].digits), words);
}

}  // namespace blossom
