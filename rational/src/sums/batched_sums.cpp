// Sums for eight tuples of factors at once, on processors with the vector instructions.

#include <blossom/rational/blossom_sums.hpp>

#include <array>
#include <bit>
#include <utility>

#include "prepared_rows.hpp"
#include "vectors/vector_table.hpp"

namespace blossom {

namespace {

using eight_sums::lanes;

constexpr auto small_divisors = [] {
    std::array<eight_sums::Divisor, small_primes::count> divisors{};
    for (std::size_t i = 0; i < divisors.size(); ++i)
        divisors[i] = {small_primes::table.primes[i].inverse, small_primes::table.primes[i].most};
    return divisors;
}();
constexpr auto wide_divisors = [] {
    constexpr std::uint64_t limb_mask = (std::uint64_t{1} << 52) - 1;
    std::array<eight_sums::WideDivisor, small_primes::count> divisors{};
    for (std::size_t i = 0; i < divisors.size(); ++i) {
        const auto& [prime, half_inverse, most] = small_primes::table.primes[i];
        const UInt128 inverse = half_inverse * (2 - prime * UInt128{half_inverse});
        divisors[i] = {{static_cast<std::uint64_t>(inverse) & limb_mask,
                        static_cast<std::uint64_t>(inverse >> 52) & limb_mask},
                       limb_mask / prime};
    }
    return divisors;
}();
constexpr eight_sums::Divisors lane_divisors{small_primes::table.of, small_primes::greatest_known,
                                             small_divisors.data(), wide_divisors.data()};

static_assert(RationalAccess::is_four_words);

/// Whether the vector kernel can read the numbers of the line.
bool is_short(const WordLine& line) {
    return std::in_range<std::int32_t>(line.a) && std::in_range<std::int32_t>(line.b) &&
           std::in_range<std::int32_t>(line.q) && std::in_range<std::int32_t>(line.length);
}

using PreparedRows = BlossomSums::PreparedRows;

struct Batch {
    eight_sums::Rows rows;
    const void* const* tuples;
    std::size_t count;
    const WordLine* line;
};

/// The most bits of sums and denominators of two words, as `WideOperations` requires.
constexpr std::size_t most_wide_bits = 102;

/// Whether the bounds allow this many bits for every product of `count` numbers > 0 and one of the rows.
bool may_have(const Batch& batch, std::size_t bits) { return batch.rows.bits + batch.count <= bits; }

[[gnu::always_inline]] inline bool evaluate_narrow(const eight_sums::Operations& operations,
                                                   const Batch& batch, std::span<Rational> sums) {
    if (batch.count > eight_sums::most_factors || !may_have(batch, 63)) return false;
    eight_sums::Quotients quotients[eight_sums::most_rows];
    if (!operations.sums(batch.rows, batch.tuples, batch.count, batch.line, lane_divisors, quotients))
        return false;
    const std::size_t stride = batch.rows.rows;
    if (stride == 1 && operations.store(quotients[0], sums.data())) return true;
    for (std::size_t j = 0; j < stride; ++j) {
        Rational* sum = sums.data() + j;
        for (std::size_t l = 0; l < lanes; ++l, sum += stride)
            RationalAccess::set_words(*sum, quotients[j].numerators[l], quotients[j].denominators[l]);
    }
    return true;
}

/// Whether the first tuple alone might fit. Reading all eight takes longer.
bool first_may_fit(const Batch& batch, const Rational* pairs) {
    if (batch.line != nullptr) return true;
    std::size_t bits = batch.rows.bits;
    for (std::size_t i = 0; i < batch.count; ++i) {
        const Rational& u = pairs[2 * i];
        const Rational& m = pairs[2 * i + 1];
        if (!u.numerator().is_word() || !u.denominator().is_word()) return false;
        const auto bottom = static_cast<std::uint64_t>(u.denominator().word());
        if (bottom > small_primes::greatest_known) return false;
        bits += static_cast<std::size_t>(
            std::bit_width(magnitude(u.numerator().word()) + (m.is_zero() ? 0 : bottom)));
    }
    return bits <= most_wide_bits;
}

Integer integer(std::uint64_t low, std::uint64_t high, bool negative) {
    const std::uint64_t words[] = {low, high};
    return IntegerAccess::from_magnitude(std::span(words).first(high == 0 ? 1 : 2), negative);
}

[[gnu::noinline]] bool evaluate_wide(const eight_sums::WideOperations& operations, const Batch& batch,
                                     const Rational* pairs, std::span<Rational> sums) {
    if (batch.count > eight_sums::most_wide_factors || !may_have(batch, most_wide_bits) ||
        !first_may_fit(batch, pairs))
        return false;
    eight_sums::WideQuotients quotients[eight_sums::most_rows];
    if (!operations.sums(batch.rows, batch.tuples, batch.count, batch.line, lane_divisors, quotients))
        return false;
    const std::size_t stride = batch.rows.rows;
    for (std::size_t j = 0; j < stride; ++j) {
        const auto& [tops, bottoms, negative] = quotients[j];
        for (std::size_t l = 0; l < lanes; ++l) {
            sums[l * stride + j] =
                RationalAccess::from_lowest_terms(integer(tops[0][l], tops[1][l], (negative >> l & 1) != 0),
                                                  integer(bottoms[0][l], bottoms[1][l], false));
        }
    }
    return true;
}

}  // namespace

bool BlossomSums::evaluate_eight(std::span<const Rational* const, lanes> tuples, std::span<Rational> sums,
                                 const WordLine* line) const {
    const PreparedRows& rows = *prepared_;
    const vectors::Table& table = vectors::table();
    if (table.eight_sums == nullptr || rows.words.empty() || rows.rows > eight_sums::most_rows ||
        rows.word_denominator == 0 || (line != nullptr && !is_short(*line)))
        return false;
    const auto denominator = static_cast<std::uint64_t>(rows.word_denominator);
    const auto bits = std::bit_width(static_cast<std::uint64_t>(rows.greatest) | denominator);
    const Batch batch{
        {rows.words.data(), rows.rows, static_cast<std::size_t>(bits), denominator, rows.primes},
        reinterpret_cast<const void* const*>(tuples.data()),
        rows.size - 1,
        line};
    return evaluate_narrow(*table.eight_sums, batch, sums) ||
           evaluate_wide(*table.eight_wide_sums, batch, tuples[0], sums);
}

}  // namespace blossom
