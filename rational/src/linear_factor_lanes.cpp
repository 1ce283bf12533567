// Sums for eight tuples of factors side by side, on processors that compute so.

#include <blossom/rational/linear_factor_sums.hpp>

#include <array>
#include <bit>
#include <utility>

#include "prepared_rows.hpp"
#include "word_lanes.hpp"

namespace blossom {

namespace {

using word_lanes::lanes;

/// What computes eight sums at a time here; nothing on processors without.
const word_lanes::Operations* chosen_word_lanes() {
    static const word_lanes::Operations* const chosen = []() -> const word_lanes::Operations* {
#if defined(BLOSSOM_AVX512_WORDS)
        if (residues::vector_level() == "ifma" && __builtin_cpu_supports("avx512f") &&
            __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512cd") &&
            __builtin_cpu_supports("avx512ifma"))
            return &word_lanes::avx512_operations;
#endif
        return nullptr;
    }();
    return chosen;
}

constexpr auto small_divisors = [] {
    std::array<word_lanes::Divisor, small_primes::count> divisors{};
    for (std::size_t i = 0; i < divisors.size(); ++i)
        divisors[i] = {small_primes::table.primes[i].inverse, small_primes::table.primes[i].most,
                       small_primes::table.primes[i].most >> 12};
    return divisors;
}();
constexpr word_lanes::Divisors lane_divisors{small_primes::table.of, small_primes::greatest_known,
                                             small_divisors.data()};

static_assert(RationalAccess::is_four_words);

/// Whether what computes eight sums at a time can read the numbers.
bool is_short(const WordLine& line) {
    return std::in_range<std::int32_t>(line.a) && std::in_range<std::int32_t>(line.b) &&
           std::in_range<std::int32_t>(line.q) && std::in_range<std::int32_t>(line.length);
}

}  // namespace

bool LinearFactorSums::evaluate_eight(std::span<const Rational* const, lanes> tuples,
                                      std::span<Rational> sums, const WordLine* line) const {
    const Prepared& rows = *prepared_;
    const word_lanes::Operations* operations = chosen_word_lanes();
    if (operations == nullptr || rows.words.empty() || rows.rows > word_lanes::most_rows ||
        rows.word_denominator == 0 || (line != nullptr && !is_short(*line)))
        return false;
    word_lanes::Quotients quotients[word_lanes::most_rows];
    const auto denominator = static_cast<std::uint64_t>(rows.word_denominator);
    const auto bits = std::bit_width(static_cast<std::uint64_t>(rows.greatest) | denominator);
    const word_lanes::Rows given{rows.words.data(), rows.rows, static_cast<std::size_t>(bits), denominator,
                                 rows.primes};
    if (!operations->sums(given, reinterpret_cast<const void* const*>(tuples.data()), rows.size - 1, line,
                          lane_divisors, quotients))
        return false;
    const std::size_t stride = given.rows;
    if (stride == 1 && operations->store(quotients[0], sums.data())) return true;
    for (std::size_t j = 0; j < stride; ++j) {
        Rational* sum = sums.data() + j;
        for (std::size_t l = 0; l < lanes; ++l, sum += stride)
            RationalAccess::set_words(*sum, quotients[j].numerators[l], quotients[j].denominators[l]);
    }
    return true;
}

}  // namespace blossom
