#pragma once

// Integers in two's complement of a width that is known to suffice and grows with their bound.

#include <blossom/rational/integer.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "number/backend.hpp"
#include "number/uint128.hpp"

namespace blossom {

/// Rows of numbers, `stride` words each, of which the first `width` are in use. See net_rings.hpp.
class LimbRing {
public:
    using Number = std::uint64_t;
    using Factor = std::int64_t;

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

    void scale(Number* to, const Number* from, Factor factor, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i, to += stride_, from += stride_) {
            std::fill(to, to + width_, 0);
            add_product(to, from, factor);
        }
    }
    void add_multiple(Number* to, const Number* from, Factor factor, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i, to += stride_, from += stride_) add_product(to, from, factor);
    }

private:
    /// The words of `from` beyond its width repeat its sign.
    void add_product(Number* to, const Number* from, Factor factor) const {
        const std::uint64_t size = magnitude(factor);
        const std::uint64_t sign = static_cast<std::int64_t>(from[operands_ - 1]) < 0 ? ~std::uint64_t{0} : 0;
        UInt128 carry = 0;
        if (factor >= 0) {
            for (std::size_t i = 0; i < width_; ++i) {
                carry += UInt128{i < operands_ ? from[i] : sign} * size + to[i];
                to[i] = static_cast<std::uint64_t>(carry);
                carry >>= 64;
            }
        } else {
            for (std::size_t i = 0; i < width_; ++i) {
                carry += UInt128{i < operands_ ? from[i] : sign} * size;
                const auto low = static_cast<std::uint64_t>(carry);
                carry = (carry >> 64) + static_cast<std::uint64_t>(to[i] < low);
                to[i] -= low;
            }
        }
    }

    std::size_t stride_;
    std::size_t operands_ = 1;
    std::size_t width_ = 1;
};

}  // namespace blossom
