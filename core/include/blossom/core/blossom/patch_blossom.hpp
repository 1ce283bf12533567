#pragma once

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <vector>

namespace blossom {

/// The blossom of a patch: symmetric and linear in the arguments of each factor, and equal to the map on the
/// diagonal.
///
/// In each factor, the weights of the control points are the coefficients of prod_j sum_k argument_jk X_k;
/// those of monomial coefficients are the same divided by multinomial coefficients. Over tuples (mass, x_1,
/// ..., x_s) they are the symmetric functions of points. Cost: one multiply-add per point and coordinate; for
/// the weights at most (s + 1) C(n + s, s + 1) multiply-adds per factor, or s C(n + s, s) if all arguments
/// are equal; in words if these provably suffice, otherwise modulo primes. Errors: those of
/// `require_arguments`; `limit_exceeded`. Source: DeRose, sections 5 and 6, theorem 3 and equation (3);
/// Fernandez-Jambrina, equation (9). Statements: derose-tensor-props, derose-thm3, derose-adt-blossom,
/// fj-eq9, fj-tri-blossom.
template <PatchRepresentation Map>
Coordinates blossom_value(const Map& patch, const PatchArguments& arguments, const Limits& limits = {});

/// The blossom by the given construction, each from its own data: symmetric functions of points from monomial
/// coefficients, the inverse formula from values of the map alone, de Casteljau from a control net. For a
/// polynomial, this net is over the origin and the ends of the unit vectors; for a control net, the monomials
/// are those in the differences from its first vertex.
///
/// Cost: C(n + s, s + 1) multiply-adds per factor, or prod (m_i + 1) values for polarization. Errors: those
/// of `require_arguments`; `wrong_kind` for regrouped polarization; `limit_exceeded`. Source: DeRose, theorem
/// 3; Fernandez-Jambrina, equation (21). Statements: derose-thm3, fj-eq21, fj-tri-blossom.
Coordinates blossom_value(const PatchMap& map, const PatchArguments& arguments, Construction construction,
                          const Limits& limits = {});

/// The values at points, by Bernstein polynomials or monomials. `PatchValues` gives the same values and keeps
/// the data that is prepared here for one call.
///
/// Cost: one multiplication per control point and coordinate, and that of `PatchValues` per point. Errors:
/// `not_affine` for a mass other than 1, `wrong_arity`, `mismatched_dimensions`, with places below `Part::at
/// / i`; `limit_exceeded`. Statements: fj-tri-def, fj-tensor-matrix.
template <PatchRepresentation Map>
std::vector<Coordinates> evaluate(const Map& patch, std::span<const PatchPoint> points,
                                  const Limits& limits = {});
template <PatchRepresentation Map>
Coordinates evaluate(const Map& patch, const PatchPoint& point, const Limits& limits = {}) {
    return evaluate(patch, std::span(&point, 1), limits).front();
}

/// The mixed derivative in the directions, k_f vectors of each factor f: prod n_f! / (n_f - k_f)! times the
/// blossom at n_f - k_f copies of the point and the directions; zero where k_f > n_f.
///
/// Cost: one blossom value. Errors: `not_affine` for a direction whose mass is not 0 or a point whose mass is
/// not 1; `wrong_arity`, `mismatched_dimensions`, `limit_exceeded`. Source: Goldman, theorem 9, in each
/// factor.
template <PatchRepresentation Map>
Coordinates derivative(const Map& patch, const PatchArguments& directions, const PatchPoint& at,
                       const Limits& limits = {});

/// The same derivative as a patch of degree n_f - k_f in each factor: one step of de Casteljau's algorithm
/// per direction. If some k_f > n_f, it is zero of degree 0 in every factor. Errors: as for `derivative`.
template <PatchRepresentation Map>
Map derivative_patch(const Map& patch, const PatchArguments& directions, const Limits& limits = {});

}  // namespace blossom
