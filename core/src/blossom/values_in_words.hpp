#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <optional>

namespace blossom {

/// The value by symmetric functions, if words and sums of 128 bits hold all numbers on the way: no memory is
/// taken but for the result.
std::optional<Coordinates> value_in_words(const PolynomialCurve& curve, std::span<const Argument> arguments,
                                          const Limits& limits);
/// The value by de Casteljau's algorithm, likewise.
std::optional<Coordinates> value_in_words(const BezierCurve& curve, std::span<const Argument> arguments,
                                          const Limits& limits);

}  // namespace blossom
