#pragma once

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>

namespace blossom {

/// The same map with formal degree n + r: the blossom q~(u_1..u_{n+r}) is the mean of q over the n-subsets of
/// the arguments, so that the control points become P~_i = sum_j C(n, j) C(r, i - j) / C(n + r, i) P_j.
///
/// Cost: a product of polynomials of degrees n and r per coordinate; for r = 1, 2n multiply-adds. Errors:
/// `limit_exceeded` if n + r exceeds the degree.
/// Source: DeRose, section 4.4; Goldman, exercise 12. Statements: derose-raise-general, goldman-ex-12b.
BezierCurve elevate(const BezierCurve& curve, std::size_t r, const Limits& limits = {});

/// The same coefficients, with zeros for t^(n+1), ..., t^(n+r).
PolynomialCurve elevate(const PolynomialCurve& curve, std::size_t r, const Limits& limits = {});

/// The same map with degree n + r in one factor: its blossom is the mean of the old one over the n-subsets of
/// the arguments, so that one step gives P~_i = sum_k i_k / (n + 1) P_(i - e_k).
///
/// Cost: s + 1 multiply-adds per number of the result for r = 1; otherwise the homogeneous form is multiplied
/// by (x_0 + ... + x_s)^r, with C(n + s, s) C(r + s, s) multiply-adds per coordinate and entry of the other
/// factors. Errors: `limit_exceeded`. Source: DeRose, section 5.3.
/// Statements: derose-tri-raise, derose-tri-raise-points, derose-tensor-allresults.
BezierPatch elevate(const BezierPatch& patch, std::size_t factor, std::size_t r, const Limits& limits = {});

/// The same polynomial; the coefficients of higher degree are 0. Errors: `limit_exceeded`.
PolynomialPatch elevate(const PolynomialPatch& patch, std::size_t factor, std::size_t r,
                        const Limits& limits = {});

/// The same map with these degrees, one per factor. Errors: `degree_too_low` if one is below the degree of
/// the patch; `limit_exceeded`.
template <PatchRepresentation Map>
Map elevated_to(const Map& patch, std::span<const std::size_t> degrees, const Limits& limits = {});

}  // namespace blossom
