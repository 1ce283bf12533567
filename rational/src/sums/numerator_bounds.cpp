#include "numerator_bounds.hpp"

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

}  // namespace blossom
