#include "fixed_width_rows.hpp"

#include <algorithm>

namespace blossom::fixed_width {

LimbRow::LimbRow(std::size_t size, std::size_t start_bits, std::size_t final_bits)
    : stride_(words_for(final_bits)), width_(words_for(start_bits)), bound_(start_bits), words_(size * stride_) {}

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
    bound_.multiply(Wide{own_} + neighbours_);
    widen(words_for(bound_.bits()));
}

void LimbRow::widen(std::size_t width) {
    if (width <= width_) return;
    for (std::uint64_t* x = words_.data(); x != words_.data() + words_.size(); x += stride_) {
        const std::uint64_t sign = static_cast<std::int64_t>(x[width_ - 1]) < 0 ? ~std::uint64_t{0} : 0;
        std::fill(x + width_, x + width, sign);
    }
    width_ = width;
}

void LimbRow::combine(std::size_t k, std::size_t neighbour) {
    if (subtract_) {
        combine_words<true>(entry(k), entry(neighbour), own_, neighbours_);
    } else {
        combine_words<false>(entry(k), entry(neighbour), own_, neighbours_);
    }
}

void LimbRow::scale(std::size_t k) { combine_words<false>(entry(k), entry(k), own_, 0); }

template <bool subtract>
void LimbRow::combine_words(std::uint64_t* x, const std::uint64_t* y, std::uint64_t own,
                            std::uint64_t neighbours) const {
    std::uint64_t own_carry = 0;
    std::uint64_t neighbour_carry = 0;
    SignedWide carry = 0;
    for (std::size_t i = 0; i < width_; ++i) {
        const Wide from_own = Wide{x[i]} * own + own_carry;
        const Wide from_neighbour = Wide{y[i]} * neighbours + neighbour_carry;
        own_carry = static_cast<std::uint64_t>(from_own >> 64);
        neighbour_carry = static_cast<std::uint64_t>(from_neighbour >> 64);
        const SignedWide low = static_cast<std::uint64_t>(from_own);
        const SignedWide other = static_cast<std::uint64_t>(from_neighbour);
        carry += subtract ? low - other : low + other;
        x[i] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
    }
}

}  // namespace blossom::fixed_width
