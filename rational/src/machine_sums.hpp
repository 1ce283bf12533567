#pragma once

// Sums over products of linear factors in words of 64 and 128 bits. All arithmetic wraps, so that only the
// sums themselves have to fit.

#include <blossom/rational/linear_factor_sums.hpp>

#include "factor_blocks.hpp"
#include "wide.hpp"

namespace blossom::machine_sums {

/// The most factors of words that are multiplied without taking memory.
inline constexpr std::size_t most_factors = 64;

/// Multiplies the polynomial in product[0..degree] by `block`.
template <class Word>
void multiply(Word* product, std::size_t degree, std::span<const std::int64_t> block) {
    for (std::size_t k = degree + block.size(); k-- > 0;) {
        const std::size_t first = k > degree ? k - degree : 0;
        const std::size_t last = std::min(k + 1, block.size());
        Word sum = 0;
        for (std::size_t j = first; j < last; ++j) sum += product[k - j] * static_cast<Word>(block[j]);
        product[k] = sum;
    }
}

/// The coefficients of the product of all factors.
template <class Word>
class FactorProduct {
public:
    explicit FactorProduct(std::span<const WordFactor> factors) {
        coefficients_[0] = 1;
        if constexpr (sizeof(Word) == sizeof(std::uint64_t)) {
            multiply_one_by_one(factors, coefficients_);
        } else {
            FactorBlock block;
            for (std::size_t degree = 0; degree < factors.size(); degree += block.degree()) {
                block.fill(factors.subspan(degree));
                multiply(coefficients_, degree, block.coefficients());
            }
        }
    }

    Word sum_of_products(std::span<const std::int64_t> numbers) const {
        Word sum = 0;
        for (std::size_t k = 0; k < numbers.size(); ++k)
            sum += static_cast<Word>(numbers[k]) * coefficients_[k];
        return sum;
    }

private:
    Word coefficients_[most_factors + 1];
};

}  // namespace blossom::machine_sums
