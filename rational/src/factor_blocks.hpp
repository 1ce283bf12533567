#pragma once

// Products of as many linear factors as have coefficients of one word.

#include <blossom/rational/linear_factor_sums.hpp>

#include <span>

#include "wide.hpp"

namespace blossom {

/// Multiplies the polynomial in coefficients[0..i] by one factor after the other, i = 0, 1, ...
template <class Word>
void multiply_one_by_one(std::span<const WordFactor> factors, Word* coefficients) {
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const auto constant = static_cast<Word>(factors[i].constant);
        const auto slope = static_cast<Word>(factors[i].slope);
        coefficients[i + 1] = slope * coefficients[i];
        for (std::size_t k = i; k > 0; --k)
            coefficients[k] = constant * coefficients[k] + slope * coefficients[k - 1];
        coefficients[0] *= constant;
    }
}

/// The magnitudes of both coefficients together; below 2^64.
inline std::uint64_t size_of(const WordFactor& factor) {
    return magnitude(factor.constant) + magnitude(factor.slope);
}

/// The product of the first factors of a sequence: of the first one, and of those that follow while the
/// magnitudes of the coefficients sum to less than 2^63.
// What is not used yet of the array stays as it is: clearing it would cost more than the work.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class FactorBlock {
public:
    void fill(std::span<const WordFactor> factors) {
        std::uint64_t bound = size_of(factors[0]);
        degree_ = 1;
        while (degree_ < factors.size() && degree_ < most_factors) {
            std::uint64_t product = 0;
            if (__builtin_mul_overflow(bound, size_of(factors[degree_]), &product) || product >> 63 != 0)
                break;
            bound = product;
            ++degree_;
        }
        fits_ = bound >> 63 == 0;
        coefficients_[0] = 1;
        multiply_one_by_one(factors.first(degree_), coefficients_);
    }

    std::size_t degree() const { return degree_; }
    /// Whether the magnitudes sum to less than 2^63; it can fail for one factor alone.
    bool fits() const { return fits_; }
    std::span<const std::int64_t> coefficients() const { return {coefficients_, degree_ + 1}; }

private:
    /// The magnitudes of a factor sum to 2 at least, unless it has one term only.
    static constexpr std::size_t most_factors = 64;

    std::size_t degree_ = 0;
    bool fits_ = false;
    std::int64_t coefficients_[most_factors + 1];
};

}  // namespace blossom
