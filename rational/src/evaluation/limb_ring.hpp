#pragma once

// Integers in two's complement of a width that is known to suffice and grows with their bound.

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

/// Rows of numbers, `stride` words each, of which the first `width` are in use. See net_rings.hpp.
class LimbRing {
public:
    using Number = std::uint64_t;
    using Factor = std::int64_t;
    using Power = Integer;
    using Room = blossom::Room<std::uint64_t, 128>;

    explicit LimbRing(std::size_t stride) : stride_(stride) {}

    std::size_t stride() const { return stride_; }
    /// For the results of what follows, whose operands have had the width `operands`.
    void set_width(std::size_t operands, std::size_t width) {
        operands_ = operands;
        width_ = width;
    }

    void read(std::span<const Integer> integers, Number* to) const {
        for (const Integer& integer : integers) {
            IntegerAccess::to_twos_complement(integer, {to, width_});
            to += stride_;
        }
    }
    Integer integer(const Number* number) const {
        return IntegerAccess::from_twos_complement({number, width_});
    }

    Integer product(const Number* number, const Integer& factor) {
        magnitude_.assign(number, number + width_);
        const bool negative = limbs::take_magnitude(magnitude_);
        const std::size_t size = std::max<std::size_t>(limbs::used(magnitude_.data(), width_), 1);
        factor_.resize(limbs::size_of(factor));
        limbs::write_magnitude(factor, factor_.data(), factor_.size());
        product_.resize(size + factor_.size());
        limbs::multiply_any(product_.data(), {magnitude_.data(), size}, factor_);
        return IntegerAccess::from_magnitude(product_, negative);
    }

    void scale(Number* to, const Number* from, Factor factor, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i, to += stride_, from += stride_) {
            std::fill(to + operands_, to + width_, 0);
            const std::uint64_t size = magnitude(factor);
            add_top(to, from, limbs::set_multiple(to, from, operands_, size), size);
            if (factor < 0) limbs::negate(to, width_);
        }
    }
    void add_multiple(Number* to, const Number* from, Factor factor, std::size_t count) const {
        if (factor < 0) {
            const std::uint64_t size = magnitude(factor);
            for (std::size_t i = 0; i < count; ++i, to += stride_, from += stride_)
                subtract_top(to, from, limbs::subtract_multiple(to, from, operands_, size), size);
        } else {
            const auto size = static_cast<std::uint64_t>(factor);
            for (std::size_t i = 0; i < count; ++i, to += stride_, from += stride_)
                add_top(to, from, limbs::add_multiple(to, from, operands_, size), size);
        }
    }

private:
    /// The words of `from` beyond its width repeat its sign.
    std::uint64_t sign_of(const Number* from) const {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(from[operands_ - 1]) >> 63);
    }
    void add_top(Number* to, const Number* from, std::uint64_t carry, std::uint64_t factor) const {
        const UInt128 repeated = UInt128{sign_of(from)} * factor;
        UInt128 sum = carry;
        for (std::size_t i = operands_; i < width_; ++i) {
            sum += repeated;
            const auto low = static_cast<std::uint64_t>(sum);
            to[i] += low;
            sum = (sum >> 64) + static_cast<std::uint64_t>(to[i] < low);
        }
    }
    void subtract_top(Number* to, const Number* from, std::uint64_t borrow, std::uint64_t factor) const {
        const UInt128 repeated = UInt128{sign_of(from)} * factor;
        UInt128 sum = borrow;
        for (std::size_t i = operands_; i < width_; ++i) {
            sum += repeated;
            const auto low = static_cast<std::uint64_t>(sum);
            sum = (sum >> 64) + static_cast<std::uint64_t>(to[i] < low);
            to[i] -= low;
        }
    }

    std::size_t stride_;
    std::size_t operands_ = 1;
    std::size_t width_ = 1;
    std::vector<std::uint64_t> magnitude_;  ///< room of product()
    std::vector<std::uint64_t> factor_;
    std::vector<std::uint64_t> product_;
};

}  // namespace blossom
