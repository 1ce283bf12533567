#pragma once

#include <blossom/rational/rational.hpp>

#include <span>

namespace blossom::testing {

/// sum_k c_k t^k by Horner's rule in lowest terms throughout.
inline Rational horner_value(std::span<const Rational> coefficients, const Rational& t) {
    Rational sum;
    for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * t + coefficients[k];
    return sum;
}

}  // namespace blossom::testing
