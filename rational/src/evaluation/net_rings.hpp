#pragma once

// The rings in which sums over nets are computed. Besides the functions that net_weights.hpp needs, each has
// multiply_each(to, a, b, count), read(integers, to) and Room, memory for numbers that are written before
// they are read. The rings of net_steps.cpp also have stride(), the number of elements per number;
// integer(number); factor(integer), by which rows are multiplied; power(integer), by which single numbers are
// multiplied; and product(number, power) as an integer.

#include <blossom/rational/integer.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "number/backend.hpp"
#include "number/uint128.hpp"
#include "residues/residue_products.hpp"
#include "residues/residue_system.hpp"

namespace blossom {

/// Memory for numbers, on the stack if they are few.
template <class Number, std::size_t in_place>
class Room {
public:
    // The unused part of the array is left uninitialized: clearing it would cost more than the work.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
    explicit Room(std::size_t size) {
        if (size > in_place) heap_ = std::make_unique_for_overwrite<Number[]>(size);
    }
    Number* data() { return heap_ ? heap_.get() : numbers_; }

private:
    Number numbers_[in_place];
    std::unique_ptr<Number[]> heap_;  // NOLINT(modernize-avoid-c-arrays): a vector would clear it
};

/// Integers modulo 2^64 or 2^128. Only the sums themselves have to fit.
template <class Word>
struct WordRing {
    using Number = Word;
    using Factor = Word;
    using Power = Word;
    using Room = blossom::Room<Word, 128>;

    static constexpr std::size_t stride() { return 1; }

    static Word one() { return 1; }
    static void add(Word* to, Word number) { *to += number; }
    static void scale(Word* to, const Word* from, Word factor, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) to[i] = from[i] * factor;
    }
    static void add_multiple(Word* to, const Word* from, Word factor, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) to[i] += from[i] * factor;
    }
    static void multiply_each(Word* to, const Word* a, const Word* b, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) to[i] = a[i] * b[i];
    }
    static Word dot(const Word* a, const Word* b, std::size_t count) {
        Word sum = 0;
        for (std::size_t i = 0; i < count; ++i) sum += a[i] * b[i];
        return sum;
    }
    static void read(std::span<const std::int64_t> integers, Word* to) {
        for (const std::int64_t integer : integers) *to++ = static_cast<Word>(integer);
    }
    static void read(std::span<const Integer> integers, Word* to) {
        for (const Integer& integer : integers) *to++ = wrapped(integer);
    }
    static Integer integer(const Word* word) {
        if constexpr (sizeof(Word) == sizeof(std::uint64_t)) {
            return static_cast<std::int64_t>(*word);
        } else {
            const std::uint64_t words[] = {static_cast<std::uint64_t>(*word),
                                           static_cast<std::uint64_t>(*word >> 64)};
            return IntegerAccess::from_twos_complement(words);
        }
    }

    static Word factor(std::size_t integer) { return integer; }
    static Word factor(const Integer& integer) { return wrapped(integer); }
    static Word power(const Integer& integer) { return wrapped(integer); }
    static Integer product(const Word* word, Word power) {
        const Word product = *word * power;
        return integer(&product);
    }

private:
    static Word wrapped(const Integer& integer) {
        if (integer.is_word()) return static_cast<Word>(integer.word());
        std::vector<std::uint64_t> words(integer.bit_length() / 64 + 2);
        IntegerAccess::to_twos_complement(integer, words);
        Word low = words[0];
        if constexpr (sizeof(Word) > sizeof(std::uint64_t)) low |= Word{words[1]} << 64;
        return low;
    }
};

/// Integers of any size.
struct IntegerRing {
    using Number = Integer;

    class Room {
    public:
        explicit Room(std::size_t size) : numbers_(size) {}
        Integer* data() { return numbers_.data(); }

    private:
        std::vector<Integer> numbers_;
    };

    static Integer one() { return 1; }
    static void add(Integer* to, const Integer& number) { *to += number; }
    static void scale(Integer* to, const Integer* from, const Integer& factor, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) to[i] = from[i] * factor;
    }
    static void add_multiple(Integer* to, const Integer* from, const Integer& factor, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) to[i].add_product(from[i], factor);
    }
    static void multiply_each(Integer* to, const Integer* a, const Integer* b, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) to[i] = a[i] * b[i];
    }
    static Integer dot(const Integer* a, const Integer* b, std::size_t count) {
        return blossom::dot({a, count}, {b, count});
    }
    static void read(std::span<const std::int64_t> integers, Integer* to) { std::ranges::copy(integers, to); }
    static void read(std::span<const Integer> integers, Integer* to) { std::ranges::copy(integers, to); }
};

/// Residues modulo the primes of one group. Weights are multiplied by the radix, the numbers of nets and
/// their sums are not.
class ResidueRing {
public:
    using Number = residues::ResidueVector;
    using Room = blossom::Room<residues::ResidueVector, 160>;

    explicit ResidueRing(const residues::Moduli& moduli) : moduli_(moduli) {}

    Number one() const { return moduli_.radix; }
    void add(Number* to, const Number& number) const {
        residues::operations().add(moduli_, to, &number, 1, to);
    }
    void scale(Number* to, const Number* from, const Number& factor, std::size_t count) const {
        residues::operations().scale(moduli_, from, factor, count, to);
    }
    void add_multiple(Number* to, const Number* from, const Number& factor, std::size_t count) const {
        constexpr std::size_t at_once = 32;
        Number products[at_once];
        for (std::size_t begin = 0; begin < count; begin += at_once) {
            const std::size_t size = std::min(at_once, count - begin);
            scale(products, from + begin, factor, size);
            residues::operations().add(moduli_, to + begin, products, size, to + begin);
        }
    }
    void multiply_each(Number* to, const Number* a, const Number* b, std::size_t count) const {
        residues::operations().multiply_each(moduli_, a, b, count, to);
    }
    Number dot(const Number* a, const Number* b, std::size_t count) const {
        Number sum = residues::operations().dot(moduli_, a, b, std::min(count, residues::most_terms));
        for (std::size_t begin = residues::most_terms; begin < count; begin += residues::most_terms) {
            const Number part = residues::operations().dot(moduli_, a + begin, b + begin,
                                                           std::min(count - begin, residues::most_terms));
            add(&sum, part);
        }
        return sum;
    }
    void read(std::span<const std::int64_t> integers, Number* to) const {
        // The magnitude in digits of as many bits as the primes have; 2^bits is congruent to delta.
        const std::size_t bits = residues::operations().prime_bits;
        const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
        Number step;
        scale(&step, &moduli_.square, moduli_.delta, 1);
        for (const std::int64_t integer : integers) {
            Number power = moduli_.square;
            *to = {};
            for (std::uint64_t rest = magnitude(integer); rest != 0;) {
                Number digit;
                std::ranges::fill(digit.lane, rest & mask);
                scale(&digit, &digit, power, 1);
                add(to, digit);
                rest >>= bits;
                if (rest != 0) scale(&power, &power, step, 1);
            }
            const Number zero{};
            if (integer < 0) residues::operations().subtract(moduli_, &zero, to, 1, to);
            ++to;
        }
    }
    void read(std::span<const Integer> integers, Number* to) const {
        residues::Digits digits;
        digits.reserve(integers.size(), 2);
        for (const Integer& integer : integers) digits.push_back(integer);
        digits.residues(moduli_, residues::montgomery_powers(moduli_, digits.most_digits()).data(), to);
    }

private:
    const residues::Moduli& moduli_;
};

}  // namespace blossom
