#include "word_gcds.hpp"

#include <algorithm>
#include <bit>

#include "limbs/limb_arithmetic.hpp"
#include "vectors/vector_table.hpp"

namespace blossom {

namespace {

using gcd_lanes::word_pairs;

/// The least number of words for which vector lanes pay.
constexpr std::size_t least_words_for_lanes = 3;

}  // namespace

void gcds_with_words(std::span<const std::uint64_t> number, std::span<const std::uint64_t> factors,
                     std::uint64_t* common) {
    const gcd_lanes::Operations* const gcds = vectors::table().gcds;
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
        for (std::size_t i = 0; i < some.size(); ++i) {
            odd[i] = some[i] >> std::countr_zero(some[i]);
            rests[i] = limbs::remainder(number.data(), number.size(), odd[i]);
        }
        gcds->words(odd, rests);
        for (std::size_t i = 0; i < some.size(); ++i) {
            const auto own = static_cast<std::size_t>(std::countr_zero(some[i]));
            *common++ = odd[i] << std::min(twos, own);
        }
        factors = factors.subspan(some.size());
    }
}

}  // namespace blossom
