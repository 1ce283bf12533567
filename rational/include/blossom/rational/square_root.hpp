#pragma once

#include <blossom/rational/rational.hpp>

#include <optional>

namespace blossom {

/// The root of a square: s >= 0 with s^2 = `value`; none where no rational number has this square.
///
/// Cost: that of two integer square roots.
std::optional<Rational> exact_square_root(const Rational& value);

}  // namespace blossom
