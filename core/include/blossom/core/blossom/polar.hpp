#pragma once

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>

namespace blossom {

/// The polar of a map: its blossom with the first k_f arguments of each factor fixed, as a map of degree n_f
/// - k_f in what remains. One step of de Casteljau's algorithm per argument, which may be a point, a vector
/// or any homogeneous argument.
///
/// Cost: at most C(n + s, s + 1) combinations of points per factor. Errors: `wrong_arity` at `Part::arguments
/// / f` for more arguments than the degree; `mismatched_dimensions`; `limit_exceeded`. Source: DeRose,
/// sections 3 and 5. Statement: derose-adt-blossom.
template <PatchRepresentation Map>
Map polar(const Map& patch, const PatchArguments& arguments, const Limits& limits = {});

/// The map with one argument of one factor, as a map on the product of the other factors: an isoparametric
/// curve or surface. Cost and errors: those of `polar`; `wrong_arity` if there is no other factor.
template <PatchRepresentation Map>
Map isoparametric(const Map& patch, std::size_t factor, const Coordinates& argument,
                  const Limits& limits = {});

/// The map at arguments that are polynomial maps themselves: a composition. The coordinates of `arguments`
/// are those of the argument of each factor of `outer` one after the other, s_f + 1 of them, in which `outer`
/// is homogeneous. The degree in each factor of the domain is that of `arguments` times the sum of the
/// degrees of `outer`.
///
/// De Casteljau's algorithm on `outer` in the ring of polynomials. Cost: C(n_f + s_f, s_f + 1) products by
/// the polynomials of an argument per factor f. Errors: `mismatched_dimensions` for another number of
/// coordinates; `limit_exceeded`. Source: DeRose, Composing Bezier simplexes (1988).
template <PatchRepresentation Outer, PatchRepresentation Inner>
Inner composed(const Outer& outer, const Inner& arguments, const Limits& limits = {});

/// The map on the simplex whose vertices are points of the domain, one argument per factor each: on an edge,
/// a diagonal, any segment or triangle. Its degree is the sum of the degrees in the factors in which the
/// vertices differ. The vertices may be dependent.
///
/// The composition with an affine map: control points are means of blossom values at the vertices. Cost and
/// errors: those of `composed`; `wrong_arity` for no vertex.
template <PatchRepresentation Map>
BezierPatch restricted(const Map& patch, std::span<const PatchPoint> vertices, const Limits& limits = {});

}  // namespace blossom
