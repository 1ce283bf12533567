#pragma once

#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>

#include <variant>
#include <vector>

namespace blossom {

/// A polynomial map on a product of simplices or of affine spaces. Arguments of the first are tuples (mass,
/// x_1, ..., x_s), of the second barycentric.
using PatchMap = std::variant<PolynomialPatch, BezierPatch>;

/// The blossom by one named construction, each from its own source: symmetric functions of points from
/// monomial coefficients, the inverse formula from values of the map alone, de Casteljau from a control net.
/// For a polynomial that net is over the origin and the ends of the unit vectors; for a control net the
/// monomials are those in the differences from its first vertex.
///
/// Cost: C(n + s, s + 1) multiply-adds a factor, for polarization prod (m_i + 1) values. Errors: those of
/// `require_arguments`; `limit_exceeded`. Source: DeRose, theorem 3; Fernandez-Jambrina, equation (21).
/// Statements: derose-thm3, fj-eq21, fj-tri-blossom.
Coordinates blossom_value(const PatchMap& map, const PatchArguments& arguments, Construction construction,
                          const Limits& limits = {});

/// The three values at the given arguments. Polarization is skipped, with the reason, beyond its limit.
Agreement<Coordinates> agreement(const PatchMap& map, const PatchArguments& arguments,
                                 const Limits& limits = {});

/// Symbolic points of all factors, whose variables are numbered argument by argument in each factor: s of
/// them make up (1, x_1, ..., x_s) for a polynomial and (1 - x_1 - ... - x_s, x_1, ..., x_s) for a net.
///
/// The three constructions run on them; when they agree, they agree for all arguments. Cost: prod (s + 1)^n
/// terms. Errors: `limit_exceeded` when that exceeds `expansion_terms`. Statements: derose-thm3, fj-eq21.
Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PatchMap& map,
                                                                     const Limits& limits = {});

}  // namespace blossom
