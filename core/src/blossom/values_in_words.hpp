#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <optional>

namespace blossom {

/// The value by symmetric functions from monomial coefficients or by de Casteljau's algorithm from control
/// points, if words and sums of 128 bits hold all numbers on the way: no memory is taken but for the result.
std::optional<Coordinates> value_in_words(const PolynomialMap& map, std::span<const Argument> arguments,
                                          Construction construction, const Limits& limits);

}  // namespace blossom
