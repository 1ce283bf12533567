#pragma once

// Products of linear factors, as many per block as have coefficients of one word.

#include <blossom/rational/blossom_sums.hpp>

#include <algorithm>
#include <span>
#include <type_traits>

#include "number/uint128.hpp"

namespace blossom {

/// Calls run(count) with the count as a constant if it is small, so that the compiler unrolls loops over it.
template <class Run>
decltype(auto) with_small_constant(std::size_t count, const Run& run) {
    using std::integral_constant;
    switch (count) {
        case 1:
            return run(integral_constant<std::size_t, 1>{});
        case 2:
            return run(integral_constant<std::size_t, 2>{});
        case 3:
            return run(integral_constant<std::size_t, 3>{});
        case 4:
            return run(integral_constant<std::size_t, 4>{});
        case 5:
            return run(integral_constant<std::size_t, 5>{});
        case 6:
            return run(integral_constant<std::size_t, 6>{});
        case 7:
            return run(integral_constant<std::size_t, 7>{});
        default:
            return run(integral_constant<std::size_t, std::dynamic_extent>{});
    }
}

/// Multiplies the polynomial in coefficients[0..i] by factor i, for i = 0, 1, ...
template <class Word, std::size_t Count>
[[gnu::always_inline]] inline void multiply_one_by_one(std::span<const WordFactor, Count> factors,
                                                       Word* coefficients) {
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const auto constant = static_cast<Word>(factors[i].constant);
        const auto slope = static_cast<Word>(factors[i].slope);
        coefficients[i + 1] = slope * coefficients[i];
        for (std::size_t k = i; k > 0; --k)
            coefficients[k] = constant * coefficients[k] + slope * coefficients[k - 1];
        coefficients[0] *= constant;
    }
}

/// The sum of the magnitudes of both coefficients, which is below 2^64.
inline std::uint64_t l1_norm(const WordFactor& factor) {
    return magnitude(factor.constant) + magnitude(factor.slope);
}

/// The product of the first factors of a sequence: always of the first one, and of up to `most` factors while
/// the magnitudes of the coefficients sum to less than 2^bits.
/// The unused part of the array is left uninitialized, because clearing it would take longer than the
/// computation.
/// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class FactorBlock {
    /// The magnitudes of a factor sum to at least 2, unless it has only one term.
    static constexpr std::size_t most_factors = 64;

public:
    void fill(std::span<const WordFactor> factors, std::size_t most = most_factors, int bits = 63) {
        bound_ = factors.empty() ? 1 : l1_norm(factors[0]);
        degree_ = std::min<std::size_t>(factors.size(), 1);
        while (degree_ < std::min({factors.size(), most, most_factors})) {
            std::uint64_t product = 0;
            if (__builtin_mul_overflow(bound_, l1_norm(factors[degree_]), &product) || product >> bits != 0)
                break;
            bound_ = product;
            ++degree_;
        }
        fits_ = bound_ >> bits == 0;
        coefficients_[0] = 1;
        with_small_constant(degree_, [&](auto count) {
            multiply_one_by_one(std::span<const WordFactor, count>(factors.data(), degree_), coefficients_);
        });
    }

    std::size_t degree() const { return degree_; }
    /// A bound on the sum of the magnitudes, and whether it is below 2^bits, which can fail for a single
    /// factor.
    std::uint64_t bound() const { return bound_; }
    bool fits() const { return fits_; }
    std::span<const std::int64_t> coefficients() const { return {coefficients_, degree_ + 1}; }

private:
    std::size_t degree_ = 0;
    std::uint64_t bound_ = 0;
    bool fits_ = false;
    std::int64_t coefficients_[most_factors + 1];
};

}  // namespace blossom
