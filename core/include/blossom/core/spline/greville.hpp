#pragma once

#include <blossom/core/maps/knot_vector.hpp>

#include <vector>

namespace blossom {

/// The mean of the n knots in the window of each control point. These are the control points of the identity
/// map t, whose blossom is (u_1 + ... + u_n) / n, so that (greville[j], P_j) are those of the graph of a
/// scalar curve.
///
/// Cost: n additions per point. Errors: `degree_too_low` for degree 0, which has no identity map.
/// Source: Goldman, exercise 9, for one segment. Statement: goldman-ex-9.
std::vector<Rational> greville_abscissae(const KnotVector& knots);

}  // namespace blossom
