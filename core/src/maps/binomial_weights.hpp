#pragma once

#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace blossom {

/// The factors 1 / C(n, k) that normalise monomial coefficients c_k of formal degree n, over one denominator.
struct BinomialWeights {
    std::vector<Integer> numerators;  ///< denominator / C(n, k)
    Integer denominator;              ///< the least common multiple of the C(n, k)
};

/// The weights of the most recent degrees are kept, for all threads.
std::shared_ptr<const BinomialWeights> binomial_weights(std::size_t n);

}  // namespace blossom
