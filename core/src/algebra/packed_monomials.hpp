#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

/// Monomials as words: exponents of 4, 8 or 16 bits, the first variable in the top bits of the first word, so
/// that words compare as the exponents do lexicographically. The top bit of each exponent is a guard, 0 in
/// stored monomials: it keeps sums of exponents apart, and comparisons of all exponents of a word at once
/// borrow from it.

namespace blossom::packed_monomials {

constexpr std::size_t least_bits = 4;
constexpr std::size_t most_bits = 16;
constexpr std::size_t greatest_exponent = 0x7fff;

/// A word with the lowest bit of every exponent.
constexpr std::uint64_t ones(std::size_t bits) {
    return bits == 4 ? 0x1111'1111'1111'1111 : bits == 8 ? 0x0101'0101'0101'0101 : 0x0001'0001'0001'0001;
}
constexpr std::uint64_t guards(std::size_t bits) { return ones(bits) << (bits - 1); }

constexpr std::size_t words_for(std::size_t variables, std::size_t bits) {
    return (variables * bits + 63) / 64;
}

/// The least width that holds an exponent of at most `greatest_exponent`.
constexpr std::size_t bits_for(std::size_t exponent) { return exponent < 8 ? 4 : exponent < 128 ? 8 : 16; }

constexpr std::size_t exponent(std::span<const std::uint64_t> monomial, std::size_t variable,
                               std::size_t bits) {
    const std::size_t place = variable * bits;
    return (monomial[place / 64] >> (64 - bits - place % 64)) & ((std::uint64_t{1} << (bits - 1)) - 1);
}

constexpr void set_exponent(std::span<std::uint64_t> monomial, std::size_t variable, std::size_t bits,
                            std::size_t exponent) {
    const std::size_t place = variable * bits;
    const std::size_t shift = 64 - bits - place % 64;
    monomial[place / 64] &= ~(((std::uint64_t{1} << bits) - 1) << shift);
    monomial[place / 64] |= std::uint64_t{exponent} << shift;
}

/// The maximum of each pair of exponents.
constexpr std::uint64_t greater_exponents(std::uint64_t a, std::uint64_t b, std::size_t bits) {
    const std::uint64_t not_less = ((a | guards(bits)) - b) & guards(bits);
    const std::uint64_t from_a = not_less - (not_less >> (bits - 1));
    return (a & from_a) | (b & ~from_a);
}

constexpr std::size_t sum_of_exponents(std::uint64_t word, std::size_t bits) {
    constexpr std::uint64_t quarters = 0x0f0f'0f0f'0f0f'0f0f;
    constexpr std::uint64_t halves = 0x00ff'00ff'00ff'00ff;
    constexpr std::uint64_t wholes = 0x0000'ffff'0000'ffff;
    if (bits == 4) word = (word & quarters) + (word >> 4 & quarters);
    if (bits <= 8) word = (word & halves) + (word >> 8 & halves);
    word = (word & wholes) + (word >> 16 & wholes);
    return (word & 0xffff'ffff) + (word >> 32);
}

/// Whether each exponent of a is at least that of b.
constexpr bool divides(std::span<const std::uint64_t> b, std::span<const std::uint64_t> a, std::size_t bits) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if ((((a[i] | guards(bits)) - b[i]) & guards(bits)) != guards(bits)) return false;
    }
    return true;
}

/// Widens the exponents of half a word from `bits` bits to twice as many.
constexpr std::uint64_t spread(std::uint64_t half, std::size_t bits) {
    half = (half | half << 16) & 0x0000'ffff'0000'ffff;
    half = (half | half << 8) & 0x00ff'00ff'00ff'00ff;
    if (bits == 8) return half;
    return (half | half << 4) & 0x0f0f'0f0f'0f0f'0f0f;
}

/// Narrows the exponents of a word from twice `bits` bits to `bits`, which gives half a word.
constexpr std::uint64_t gathered(std::uint64_t word, std::size_t bits) {
    if (bits == 4) word = (word | word >> 4) & 0x00ff'00ff'00ff'00ff;
    word = (word | word >> 8) & 0x0000'ffff'0000'ffff;
    return (word | word >> 16) & 0x0000'0000'ffff'ffff;
}

/// The number of words per monomial as a constant, so that loops over few words are unrolled; or, for 0, at
/// run time.
template <std::size_t W>
struct Width {
    using Monomial = std::conditional_t<W == 0, std::vector<std::uint64_t>, std::array<std::uint64_t, W>>;

    std::size_t count = W;

    constexpr std::size_t words() const { return W == 0 ? count : W; }
    Monomial monomial() const {
        Monomial result{};
        if constexpr (W == 0) result.resize(count);
        return result;
    }
    /// The sign of a - b in lexicographic order.
    int compare(const std::uint64_t* a, const std::uint64_t* b) const {
        for (std::size_t i = 0; i < words(); ++i) {
            if (a[i] != b[i]) return a[i] > b[i] ? 1 : -1;
        }
        return 0;
    }
    void copy(const std::uint64_t* from, std::uint64_t* to) const {
        for (std::size_t i = 0; i < words(); ++i) to[i] = from[i];
    }
    void add(const std::uint64_t* a, const std::uint64_t* b, std::uint64_t* to) const {
        for (std::size_t i = 0; i < words(); ++i) to[i] = a[i] + b[i];
    }
};

/// Calls `action` with the width for this many words per monomial.
template <class Action>
auto with_width(std::size_t words, const Action& action) {
    switch (words) {
        case 1:
            return action(Width<1>{});
        case 2:
            return action(Width<2>{});
        case 3:
            return action(Width<3>{});
        case 4:
            return action(Width<4>{});
        default:
            return action(Width<0>{words});
    }
}

/// Monomials of `words` words with exponents of `bits` bits, rewritten with `new_words` words and `new_bits`
/// bits; exponents that are dropped must be 0.
std::vector<std::uint64_t> rewritten(std::span<const std::uint64_t> monomials, std::size_t words,
                                     std::size_t bits, std::size_t new_words, std::size_t new_bits);

/// The greatest exponent of each variable, as a monomial.
std::vector<std::uint64_t> greatest_exponents(std::span<const std::uint64_t> monomials, std::size_t words,
                                              std::size_t bits);

}  // namespace blossom::packed_monomials
