#include "digit_sums.hpp"

#include "fixed_width_rows.hpp"
#include "residue_system.hpp"

namespace blossom {

namespace {

constexpr std::size_t fold_bits = digit_folds::digit_bits;

constexpr std::uint64_t fold_mask = (std::uint64_t{1} << fold_bits) - 1;
constexpr int block_bits = fold_bits - 1;

/// By measurement.
constexpr std::size_t least_factors = 8;
/// Up to so many factors there is room for denominators of words.
constexpr std::size_t factors_of_any_denominators = 64;

digit_folds::Fold chosen_fold() {
    static const digit_folds::Fold chosen = []() -> digit_folds::Fold {
#if defined(BLOSSOM_AVX512_IFMA)
        if (residues::vector_level() == "ifma" && __builtin_cpu_supports("avx512f") &&
            __builtin_cpu_supports("avx512ifma"))
            return digit_folds::avx512_fold;
#endif
        return nullptr;
    }();
    return chosen;
}

/// 64 bits from bit 64 i on of a number in two's complement.
std::uint64_t word_of(std::span<const std::uint64_t> digits, std::size_t i) {
    const std::uint64_t sign = digits.back() >> (fold_bits - 1) == 0 ? 0 : fold_mask;
    const auto digit = [&](std::size_t d) { return d < digits.size() ? digits[d] : sign; };
    const std::size_t first = 64 * i / fold_bits;
    const std::size_t shift = 64 * i % fold_bits;
    return static_cast<std::uint64_t>(
        (Wide{digit(first + 2)} << (2 * fold_bits) | Wide{digit(first + 1)} << fold_bits | digit(first)) >>
        shift);
}

}  // namespace

DigitRows::DigitRows(LimbView numbers, std::size_t count, std::size_t size, std::size_t bits)
    : size_(size), bits_(bits), width_(bits / fold_bits + 1) {
    if (chosen_fold() == nullptr || size <= least_factors || size > digit_folds::most_factors + 1) return;
    // Whole vectors, and one behind them.
    stride_ = (size + 7) / 8 * 8 + 8;
    digits_.resize(count / size * width_ * stride_);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t* const words = numbers.words + i * numbers.stride;
        const std::uint64_t sign = words[numbers.width - 1] >> 63 == 0 ? 0 : ~std::uint64_t{0};
        const auto word = [&](std::size_t k) { return k < numbers.width ? words[k] : sign; };
        std::uint64_t* const place = digits_.data() + i / size * width_ * stride_ + i % size;
        for (std::size_t d = 0; d < width_; ++d) {
            const std::size_t bit = d * fold_bits;
            const Wide pair = Wide{word(bit / 64 + 1)} << 64 | word(bit / 64);
            place[d * stride_] = static_cast<std::uint64_t>(pair >> (bit % 64)) & fold_mask;
        }
    }
}

bool DigitRows::suffice(std::span<const WordFactor> factors, std::size_t bits) const {
    if (digits_.empty() || bits >= digit_folds::most_digits * fold_bits) return false;
    constexpr std::uint64_t most_denominator = std::uint64_t{1} << 31;
    const bool any_denominators = factors.size() <= factors_of_any_denominators;
    return std::ranges::all_of(factors, [&](const WordFactor& factor) {
        return size_of(factor) >> block_bits == 0 &&
               (any_denominators || static_cast<std::uint64_t>(factor.denominator) < most_denominator);
    });
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only what is used of the arrays is set
DigitBlocks::DigitBlocks(const DigitRows& rows, std::span<const WordFactor> factors, std::size_t bits) {
    fixed_width::BitBound bound(rows.bits());
    while (!factors.empty()) {
        FactorBlock& product = products_[size_];
        product.fill(factors, digit_folds::most_factors, block_bits);
        factors = factors.subspan(product.degree());
        bound.multiply(product.bound());
        // The bound of the factors one by one may be closer.
        const std::size_t digits = std::min(bound.bits(), bits) / fold_bits + 1;
        blocks_[size_++] = {product.coefficients().data(), product.degree(), digits};
    }
}

void DigitBlocks::sum(const digit_folds::Columns& row, std::span<std::uint64_t> words) const {
    std::uint64_t digits[digit_folds::most_digits];
    chosen_fold()(row, blocks_, size_, digits);
    const std::span<const std::uint64_t> used = std::span(digits).first(blocks_[size_ - 1].digits);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = word_of(used, i);
}

}  // namespace blossom
