#pragma once

// Numbers >= 0 as limbs, least significant first, in memory that the caller owns.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "number/backend.hpp"
#include "number/uint128.hpp"

namespace blossom::limbs {

using Limb = std::uint64_t;

/// The size without zero limbs at the top.
inline std::size_t used(const Limb* number, std::size_t size) {
    while (size > 0 && number[size - 1] == 0) --size;
    return size;
}

#if defined(BLOSSOM_NUMBERS_GMP)

/// Whether `multiply` takes fewer than m n products of limbs for large m and n.
inline constexpr bool multiplies_long_numbers_fast = true;

static_assert(GMP_NUMB_BITS == 64 && sizeof(mp_limb_t) == sizeof(Limb));

/// sum = a + b or a - b, and the carry or borrow; the result may overlap a or b exactly.
inline Limb add(Limb* sum, const Limb* a, const Limb* b, std::size_t size) {
    return mpn_add_n(sum, a, b, static_cast<mp_size_t>(size));
}
inline Limb subtract(Limb* difference, const Limb* a, const Limb* b, std::size_t size) {
    return mpn_sub_n(difference, a, b, static_cast<mp_size_t>(size));
}
/// product[0..m + n) = a b for m >= n >= 1; the product does not overlap the factors.
inline void multiply(Limb* product, const Limb* a, std::size_t m, const Limb* b, std::size_t n) {
    mpn_mul(product, a, static_cast<mp_size_t>(m), b, static_cast<mp_size_t>(n));
}
/// to += a b or to -= a b, and the carry or borrow.
inline Limb add_multiple(Limb* to, const Limb* a, std::size_t size, Limb b) {
    return mpn_addmul_1(to, a, static_cast<mp_size_t>(size), b);
}
inline Limb subtract_multiple(Limb* to, const Limb* a, std::size_t size, Limb b) {
    return mpn_submul_1(to, a, static_cast<mp_size_t>(size), b);
}
/// quotient[0..m - n] and remainder[0..n) of a / b for m >= n >= 1, where the top limb of b is not 0; the
/// remainder may be stored in a.
inline void divide(Limb* quotient, Limb* remainder, const Limb* a, std::size_t m, const Limb* b,
                   std::size_t n) {
    mpn_tdiv_qr(quotient, remainder, 0, a, static_cast<mp_size_t>(m), b, static_cast<mp_size_t>(n));
}
inline Limb remainder(const Limb* a, std::size_t size, Limb divisor) {
    return mpn_mod_1(a, static_cast<mp_size_t>(size), divisor);
}
/// Writes gcd(a, b) and returns its size, for numbers whose top limbs are not 0, b odd and not longer than a;
/// both are destroyed.
inline std::size_t gcd_with_odd(Limb* result, Limb* a, std::size_t m, Limb* b, std::size_t n) {
    return static_cast<std::size_t>(
        mpn_gcd(result, a, static_cast<mp_size_t>(m), b, static_cast<mp_size_t>(n)));
}

#else

inline constexpr bool multiplies_long_numbers_fast = false;

inline Limb add(Limb* sum, const Limb* a, const Limb* b, std::size_t size) {
    UInt128 carry = 0;
    for (std::size_t i = 0; i < size; ++i) {
        carry += UInt128{a[i]} + b[i];
        sum[i] = static_cast<Limb>(carry);
        carry >>= 64;
    }
    return static_cast<Limb>(carry);
}
inline Limb subtract(Limb* difference, const Limb* a, const Limb* b, std::size_t size) {
    Limb borrow = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const UInt128 rest = UInt128{a[i]} - b[i] - borrow;
        difference[i] = static_cast<Limb>(rest);
        borrow = static_cast<Limb>(rest >> 64) & 1;
    }
    return borrow;
}
inline void multiply(Limb* product, const Limb* a, std::size_t m, const Limb* b, std::size_t n) {
    std::fill(product, product + m + n, Limb{0});
    for (std::size_t j = 0; j < n; ++j) {
        UInt128 carry = 0;
        for (std::size_t i = 0; i < m; ++i) {
            carry += UInt128{a[i]} * b[j] + product[i + j];
            product[i + j] = static_cast<Limb>(carry);
            carry >>= 64;
        }
        product[m + j] = static_cast<Limb>(carry);
    }
}
inline Limb add_multiple(Limb* to, const Limb* a, std::size_t size, Limb b) {
    UInt128 carry = 0;
    for (std::size_t i = 0; i < size; ++i) {
        carry += UInt128{a[i]} * b + to[i];
        to[i] = static_cast<Limb>(carry);
        carry >>= 64;
    }
    return static_cast<Limb>(carry);
}
inline Limb subtract_multiple(Limb* to, const Limb* a, std::size_t size, Limb b) {
    UInt128 borrow = 0;
    for (std::size_t i = 0; i < size; ++i) {
        borrow += UInt128{a[i]} * b;
        const auto low = static_cast<Limb>(borrow);
        borrow = (borrow >> 64) + static_cast<Limb>(to[i] < low);
        to[i] -= low;
    }
    return static_cast<Limb>(borrow);
}
inline void write(const backend::Number& value, Limb* to, std::size_t size) {
    std::fill(to, to + size, Limb{0});
    if (value != 0) backend::to_words(value, {to, size});
}
inline backend::Number number(const Limb* from, std::size_t size) {
    backend::Number value;
    boost::multiprecision::import_bits(value, from, from + size, 64, false);
    return value;
}
inline void divide(Limb* quotient, Limb* remainder, const Limb* a, std::size_t m, const Limb* b,
                   std::size_t n) {
    const backend::Number dividend = number(a, m);
    const backend::Number divisor = number(b, n);
    write(dividend / divisor, quotient, m - n + 1);
    write(dividend % divisor, remainder, n);
}
inline Limb remainder(const Limb* a, std::size_t size, Limb divisor) {
    Limb rest = 0;
    for (std::size_t i = size; i-- > 0;) rest = static_cast<Limb>((UInt128{rest} << 64 | a[i]) % divisor);
    return rest;
}
inline std::size_t gcd_with_odd(Limb* result, Limb* a, std::size_t m, Limb* b, std::size_t n) {
    write(gcd(number(a, m), number(b, n)), result, n);
    return used(result, n);
}

#endif

/// The 64 bits of a number from `bit` on; bits beyond its limbs are 0.
inline Limb bits_from(std::span<const Limb> number, std::size_t bit) {
    const auto limb = [&](std::size_t i) { return i < number.size() ? number[i] : 0; };
    const UInt128 pair = UInt128{limb(bit / 64 + 1)} << 64 | limb(bit / 64);
    return static_cast<Limb>(pair >> (bit % 64));
}

/// product[0..m + n) = a b for factors of any nonzero sizes; the product does not overlap the factors.
inline void multiply_any(Limb* product, std::span<const Limb> a, std::span<const Limb> b) {
    if (a.size() < b.size()) std::swap(a, b);
    multiply(product, a.data(), a.size(), b.data(), b.size());
}

/// number[0..size) *= factor, where size 0 stands for the number 1; updates the size.
inline void multiply_by_word(Limb* number, std::size_t& size, Limb factor) {
    UInt128 carry = size == 0 ? UInt128{factor} : UInt128{0};
    for (std::size_t i = 0; i < size; ++i) {
        carry += UInt128{number[i]} * factor;
        number[i] = static_cast<Limb>(carry);
        carry >>= 64;
    }
    if (carry != 0) number[size++] = static_cast<Limb>(carry);
}

/// The number of limbs of a value, at least 1.
inline std::size_t size_of(const Integer& value) {
    return value.bit_length() / 64 + (value.bit_length() % 64 != 0 || value.is_zero() ? 1 : 0);
}

/// Writes |value| to `size` limbs, which suffice.
inline void write_magnitude(const Integer& value, Limb* to, std::size_t size) {
    std::fill(to, to + size, Limb{0});
    IntegerAccess::visit(value, [&](const auto& number) {
        if constexpr (std::is_same_v<decltype(number), const std::int64_t&>) {
            to[0] = magnitude(number);
        } else {
            backend::to_words(number, {to, size});
        }
    });
}

/// The number of trailing zero bits of a number > 0.
inline std::size_t trailing_zeros(const Limb* number) {
    std::size_t zeros = 0;
    for (; *number == 0; ++number) zeros += 64;
    return zeros + static_cast<std::size_t>(std::countr_zero(*number));
}

/// a = floor(a / 2^bits) for bits < 64 size.
inline void shift_right(Limb* a, std::size_t size, std::size_t bits) {
    const std::size_t limbs = bits / 64;
    const std::size_t rest = bits % 64;
    for (std::size_t i = 0; i < size; ++i) {
        const Limb low = i + limbs < size ? a[i + limbs] : 0;
        const Limb high = i + limbs + 1 < size ? a[i + limbs + 1] : 0;
        a[i] = rest == 0 ? low : low >> rest | high << (64 - rest);
    }
}

/// number = -number modulo 2^(64 size).
inline void negate(Limb* number, std::size_t size) {
    bool carry = true;
    for (std::size_t i = 0; i < size; ++i) {
        number[i] = ~number[i] + static_cast<Limb>(carry);
        carry = carry && number[i] == 0;
    }
}

/// Replaces a number in two's complement by its magnitude, and returns whether it was negative.
inline bool take_magnitude(std::span<Limb> number) {
    const bool negative = number.back() >> 63 != 0;
    if (negative) negate(number.data(), number.size());
    return negative;
}

}  // namespace blossom::limbs
