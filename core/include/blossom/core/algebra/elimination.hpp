#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The resultant in t of f = sum f_k t^k and g = sum g_k t^k, whose coefficients are polynomials in s: a
/// polynomial in s that vanishes exactly where f and g have a common root t in the complex numbers or both of
/// their leading coefficients vanish. It is the zero polynomial exactly if f and g have a common factor of
/// positive degree in t, or one of them is zero. Leading coefficients that are zero are left out.
///
/// Cost: see `blossom::resultant` of polynomials with integer coefficients. Errors: `limit_exceeded`.
Polynomial resultant(std::span<const Polynomial> f, std::span<const Polynomial> g, const Limits& limits = {});

}  // namespace blossom
