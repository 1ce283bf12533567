#pragma once

// Integers in two's complement of a width that provably suffices and grows with their bound.

#include <blossom/rational/integer.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "limbs/limb_arithmetic.hpp"
#include "net_rings.hpp"
#include "number/backend.hpp"
#include "number/uint128.hpp"

namespace blossom {

/// Rows of numbers of `stride` words each, of which the first `width` are in use. See net_rings.hpp.
class LimbRing {
public:
    using Number = std::uint64_t;
    using Power = Integer;
    using Room = blossom::Room<std::uint64_t, 128>;

    /// A magnitude with its sign.
    struct Factor {
        std::uint64_t word;
        bool negative;
        std::vector<std::uint64_t> further;  ///< the higher words, usually none
    };

    explicit LimbRing(std::size_t stride) : stride_(stride), operands_(stride), width_(stride) {}

    std::size_t stride() const { return stride_; }
    /// Sets the width of the following results and of their operands.
    void set_width(std::size_t operands, std::size_t width) {
        operands_ = operands;
        width_ = width;
    }

    static Factor factor(std::size_t value) { return {value, false, {}}; }
    static Factor factor(const Integer& value) {
        std::vector<std::uint64_t> words(limbs::size_of(value));
        limbs::write_magnitude(value, words.data(), words.size());
        return {words[0], value.sign() < 0, {words.begin() + 1, words.end()}};
    }
    static Integer power(const Integer& value) { return value; }

    void read(std::span<const Integer> integers, Number* to) const {
        for (const Integer& integer : integers) {
            IntegerAccess::to_twos_complement(integer, {to, width_});
            to += stride_;
        }
    }
    Integer integer(const Number* number) const {
        return IntegerAccess::from_twos_complement({number, width_});
    }
    Integer product(const Number* number, const Integer& power) {
        magnitude_.assign(number, number + width_);
        const bool negative = limbs::take_magnitude(magnitude_);
        const std::size_t size = std::max<std::size_t>(limbs::used(magnitude_.data(), width_), 1);
        power_.resize(limbs::size_of(power));
        limbs::write_magnitude(power, power_.data(), power_.size());
        product_.resize(size + power_.size());
        limbs::multiply_any(product_.data(), {magnitude_.data(), size}, power_);
        return IntegerAccess::from_magnitude(product_, negative);
    }

    void scale(Number* to, const Number* from, const Factor& factor, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i) std::fill_n(to + i * stride_, width_, 0);
        add_multiple(to, from, factor, count);
    }
    void add_multiple(Number* to, const Number* from, const Factor& factor, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i, to += stride_, from += stride_) {
            std::span<Number> number(to, width_);
            add(number, from, factor.word, factor.negative);
            for (const std::uint64_t word : factor.further) {
                number = number.subspan(1);
                if (number.empty()) break;
                add(number, from, word, factor.negative);
            }
        }
    }

private:
    // The word that repeats the sign of `from` beyond its width.
    std::uint64_t sign_of(const Number* from) const {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(from[operands_ - 1]) >> 63);
    }
    /// to += from * factor, or to -= from * factor.
    template <bool subtracts>
    void accumulate(std::span<Number> to, const Number* from, std::uint64_t factor) const {
        const std::size_t size = std::min(operands_, to.size());
        const UInt128 repeated = UInt128{sign_of(from)} * factor;
        UInt128 carry = subtracts ? limbs::subtract_multiple(to.data(), from, size, factor)
                                  : limbs::add_multiple(to.data(), from, size, factor);
        for (Number& word : to.subspan(size)) {
            carry += repeated;
            const auto low = static_cast<std::uint64_t>(carry);
            const Number result = subtracts ? word - low : word + low;
            carry = (carry >> 64) + static_cast<std::uint64_t>(subtracts ? word < low : result < low);
            word = result;
        }
    }
    void add(std::span<Number> to, const Number* from, std::uint64_t factor, bool negative) const {
        negative ? accumulate<true>(to, from, factor) : accumulate<false>(to, from, factor);
    }

    std::size_t stride_;
    std::size_t operands_;
    std::size_t width_;
    std::vector<std::uint64_t> magnitude_;  ///< scratch memory of product()
    std::vector<std::uint64_t> power_;
    std::vector<std::uint64_t> product_;
};

}  // namespace blossom
