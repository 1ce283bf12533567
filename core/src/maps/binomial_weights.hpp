#pragma once

#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace blossom {

/// What turns monomial coefficients of formal degree n into normalised ones, c_k / C(n, k), over one
/// denominator.
struct BinomialWeights {
    std::vector<Integer> numerators;  ///< denominator / C(n, k)
    Integer denominator;              ///< the least common multiple of the C(n, k)
};

/// Those of the degrees met last are kept, for all threads.
std::shared_ptr<const BinomialWeights> binomial_weights(std::size_t n);

}  // namespace blossom
