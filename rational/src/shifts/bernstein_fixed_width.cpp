// Bernstein coefficients in rows of fixed width, modulo a power of two that provably suffices: only the
// results have to fit.

#include <blossom/rational/bernstein_kernel.hpp>
#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <array>
#include <bit>
#include <numeric>
#include <utility>

#include "limbs/limb_arithmetic.hpp"
#include "sums/fixed_width_rows.hpp"

namespace blossom {

namespace {

/// In words; for wider numbers, vectors or residues are as fast.
constexpr std::size_t most_words_of_line = 10;
constexpr std::size_t most_coefficients_of_line = 32;

/// t = (p + slope z) / q with z = x / y, over the denominator `rest`.
struct LineInWords {
    std::uint64_t p;
    bool negative;  ///< whether the number is -p
    std::uint64_t q;
    std::uint64_t slope;
    bool falls;  ///< whether the slope is -slope
    std::uint64_t rest;
};

/// base^exponent as a few words to multiply by one after the other.
class WordPowers {
public:
    explicit WordPowers(std::uint64_t base) : powers_{1} {
        for (std::uint64_t next = base; base != 1 && count_ + 1 < powers_.size();) {
            powers_[++count_] = next;
            if (__builtin_mul_overflow(next, base, &next)) break;
        }
    }

    template <class Multiply>
    void each(std::size_t exponent, const Multiply& multiply) const {
        if (count_ == 0) return;
        for (; exponent > count_; exponent -= count_) multiply(powers_[count_]);
        if (exponent > 0) multiply(powers_[exponent]);
    }

private:
    std::array<std::uint64_t, most_coefficients_of_line> powers_;
    std::size_t count_ = 0;
};

/// Numbers modulo 2^(64 Words).
template <std::size_t Words>
class LineRow {
public:
    explicit LineRow(std::span<const Integer> coefficients) : size_(coefficients.size()) {
        for (std::size_t k = 0; k < size_; ++k)
            IntegerAccess::to_twos_complement(coefficients[k], entries_[k]);
    }

    void substitute(const LineInWords& line) {
        const std::size_t n = size_ - 1;
        scale(line.q, 1, line.negative);
        for (std::size_t level = 1; line.p != 0 && level <= n; ++level)
            for (std::size_t k = n; k-- + 1 > level;) add_product(entries_[k], entries_[k + 1], line.p);
        // If p is negative, the signs of odd powers are already reversed.
        scale(line.rest, line.slope, line.falls != line.negative);
        for (std::size_t level = 1; level <= n; ++level)
            for (std::size_t k = 1; k + level <= n + 1; ++k) add(entries_[k], entries_[k - 1]);
    }

    std::vector<Integer> times(std::span<const Integer> weights) {
        std::vector<Integer> result;
        result.reserve(size_);
        for (std::size_t k = 0; k < size_; ++k) {
            multiply(entries_[k], static_cast<std::uint64_t>(*weights[k].to_int64()));
            result.push_back(IntegerAccess::from_twos_complement(entries_[k]));
        }
        return result;
    }

private:
    using Entry = std::array<std::uint64_t, Words>;

    static void multiply(Entry& entry, std::uint64_t factor) {
        UInt128 carry = 0;
        for (std::uint64_t& word : entry) {
            carry += UInt128{word} * factor;
            word = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
    }
    static void add_product(Entry& sum, const Entry& entry, std::uint64_t factor) {
        UInt128 carry = 0;
        for (std::size_t i = 0; i < Words; ++i) {
            carry += UInt128{entry[i]} * factor + sum[i];
            sum[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
    }

    static void add(Entry& sum, const Entry& entry) {
        constexpr std::size_t most_in_line = 4;
        if constexpr (Words > most_in_line) {
            limbs::add(sum.data(), sum.data(), entry.data(), Words);
        } else {
            add_product(sum, entry, 1);
        }
    }

    /// entry[k] *= falling^(n - k) rising^k, with the opposite sign for odd k if `alternates`.
    void scale(std::uint64_t falling, std::uint64_t rising, bool alternates) {
        const WordPowers of_falling(falling);
        const WordPowers of_rising(rising);
        for (std::size_t k = 0; k < size_; ++k) {
            const auto by_word = [&](std::uint64_t factor) { multiply(entries_[k], factor); };
            of_falling.each(size_ - 1 - k, by_word);
            of_rising.each(k, by_word);
            if (alternates && k % 2 == 1) limbs::negate(entries_[k].data(), Words);
        }
    }

    std::size_t size_;
    std::array<Entry, most_coefficients_of_line> entries_;
};

template <std::size_t Words>
std::vector<Integer> substituted(std::span<const Integer> coefficients, const LineInWords& line,
                                 std::span<const Integer> weights) {
    LineRow<Words> row(coefficients);
    row.substitute(line);
    return row.times(weights);
}

/// One instance per number of words, from 1.
constexpr auto substituted_in_words = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{&substituted<i + 1>...};
}(std::make_index_sequence<most_words_of_line>());

}  // namespace

// With a = p/q, b = r/s, q = g q' and s = g s', q t = p + (r q' - p s') / s' z.
std::optional<std::vector<Integer>> bernstein_in_words(std::span<const Integer> coefficients,
                                                       const WordQuotient& a, const WordQuotient& b,
                                                       std::span<const Integer> weights) {
    const std::size_t count = coefficients.size();
    if (count > most_coefficients_of_line) return std::nullopt;
    for (const Integer& weight : weights)
        if (!weight.to_int64()) return std::nullopt;
    const std::int64_t common = std::gcd(a.denominator, b.denominator);
    const std::int64_t rising = a.denominator / common;
    const std::int64_t falling = b.denominator / common;
    std::int64_t from = 0;
    std::int64_t slope = 0;
    if (__builtin_mul_overflow(a.numerator, falling, &from) ||
        __builtin_mul_overflow(b.numerator, rising, &slope) || __builtin_sub_overflow(slope, from, &slope))
        return std::nullopt;
    // The bound of `form_on_line`, then that of the powers and weights.
    fixed_width::BitBound bound(greatest_bit_length(coefficients) + greatest_bit_length(weights) +
                                static_cast<std::size_t>(std::bit_width(count)));
    const std::uint64_t growth = std::max(magnitude(a.numerator) + magnitude(b.numerator),
                                          magnitude(a.denominator) + magnitude(b.denominator));
    const UInt128 growth_of_both = UInt128{growth} * magnitude(std::max(rising, falling));
    for (std::size_t i = 1; i < count; ++i) bound.multiply(growth_of_both);
    const std::size_t words = bound.bits() / 64 + 1;
    if (words > most_words_of_line) return std::nullopt;
    const LineInWords line{magnitude(a.numerator), a.numerator < 0, magnitude(a.denominator),
                           magnitude(slope),       slope < 0,       magnitude(falling)};
    spend_work(count * count * words);
    return substituted_in_words[words - 1](coefficients, line, weights);
}

}  // namespace blossom
