#include "limb_sums.hpp"

#include <array>
#include <utility>

#include "number/uint128.hpp"

namespace blossom {

namespace {

template <std::size_t Width>
void load(const std::uint64_t* from, std::size_t width, std::uint64_t (&to)[Width]) {
    const std::uint64_t sign = static_cast<std::int64_t>(from[width - 1]) < 0 ? ~std::uint64_t{0} : 0;
    for (std::size_t i = 0; i < Width; ++i) to[i] = i < width ? from[i] : sign;
}

/// Modulo 2^(64 Width), the product of the sign-extended words is the product of the numbers.
template <std::size_t Width>
void dot(LimbView a, LimbView b, std::size_t count, std::uint64_t* result) {
    std::uint64_t sum[Width] = {};
    for (std::size_t k = 0; k < count; ++k) {
        std::uint64_t x[Width];
        std::uint64_t y[Width];
        load(a.words + k * a.stride, a.width, x);
        load(b.words + k * b.stride, b.width, y);
#pragma GCC unroll 8
        for (std::size_t i = 0; i < Width; ++i) {
            UInt128 carry = 0;
#pragma GCC unroll 8
            for (std::size_t j = 0; i + j < Width; ++j) {
                carry += UInt128{x[i]} * y[j] + sum[i + j];
                sum[i + j] = static_cast<std::uint64_t>(carry);
                carry >>= 64;
            }
        }
    }
    for (std::size_t i = 0; i < Width; ++i) result[i] = sum[i];
}

using Dot = void (*)(LimbView, LimbView, std::size_t, std::uint64_t*);

constexpr auto dots = []<std::size_t... Index>(std::index_sequence<Index...>) {
    return std::array<Dot, sizeof...(Index)>{dot<Index + 1>...};
}(std::make_index_sequence<most_sum_limbs>{});

}  // namespace

void limb_dot(LimbView a, LimbView b, std::size_t count, std::span<std::uint64_t> sum) {
    dots[sum.size() - 1](a, b, count, sum.data());
}

}  // namespace blossom
