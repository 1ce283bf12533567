#include "fixed_width_rows.hpp"

#include <blossom/rational/resource_budget.hpp>

#include <algorithm>

#include "factor_blocks.hpp"

namespace blossom::fixed_width {

LimbRow::LimbRow(std::size_t size, std::size_t start_bits, std::size_t final_bits)
    : stride_(words_for(final_bits)),
      width_(words_for(start_bits)),
      bound_(start_bits),
      words_(size * stride_) {}

void LimbRow::set(std::size_t k, const Integer& value) {
    IntegerAccess::to_twos_complement(value, {entry(k), width_});
}

Integer LimbRow::integer(std::size_t k) const {
    Integer value = IntegerAccess::from_twos_complement({words_.data() + k * stride_, width_});
    return negated_ ? -std::move(value) : value;
}

void LimbRow::set_weights(std::int64_t own, std::int64_t neighbours) {
    subtract_ = (own < 0) != (neighbours < 0);
    negated_ ^= own < 0;
    own_ = magnitude(own);
    neighbours_ = magnitude(neighbours);
    bound_.multiply(UInt128{own_} + neighbours_);
    widen();
    spend_work(words_.size() / stride_ * width_);
}

void LimbRow::widen() {
    // The bound can exceed `final_bits`, depending on how factors were grouped; both are upper bounds.
    const std::size_t width = std::min(words_for(bound_.bits()), stride_);
    if (width <= width_) return;
    for (std::uint64_t* x = words_.data(); x != words_.data() + words_.size(); x += stride_) {
        const std::uint64_t sign = static_cast<std::int64_t>(x[width_ - 1]) < 0 ? ~std::uint64_t{0} : 0;
        std::fill(x + width_, x + width, sign);
    }
    width_ = width;
}

void LimbRow::combine(std::size_t k, std::size_t neighbour) { combine(k, neighbour, neighbours_); }

// Both weights are below 2^63, so that a product of each with a word, and a carry, fit in 128 bits with a
// sign.
void LimbRow::combine(std::size_t k, std::size_t neighbour, std::uint64_t neighbours) {
    std::uint64_t* x = entry(k);
    const std::uint64_t* y = entry(neighbour);
    const auto run = [&](auto add) {
        decltype(add(UInt128{}, UInt128{}, 0)) carry = 0;
        for (std::size_t i = 0; i < width_; ++i) {
            carry = add(UInt128{x[i]} * own_, UInt128{y[i]} * neighbours, carry);
            x[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
    };
    if (subtract_) {
        run([](UInt128 own, UInt128 other, Int128 carry) -> Int128 {
            return static_cast<Int128>(own) - static_cast<Int128>(other) + carry;
        });
    } else {
        run([](UInt128 own, UInt128 other, UInt128 carry) -> UInt128 { return own + other + carry; });
    }
}

// Each coefficient is used as the word that is congruent to it modulo 2^64. For a negative coefficient this
// is 2^64 too large, which `excess` subtracts one word higher.
void LimbRow::multiply(std::span<const std::int64_t> factor, std::size_t degree) {
    UInt128 sum = 0;
    for (const std::int64_t coefficient : factor) sum += magnitude(coefficient);
    bound_.multiply(sum);
    widen();
    spend_work((degree + factor.size()) * factor.size() * width_);

    for (std::size_t k = degree + factor.size(); k-- > 0;) {
        const std::size_t first = k > degree ? k - degree : 0;
        const std::size_t last = std::min(k + 1, factor.size());
        Int128 carry = 0;
        for (std::size_t i = 0; i < width_; ++i) {
            auto total = static_cast<UInt128>(carry);
            std::uint64_t excess = 0;
            const std::uint64_t* word = entry(k - first) + i;
            for (std::size_t j = first; j < last; ++j, word -= stride_) {
                total += UInt128{*word} * static_cast<std::uint64_t>(factor[j]);
                excess += factor[j] < 0 ? *word : 0;
            }
            entry(k)[i] = static_cast<std::uint64_t>(total);
            carry = static_cast<Int128>(total - (UInt128{excess} << 64)) >> 64;
        }
    }
}

void LimbRow::multiply_out(std::span<const WordFactor> factors) {
    FactorBlock block;
    for (std::size_t degree = 0; degree < factors.size(); degree += block.degree()) {
        block.fill(factors.subspan(degree));
        if (block.fits()) {
            multiply(block.coefficients(), degree);
        } else {
            set_weights(factors[degree].constant, factors[degree].slope);
            for (std::size_t k = degree + 1; k > 0; --k) combine(k, k - 1);
            scale(0);
        }
    }
}

}  // namespace blossom::fixed_width
