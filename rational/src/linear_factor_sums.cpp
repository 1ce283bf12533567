#include <blossom/rational/linear_factor_sums.hpp>
#include <blossom/rational/row_recurrences.hpp>

#include <optional>

#include "fixed_width_rows.hpp"
#include "limb_sums.hpp"
#include "machine_sums.hpp"
#include "prepared_rows.hpp"
#include "quotient_reduction.hpp"

namespace blossom {

namespace {

using Prepared = LinearFactorSums::Prepared;

/// Bounds in bits on the coefficients of the product and on the numerators of the sums.
struct Bounds {
    std::size_t product;
    std::size_t sum;
};

Bounds bounds(const Prepared& rows, std::span<const WordFactor> factors) {
    fixed_width::BitBound product(1);
    fixed_width::BitBound sum(rows.bits);
    for (const WordFactor& factor : factors) {
        product.multiply(size_of(factor));
        sum.multiply(size_of(factor));
    }
    return {product.bits(), sum.bits()};
}

SumKernel kernel_for(const Prepared& rows, std::span<const WordFactor> factors) {
    if (factors.size() > machine_sums::most_factors) return SumKernel::integers;
    const bool words = !rows.words.empty();
    if (words && machine_sums::word_denominator(rows.words_of(0), factors)) return SumKernel::word;
    const std::size_t bits = bounds(rows, factors).sum;
    if (words && bits < 128) return SumKernel::wide;
    if (bits / 64 < most_sum_limbs) return SumKernel::limbs;
    return SumKernel::integers;
}

/// A numerator in two's complement, or its negative, over the denominator in lowest terms.
Rational reduced(std::span<std::uint64_t> numerator, bool negated, const DenominatorWords& denominator,
                 const Integer& further) {
    const bool negative = static_cast<std::int64_t>(numerator.back()) < 0;
    bool carry = negative;
    for (std::uint64_t& word : numerator) {
        if (!negative) break;
        word = ~word + static_cast<std::uint64_t>(carry);
        carry = carry && word == 0;
    }
    std::size_t used = numerator.size();
    while (used > 1 && numerator[used - 1] == 0) --used;
    return reduced_quotient(numerator.first(used), negative != negated, denominator.words(), further);
}

void evaluate_wide(const Prepared& rows, std::span<const WordFactor> factors, std::size_t first_row,
                   std::span<Rational> sums) {
    const machine_sums::FactorProduct<Wide> product(factors);
    const DenominatorWords denominator = machine_sums::denominator_words(rows.denominators, factors);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        sums[j] =
            machine_sums::reduced(product.sum_of_products(rows.words_of(first_row + j).words), denominator);
    }
}

void evaluate_limbs(const Prepared& rows, std::span<const WordFactor> factors, std::size_t first_row,
                    std::span<Rational> sums) {
    const Bounds bits = bounds(rows, factors);
    fixed_width::LimbRow product(factors.size() + 1, 1, bits.product);
    product.set(0, 1);
    product.multiply_out(factors);
    const DenominatorWords denominator = machine_sums::denominator_words(rows.denominators, factors);
    std::uint64_t words[most_sum_limbs];
    const std::span<std::uint64_t> numerator = std::span(words).first(bits.sum / 64 + 1);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        limb_dot({rows.limbs_of(first_row + j), rows.width, rows.width}, product.limbs(), rows.size,
                 numerator);
        sums[j] = reduced(numerator, product.negated(), denominator, rows.further_denominator);
    }
}

void evaluate_integers(const Prepared& rows, std::span<const IntegerFactor> factors, std::size_t first_row,
                       std::span<Rational> sums) {
    std::vector<Integer> constants;
    std::vector<Integer> slopes;
    Integer denominator = rows.numbers.denominator();
    for (const IntegerFactor& factor : factors) {
        constants.push_back(factor.constant);
        slopes.push_back(factor.slope);
        denominator *= factor.denominator;
    }
    const std::vector<Integer> product =
        product_of_linear_factors(std::span<const Integer>(constants), std::span<const Integer>(slopes));
    for (std::size_t j = 0; j < sums.size(); ++j)
        sums[j] = Rational(dot(rows.integers_of(first_row + j), product), denominator);
}

constexpr SumKernelRule rules[] = {
    {SumKernel::word, "word",
     "at most 64 factors of words; numerators and denominators of the sums below 2^63"},
    {SumKernel::wide, "wide",
     "at most 64 factors of words; prepared numerators below 2^63, those of the sums below 2^127"},
    {SumKernel::limbs, "limbs", "at most 64 factors of words; numerators of the sums below 2^511"},
    {SumKernel::integers, "integers", "any"},
};

}  // namespace

std::span<const SumKernelRule> sum_kernel_rules() { return rules; }

LinearFactorSums::LinearFactorSums(RationalVector numbers, std::size_t rows, Use use)
    : prepared_(std::make_shared<const Prepared>(std::move(numbers), rows, use)) {}

std::size_t LinearFactorSums::rows() const { return prepared_->rows; }

std::size_t LinearFactorSums::degree() const { return prepared_->size - 1; }

const RationalVector& LinearFactorSums::numbers() const { return prepared_->numbers; }

SumKernel LinearFactorSums::kernel(std::span<const WordFactor> factors) const {
    return kernel_for(*prepared_, factors);
}

void LinearFactorSums::evaluate(std::span<const WordFactor> factors, std::size_t first_row,
                                std::span<Rational> sums) const {
    const Prepared& rows = *prepared_;
    const std::uint64_t denominator =
        rows.words.empty() ? 0 : machine_sums::word_denominator(rows.words_of(0), factors);
    if (denominator != 0) {
        const machine_sums::FactorProduct<std::uint64_t> product(factors);
        for (std::size_t j = 0; j < sums.size(); ++j) {
            const std::uint64_t sum = product.sum_of_products(rows.words_of(first_row + j).words);
            set_reduced(sums[j], static_cast<std::int64_t>(sum), denominator);
        }
        return;
    }
    switch (kernel_for(rows, factors)) {
        case SumKernel::word:
        case SumKernel::wide:
            return evaluate_wide(rows, factors, first_row, sums);
        case SumKernel::limbs:
            return evaluate_limbs(rows, factors, first_row, sums);
        case SumKernel::integers:
            break;
    }
    std::vector<IntegerFactor> integers;
    integers.reserve(factors.size());
    for (const WordFactor& factor : factors)
        integers.push_back({factor.constant, factor.slope, factor.denominator});
    evaluate_integers(rows, integers, first_row, sums);
}

void LinearFactorSums::evaluate(std::span<const IntegerFactor> factors, std::size_t first_row,
                                std::span<Rational> sums) const {
    evaluate_integers(*prepared_, factors, first_row, sums);
}

}  // namespace blossom
