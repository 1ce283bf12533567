#include "long_gcds.hpp"

#include <algorithm>
#include <vector>

#include "limbs/limb_arithmetic.hpp"

namespace blossom {

namespace {

using gcd_lanes::digit_bits;
using gcd_lanes::most_digits;

constexpr std::uint64_t digit_mask = (std::uint64_t{1} << digit_bits) - 1;

std::uint64_t digit(std::span<const std::uint64_t> number, std::size_t i) {
    return limbs::bits_from(number, digit_bits * i) & digit_mask;
}

}  // namespace

LongGcds::LongGcds(std::span<const std::uint64_t> number,
                   std::span<const std::span<const std::uint64_t>> factors)
    : size_(factors.size()) {
    std::vector<std::uint64_t> digits((64 * number.size() + digit_bits - 1) / digit_bits);
    for (std::size_t i = 0; i < digits.size(); ++i) digits[i] = digit(number, i);
    const std::size_t twos = limbs::trailing_zeros(number.data());
    for (std::size_t lane = 0; lane < most_factors; ++lane) {
        std::uint64_t odd[most_limbs] = {1};
        if (lane < size_) {
            const std::size_t size = factors[lane].size();
            std::ranges::copy(factors[lane], odd);
            const std::size_t own = limbs::trailing_zeros(odd);
            if (own > 0) limbs::shift_right(odd, size, own);
            twos_[lane] = std::min(own, twos);
        }
        for (std::size_t i = 0; i < most_digits; ++i) gcds_.digits[i][lane] = digit(odd, i);
        gcds_.negative_inverses[lane] = (0 - inverse_of_odd(odd[0])) & digit_mask;
    }
    vectors::table().gcds->longer(digits.data(), digits.size(), gcds_);
}

std::span<const std::uint64_t> LongGcds::value(std::size_t lane, std::uint64_t* room) const {
    std::fill_n(room, most_limbs, std::uint64_t{0});
    for (std::size_t i = 0; i < most_digits; ++i) {
        const std::uint64_t digit = gcds_.digits[i][lane];
        if (digit == 0) continue;
        const std::size_t position = digit_bits * i + twos_[lane];
        const std::size_t shift = position % 64;
        room[position / 64] |= digit << shift;
        if (shift > 64 - digit_bits && position / 64 + 1 < most_limbs)
            room[position / 64 + 1] |= digit >> (64 - shift);
    }
    return {room, limbs::used(room, most_limbs)};
}

}  // namespace blossom
