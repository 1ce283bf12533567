#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <optional>

namespace blossom {

/// The value by symmetric functions, if words and 128-bit sums hold all intermediate numbers; only the result
/// is allocated.
std::optional<Coordinates> value_in_words(const PolynomialCurve& curve, std::span<const Argument> arguments,
                                          const Limits& limits);
/// The value by de Casteljau's algorithm under the same conditions.
std::optional<Coordinates> value_in_words(const BezierCurve& curve, std::span<const Argument> arguments,
                                          const Limits& limits);

}  // namespace blossom
