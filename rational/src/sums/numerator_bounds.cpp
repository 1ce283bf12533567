#include "numerator_bounds.hpp"

#include <algorithm>
#include <bit>

#include "fixed_width_rows.hpp"
#include "large_sums.hpp"

namespace blossom {

Bounds bounds(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors) {
    fixed_width::BitBound product(1);
    fixed_width::BitBound sum(rows.bits);
    for (const WordFactor& factor : factors) {
        product.multiply(l1_norm(factor));
        sum.multiply(l1_norm(factor));
    }
    return {product.bits(), sum.bits()};
}

std::size_t sum_bits(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors) {
    return bounds(rows, factors).sum;
}

std::size_t sum_bits(const BlossomSums::PreparedRows& rows, std::span<const IntegerFactor> factors) {
    std::size_t bits = rows.bits;
    for (const IntegerFactor& factor : factors) bits += bits_of(factor);
    return bits;
}

std::size_t closer_sum_bits(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors) {
    constexpr std::size_t shift = 3;
    fixed_width::BitBound even;
    fixed_width::BitBound upper;  // of prod (|v_i| + 8 |u_i|)
    fixed_width::BitBound lower;  // of prod (8 |v_i| + |u_i|), 8^n times that for t = 1/8
    for (const WordFactor& factor : factors) {
        const UInt128 constant = magnitude(factor.constant);
        const UInt128 slope = magnitude(factor.slope);
        even.multiply(constant + slope);
        upper.multiply(constant + (slope << shift));
        lower.multiply((constant << shift) + slope);
    }
    const auto without = [](std::size_t bits, std::size_t fewer) { return bits > fewer ? bits - fewer : 0; };
    const std::size_t n = factors.size();
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < rows.numbers.size(); ++i) {
        const std::size_t k = i % rows.size;
        const std::size_t coefficient =
            std::min({even.bits(), without(upper.bits(), shift * k), without(lower.bits(), shift * (n - k))});
        greatest = std::max(greatest, rows.numbers.numerators()[i].bit_length() + coefficient);
    }
    return std::min(rows.bits + even.bits(), greatest + std::bit_width(rows.size));
}

std::size_t closer_sum_bits(const BlossomSums::PreparedRows& rows, std::span<const IntegerFactor> factors) {
    return sum_bits(rows, factors);
}

}  // namespace blossom
