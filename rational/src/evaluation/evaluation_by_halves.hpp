#pragma once

// Homogeneous polynomials at pairs of integers of any size, evaluated recursively by halves of the
// coefficients.

#include <blossom/rational/rational.hpp>

#include <span>
#include <vector>

namespace blossom {

/// sum_k C_k u^k v^(n-k) / (D v^n). Each half of the coefficients has its own denominator, so that most
/// products are of small numbers. The common factors of the sum and D are known except for a few primes.
class EvaluationByHalves {
public:
    /// If `prepared`, the constructor computes n gcds of numbers of the size of D.
    EvaluationByHalves(std::span<const Integer> coefficients, const Integer& denominator, bool prepared);

    Rational value(const Integer& u, const Integer& v) const;

private:
    /// The coefficients from begin to end, of which the lower half is a power of two in number.
    struct Node {
        std::size_t begin = 0;
        std::size_t end = 0;
        std::size_t lower = 0;  ///< the node of the lower half; `upper` is that of the other half
        std::size_t upper = 0;
        Integer lower_factor;  ///< the denominator of the whole divided by that of the half
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
    Integer denominator_;  ///< the least common denominator
    Integer known_ = 1;    ///< the part of `denominator_` whose primes divide all coefficients but one
    Integer unknown_ = 1;  ///< the other part
};

}  // namespace blossom
