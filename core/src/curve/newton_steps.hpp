#pragma once

// Between powers of y and the products (y - a_0) ... (y - a_(k-1)), for a row of coefficients in place.

#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <span>

namespace blossom {

/// By synthetic division: the coefficients of the products, from those of the powers.
inline void divide_by_nodes(std::span<Integer> row, std::span<const Integer> nodes) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k) {
        for (std::size_t i = row.size() - 1; i-- > k;) row[i].add_product(nodes[k], row[i + 1]);
    }
}

/// By Horner's rule: the coefficients of the powers, from those of the products.
inline void multiply_by_nodes(std::span<Integer> row, std::span<const Integer> nodes) {
    for (std::size_t k = row.size() - 1; k-- > 0;) {
        const Integer negative = -nodes[k];
        for (std::size_t i = k; i + 1 < row.size(); ++i) row[i].add_product(negative, row[i + 1]);
    }
}

}  // namespace blossom
