#include "word_gcds.hpp"

#include <algorithm>
#include <bit>

#include "limbs/limb_arithmetic.hpp"
#include "small_primes.hpp"
#include "vectors/vector_table.hpp"

namespace blossom {

namespace {

using gcd_lanes::word_pairs;

/// The fewest for which lanes pay.
constexpr std::size_t least_words_for_lanes = 3;

/// Numbers congruent to `number` times a power of 2^-64 modulo `Count` odd words: its words are taken off one
/// by one from below, for all at once since each waits for the one before.
template <std::size_t Count>
void set_remainders(std::span<const std::uint64_t> number, const std::uint64_t* odd, std::uint64_t* result) {
    std::uint64_t inverses[Count];
    std::uint64_t rests[Count] = {};
    for (std::size_t i = 0; i < Count; ++i) inverses[i] = inverse_of_odd(odd[i]);
    for (const std::uint64_t word : number) {
        for (std::size_t i = 0; i < Count; ++i) {
            const auto borrow = static_cast<std::uint64_t>(word < rests[i]);
            const std::uint64_t quotient = (word - rests[i]) * inverses[i];
            rests[i] = static_cast<std::uint64_t>(UInt128{quotient} * odd[i] >> 64) + borrow;
        }
    }
    std::copy_n(rests, Count, result);
}

}  // namespace

void gcds_with_words(std::span<const std::uint64_t> number, std::span<const std::uint64_t> factors,
                     std::uint64_t* common) {
    const gcd_lanes::Gcds gcds = vectors::table().gcds;
    if (factors.size() < least_words_for_lanes || gcds == nullptr) {
        for (std::size_t i = 0; i < factors.size(); ++i) {
            common[i] = gcd_of_words(limbs::remainder(number.data(), number.size(), factors[i]), factors[i]);
        }
        return;
    }
    const std::size_t twos = limbs::trailing_zeros(number.data());
    while (!factors.empty()) {
        const std::span<const std::uint64_t> some = factors.first(std::min(word_pairs, factors.size()));
        std::uint64_t odd[word_pairs];
        std::uint64_t rests[word_pairs] = {};
        std::fill_n(odd, word_pairs, std::uint64_t{1});
        for (std::size_t i = 0; i < some.size(); ++i) odd[i] = some[i] >> std::countr_zero(some[i]);
        for (std::size_t i = 0; i < some.size(); i += 4) set_remainders<4>(number, odd + i, rests + i);
        gcds(odd, rests);
        for (std::size_t i = 0; i < some.size(); ++i) {
            const auto own = static_cast<std::size_t>(std::countr_zero(some[i]));
            *common++ = odd[i] << std::min(twos, own);
        }
        factors = factors.subspan(some.size());
    }
}

}  // namespace blossom
