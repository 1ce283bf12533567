#include "word_gcds.hpp"

#include <algorithm>
#include <bit>

#include "limb_arithmetic.hpp"
#include "residue_system.hpp"
#include "small_primes.hpp"
#include "word_gcd_lanes.hpp"

namespace blossom {

namespace {

using word_gcd_lanes::pairs_at_once;

/// What computes sixteen gcds at a time here; nothing on processors without.
word_gcd_lanes::Gcds chosen_gcds() {
    static const word_gcd_lanes::Gcds chosen = []() -> word_gcd_lanes::Gcds {
#if defined(BLOSSOM_AVX512_GCDS)
        if (residues::vector_level() == "ifma" && __builtin_cpu_supports("avx512f") &&
            __builtin_cpu_supports("avx512cd"))
            return word_gcd_lanes::avx512_gcds;
#endif
        return nullptr;
    }();
    return chosen;
}

/// The fewest for which lanes pay.
constexpr std::size_t least_for_lanes = 3;

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
            const std::uint64_t digit = (word - rests[i]) * inverses[i];
            rests[i] = static_cast<std::uint64_t>(Wide{digit} * odd[i] >> 64) + borrow;
        }
    }
    std::copy_n(rests, Count, result);
}

}  // namespace

void gcds_with_words(std::span<const std::uint64_t> number, std::span<const std::uint64_t> factors,
                     std::uint64_t* common) {
    const word_gcd_lanes::Gcds gcds_in_lanes = factors.size() < least_for_lanes ? nullptr : chosen_gcds();
    if (gcds_in_lanes == nullptr) {
        for (std::size_t i = 0; i < factors.size(); ++i) {
            common[i] = gcd_of_words(limbs::remainder(number.data(), number.size(), factors[i]), factors[i]);
        }
        return;
    }
    const std::size_t twos = limbs::trailing_zeros(number.data());
    while (!factors.empty()) {
        const std::span<const std::uint64_t> some = factors.first(std::min(pairs_at_once, factors.size()));
        std::uint64_t odd[pairs_at_once];
        std::uint64_t rests[pairs_at_once] = {};
        std::fill_n(odd, pairs_at_once, std::uint64_t{1});
        for (std::size_t i = 0; i < some.size(); ++i) odd[i] = some[i] >> std::countr_zero(some[i]);
        for (std::size_t i = 0; i < some.size(); i += 4) set_remainders<4>(number, odd + i, rests + i);
        gcds_in_lanes(odd, rests);
        for (std::size_t i = 0; i < some.size(); ++i) {
            const std::size_t own = static_cast<std::size_t>(std::countr_zero(some[i]));
            *common++ = odd[i] << std::min(twos, own);
        }
        factors = factors.subspan(some.size());
    }
}

}  // namespace blossom
