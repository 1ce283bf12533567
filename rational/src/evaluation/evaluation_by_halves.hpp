#pragma once

// Homogeneous polynomials at pairs of integers of any size, by halves.

#include <blossom/rational/rational.hpp>

#include <span>
#include <vector>

namespace blossom {

/// sum_k C_k u^k v^(n-k) / (D v^n). Halves of the coefficients stand over their own denominators, so that
/// what is multiplied is small for long; and what the sum shares with D is known but for a few primes.
class EvaluationByHalves {
public:
    /// `prepared` spends gcds of numbers of the size of D, n of them.
    EvaluationByHalves(std::span<const Integer> coefficients, const Integer& denominator, bool prepared);

    Rational value(const Integer& u, const Integer& v) const;

private:
    /// Coefficients begin to end; the lower half has a power of two of them.
    struct Node {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::size_t lower = 0;  ///< its node; the other half is node `upper`
        std::size_t upper = 0;
        Integer lower_factor;  ///< the denominator of the whole by that of the half
        Integer upper_factor;
    };
    struct Powers;

    std::size_t add_node(std::span<const Rational> coefficients, std::size_t begin, std::size_t end,
                         Integer& denominator);
    Integer sum(const Node& node, const Powers& powers) const;
    void separate_denominator(std::span<const Integer> coefficients);

    std::vector<Integer> leaves_;  ///< numerators of single coefficients over their own denominators
    std::vector<Node> nodes_;
    Integer greatest_;     ///< C_n, over `denominator_`
    Integer denominator_;  ///< the least common one
    Integer known_ = 1;    ///< a divisor of it whose primes divide all coefficients but one
    Integer unknown_ = 1;  ///< the rest
};

}  // namespace blossom
