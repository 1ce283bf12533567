#include <blossom/rational/blossom_sums.hpp>
#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/row_recurrences.hpp>

#include <utility>

#include "fixed_width_rows.hpp"
#include "large_sums.hpp"
#include "limbs/limb_arithmetic.hpp"
#include "limbs/limb_sums.hpp"
#include "numerator_bounds.hpp"
#include "prepared_rows.hpp"
#include "quotients/quotient_reduction.hpp"
#include "word_sums.hpp"

namespace blossom {

namespace {

using PreparedRows = BlossomSums::PreparedRows;

/// The numbers of factors for which residues are used: the least by measurement, the most because of the
/// length of a sum.
constexpr std::size_t least_residue_factors = 16;
constexpr std::size_t most_residue_factors = residues::most_terms - 1;

/// The least number of factors for which vector lanes are tried before words (by measurement).
constexpr std::size_t least_factors_for_lanes = 8;

template <class R>
SumKernel kernel_without_limbs(const PreparedRows& rows, std::span<const LinearFactor<R>> factors) {
    const bool residues = least_residue_factors <= factors.size() && factors.size() <= most_residue_factors &&
                          sum_bits(rows, factors) <= residues::most_bits;
    return residues ? SumKernel::residues : SumKernel::integers;
}

/// The kernel for sums beyond the kernel `word`.
SumKernel kernel_beyond_words(const PreparedRows& rows, std::span<const WordFactor> factors,
                              const Bounds& bits) {
    const bool on_stack = factors.size() <= word_sums::most_factors;
    if (on_stack && !rows.words.empty() && bits.sum < 128) return SumKernel::wide;
    if (rows.digits.suffice(factors, bits.sum)) return SumKernel::limbs;
    if (!on_stack) return kernel_without_limbs(rows, factors);
    if (!rows.limbs.empty() && bits.sum / 64 < most_sum_limbs) return SumKernel::limbs;
    return kernel_without_limbs(rows, factors);
}

/// Sets `value` to a numerator in two's complement, or its negative, over the denominator, in lowest terms.
void assign_signed_quotient(Rational& value, std::span<std::uint64_t> numerator, bool negated,
                            const DenominatorWords& denominator, std::span<const Integer> further) {
    const bool negative = limbs::take_magnitude(numerator);
    assign_quotient(value, numerator, negative != negated, denominator, further);
}

/// Computes the sums and returns whether the kernel `word` sufficed.
template <std::size_t Count>
[[gnu::always_inline]] inline bool evaluate_fixed(const PreparedRows& rows,
                                                  std::span<const WordFactor, Count> factors,
                                                  std::size_t first_row, std::span<Rational> sums) {
    const word_sums::WordDenominator denominator = word_sums::word_denominator(rows.words_of(0), factors);
    if (denominator.value == 0) return false;
    const word_sums::FactorProduct<Count> product(factors);
    const std::int64_t* row = rows.words.data() + first_row * rows.size;
    for (Rational& value : sums) {
        const std::uint64_t sum = product.sum_of_products({row, rows.size});
        assign_quotient(value, static_cast<std::int64_t>(sum), static_cast<std::uint64_t>(denominator.value),
                        denominator.primes);
        row += rows.size;
    }
    return true;
}

/// The same; low degrees have instances without loops.
bool evaluate_words(const PreparedRows& rows, std::span<const WordFactor> factors, std::size_t first_row,
                    std::span<Rational> sums) {
    return with_small_constant(factors.size(), [&](auto count) {
        return evaluate_fixed(rows, std::span<const WordFactor, count>(factors.data(), factors.size()),
                              first_row, sums);
    });
}

void evaluate_wide(const PreparedRows& rows, std::span<const WordFactor> factors, std::size_t first_row,
                   std::span<Rational> sums) {
    const word_sums::WideFactorProduct product(factors);
    const DenominatorWords denominator =
        word_sums::denominator_words(rows.denominator.words, rows.primes, factors);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        word_sums::assign_quotient(sums[j], product.sum_of_products(rows.words_of(first_row + j).words),
                                   denominator);
    }
}

fixed_width::LimbRow multiplied_out(std::span<const WordFactor> factors, std::size_t bits) {
    fixed_width::LimbRow product(factors.size() + 1, 1, bits);
    product.set(0, 1);
    product.multiply_out(factors);
    return product;
}

void evaluate_digits(const PreparedRows& rows, std::span<const WordFactor> factors, const Bounds& bits,
                     std::size_t first_row, std::span<Rational> sums) {
    const DigitBlocks blocks(rows.digits, factors, bits.sum);
    const DenominatorWords denominator =
        word_sums::denominator_words(rows.denominator.words, rows.primes, factors);
    std::uint64_t words[most_digit_words];
    const std::span<std::uint64_t> numerator = std::span(words).first(bits.sum / 64 + 1);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        blocks.folds().sum(rows.digits.row(first_row + j), numerator);
        assign_signed_quotient(sums[j], numerator, false, denominator, rows.denominator.longer);
    }
}

void evaluate_limbs(const PreparedRows& rows, std::span<const WordFactor> factors, const Bounds& bits,
                    std::size_t first_row, std::span<Rational> sums) {
    if (rows.digits.suffice(factors, bits.sum)) return evaluate_digits(rows, factors, bits, first_row, sums);
    const fixed_width::LimbRow product = multiplied_out(factors, bits.product);
    const DenominatorWords denominator =
        word_sums::denominator_words(rows.denominator.words, rows.primes, factors);
    std::uint64_t words[most_sum_limbs];
    const std::span<std::uint64_t> numerator = std::span(words).first(bits.sum / 64 + 1);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        limb_dot({rows.limbs_of(first_row + j), rows.width, rows.width}, product.limbs(), rows.size,
                 numerator);
        assign_signed_quotient(sums[j], numerator, product.negated(), denominator, rows.denominator.longer);
    }
}

/// Factors of the denominator of all sums, with words multiplied together while they stay words; and whether
/// the product of the factors is the negative of the denominator.
template <class R>
std::pair<DenominatorParts, bool> denominator_factors(const PreparedRows& rows,
                                                      std::span<const LinearFactor<R>> factors) {
    DenominatorParts result = rows.denominator;
    bool negative = false;
    for (const LinearFactor<R>& factor : factors) {
        const Integer denominator = factor.denominator;
        negative ^= denominator.sign() < 0;
        result.multiply(abs(denominator));
    }
    return {std::move(result), negative};
}

/// The sums, given their numerators, over the denominators of the rows and the factors.
template <class R>
void set_reduced(std::span<Rational> sums, std::span<const Integer> numerators, const PreparedRows& rows,
                 std::span<const LinearFactor<R>> factors) {
    const auto [denominators, negative] = denominator_factors(rows, factors);
    std::vector<std::uint64_t> numerator;
    for (std::size_t j = 0; j < sums.size(); ++j) {
        numerator.resize(limbs::size_of(numerators[j]));
        limbs::write_magnitude(numerators[j], numerator.data(), numerator.size());
        sums[j] = reduced_quotient(numerator, (numerators[j].sign() < 0) != negative, denominators.words,
                                   denominators.longer);
    }
}

template <class R>
void evaluate_residues(const PreparedRows& rows, std::span<const LinearFactor<R>> factors,
                       std::size_t first_row, std::span<Rational> sums) {
    const std::vector<Integer> numerators =
        residue_sums(rows.numbers, rows.use == BlossomSums::Use::many ? &rows.residues : nullptr,
                     blocks_of(factors), sum_bits(rows, factors), first_row, sums.size());
    set_reduced(sums, numerators, rows, factors);
}

/// From this number of factors on, products of polynomials by halves are faster than multiplying by one
/// factor after the other (by measurement).
constexpr std::size_t least_factors_of_halves = 1024;

template <class R>
bool pays_by_halves(std::span<const LinearFactor<R>> factors) {
    return limbs::multiplies_long_numbers_fast && factors.size() >= least_factors_of_halves;
}

template <class R>
IntegerPolynomial multiplied_by_halves(std::span<const LinearFactor<R>> factors) {
    constexpr std::size_t few = 64;
    if (factors.size() > few) {
        const std::size_t half = factors.size() / 2;
        return product(multiplied_by_halves(factors.first(half)),
                       multiplied_by_halves(factors.subspan(half)));
    }
    const auto integers = [&](R LinearFactor<R>::* part) {
        std::vector<Integer> result;
        for (const LinearFactor<R>& factor : factors) result.emplace_back(factor.*part);
        return result;
    };
    return product_of_linear_factors(integers(&LinearFactor<R>::constant), integers(&LinearFactor<R>::slope));
}

template <class R>
void evaluate_by_halves(const PreparedRows& rows, std::span<const LinearFactor<R>> factors,
                        std::size_t first_row, std::span<Rational> sums) {
    const IntegerPolynomial polynomial = multiplied_by_halves(factors);
    std::vector<Integer> numerators;
    numerators.reserve(sums.size());
    for (std::size_t j = 0; j < sums.size(); ++j)
        numerators.push_back(dot(rows.integers_of(first_row + j), polynomial));
    set_reduced(sums, numerators, rows, factors);
}

/// The sums of products of the rows with the coefficients in `product`, or with their negatives.
template <class R>
void set_large_sums(const PreparedRows& rows, std::span<const LinearFactor<R>> factors,
                    const LimbView& product, bool negated, std::size_t bits, std::size_t first_row,
                    std::span<Rational> sums) {
    const auto [denominators, negative] = denominator_factors(rows, factors);
    std::vector<std::uint64_t> numerator(bits / 64 + 1);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        large_dot(rows.integers_of(first_row + j), product, numerator);
        const bool below_zero = limbs::take_magnitude(numerator);
        sums[j] = reduced_quotient(numerator, (below_zero != negated) != negative, denominators.words,
                                   denominators.longer);
    }
}

void evaluate_integers(const PreparedRows& rows, std::span<const WordFactor> factors, std::size_t first_row,
                       std::span<Rational> sums) {
    if (pays_by_halves(factors)) return evaluate_by_halves(rows, factors, first_row, sums);
    const Bounds bits = bounds(rows, factors);
    const fixed_width::LimbRow product = multiplied_out(factors, bits.product);
    set_large_sums(rows, factors, product.limbs(), product.negated(), bits.sum, first_row, sums);
}

void evaluate_integers(const PreparedRows& rows, std::span<const IntegerFactor> factors,
                       std::size_t first_row, std::span<Rational> sums) {
    if (pays_by_halves(factors)) return evaluate_by_halves(rows, factors, first_row, sums);
    const std::size_t bits = sum_bits(rows, factors);
    const FactorRow product(factors, bits - rows.bits);
    set_large_sums(rows, factors, product.limbs(), false, bits, first_row, sums);
}

/// The sums for factors m + u X, see evaluate_pairs.
bool evaluate_pairs_in_words(const PreparedRows& rows, const Rational* pairs, std::size_t first_row,
                             std::span<Rational> sums) {
    return with_small_constant(rows.size - 1, [&](auto count) {
        if constexpr (count == std::dynamic_extent) {
            return false;
        } else {
            WordFactor factors[count];
            for (std::size_t i = 0; i < count; ++i)
                if (!read_factor(pairs[2 * i], pairs[2 * i + 1], factors[i])) return false;
            return evaluate_fixed(rows, std::span<const WordFactor, count>(factors), first_row, sums);
        }
    });
}

/// Computes the sums and returns whether words hold all of them.
bool set_sums_in_words(const PreparedRows& rows, const LaneBlocks& blocks, std::size_t first_row,
                       std::span<Rational> sums) {
    if (blocks.bits() >= 64 || rows.words.empty()) return false;
    std::int64_t denominator = rows.word_denominator;
    for (const std::uint64_t factor : blocks.denominators())
        if (__builtin_mul_overflow(denominator, factor, &denominator)) return false;
    if (denominator == 0) return false;
    for (std::size_t j = 0; j < sums.size(); ++j) {
        std::uint64_t numerator = 0;
        blocks.folds().sum(rows.digits.row(first_row + j), {&numerator, 1});
        assign_quotient(sums[j], static_cast<std::int64_t>(numerator),
                        static_cast<std::uint64_t>(denominator), rows.primes | blocks.primes());
    }
    return true;
}

/// Computes the sums and returns whether vector lanes suffice.
[[gnu::noinline]] bool evaluate_lanes(const PreparedRows& rows, std::span<const WordFactor> factors,
                                      std::size_t first_row, std::span<Rational> sums) {
    LaneBlocks blocks;
    if (!blocks.multiply(rows.digits, factors)) return false;
    if (set_sums_in_words(rows, blocks, first_row, sums)) return true;
    DenominatorWords denominator;
    for (const std::uint64_t factor : rows.denominator.words) denominator.multiply(factor, rows.primes);
    for (const std::uint64_t factor : blocks.denominators()) denominator.multiply(factor, blocks.primes());
    std::uint64_t words[most_digit_words];
    const std::span<std::uint64_t> numerator = std::span(words).first(blocks.bits() / 64 + 1);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        blocks.folds().sum(rows.digits.row(first_row + j), numerator);
        assign_signed_quotient(sums[j], numerator, false, denominator, rows.denominator.longer);
    }
    return true;
}

/// Not inlined: the kernel `word` needs neither its registers nor its memory.
[[gnu::noinline]] void evaluate_beyond_words(const PreparedRows& rows, std::span<const WordFactor> factors,
                                             std::size_t first_row, std::span<Rational> sums) {
    const Bounds bits = bounds(rows, factors);
    switch (kernel_beyond_words(rows, factors, bits)) {
        case SumKernel::word:
        case SumKernel::wide:
            return evaluate_wide(rows, factors, first_row, sums);
        case SumKernel::limbs:
            return evaluate_limbs(rows, factors, bits, first_row, sums);
        case SumKernel::residues:
            return evaluate_residues(rows, factors, first_row, sums);
        case SumKernel::integers:
            return evaluate_integers(rows, factors, first_row, sums);
    }
}

constexpr SumKernelRule rules[] = {
    {SumKernel::word, "word",
     "at most 64 factors of words; numerators and denominators of the sums below 2^63"},
    {SumKernel::wide, "wide",
     "at most 64 factors of words; prepared numerators below 2^63, those of the sums below 2^127"},
    {SumKernel::limbs, "limbs",
     "at most 64 factors of words; numerators of the sums below 2^511; "
     "with AVX-512 IFMA up to 128 factors below 2^51 and numerators below 2^831"},
    {SumKernel::residues, "residues",
     "16 to 4095 factors of any size; numerators of the sums below 2^2000000"},
    {SumKernel::integers, "integers", "any"},
};

}  // namespace

std::span<const SumKernelRule> sum_kernel_rules() { return rules; }

BlossomSums::BlossomSums(RationalVector numbers, std::size_t rows, Use use)
    : prepared_(std::make_shared<const PreparedRows>(std::move(numbers), rows, use)) {}

std::size_t BlossomSums::rows() const { return prepared_->rows; }

std::size_t BlossomSums::degree() const { return prepared_->size - 1; }

const RationalVector& BlossomSums::numbers() const { return prepared_->numbers; }

SumKernel BlossomSums::kernel(std::span<const WordFactor> factors) const {
    const PreparedRows& rows = *prepared_;
    if (!rows.words.empty() && word_sums::word_denominator(rows.words_of(0), factors).value != 0)
        return SumKernel::word;
    return kernel_beyond_words(rows, factors, bounds(rows, factors));
}

void BlossomSums::evaluate(std::span<const WordFactor> factors, std::size_t first_row,
                           std::span<Rational> sums) const {
    const PreparedRows& rows = *prepared_;
    const auto in_words = [&] {
        return !rows.words.empty() && evaluate_words(rows, factors, first_row, sums);
    };
    const auto in_lanes = [&] {
        return !rows.digits.empty() && evaluate_lanes(rows, factors, first_row, sums);
    };
    const bool done =
        factors.size() < least_factors_for_lanes ? in_words() || in_lanes() : in_lanes() || in_words();
    if (!done) evaluate_beyond_words(rows, factors, first_row, sums);
}

bool BlossomSums::evaluate_pairs(const Rational* pairs, std::size_t first_row,
                                 std::span<Rational> sums) const {
    const PreparedRows& rows = *prepared_;
    return !rows.words.empty() && evaluate_pairs_in_words(rows, pairs, first_row, sums);
}

void BlossomSums::evaluate(std::span<const IntegerFactor> factors, std::size_t first_row,
                           std::span<Rational> sums) const {
    if (kernel(factors) == SumKernel::residues)
        return evaluate_residues(*prepared_, factors, first_row, sums);
    evaluate_integers(*prepared_, factors, first_row, sums);
}

SumKernel BlossomSums::kernel(std::span<const IntegerFactor> factors) const {
    return kernel_without_limbs(*prepared_, factors);
}

}  // namespace blossom
