#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// The control net over another frame of one factor, whose element k is the argument elements[k]: point i is
/// the blossom value with i_k copies of elements[k]. Elements may be points, vectors or any homogeneous
/// arguments.
///
/// Elements are exchanged one at a time, as in Gaussian elimination, each by one pyramid of de Casteljau's
/// algorithm. Cost: C(n + s, s + 1) combinations of points for each element that differs from the old one.
/// Errors: `degenerate_simplex`, naming elements that are linearly dependent; `wrong_arity`,
/// `mismatched_dimensions`, with places below `Part::elements`; `limit_exceeded`. Source: DeRose, section 5.
/// Statements: derose-tri-points, derose-tensor-allresults.
BezierPatch with_frame(const BezierPatch& patch, std::size_t factor, std::span<const Coordinates> elements,
                       const Limits& limits = {});

/// The patches into which a point of one factor divides its simplex, one for each of `replaced_vertices`,
/// which the point replaces there: s + 1 for a point inside, 2 for one on an edge. For a segment they are
/// over [t, b] and [a, t].
///
/// One pyramid gives all of them. Cost: C(n + s, s + 1) combinations of points. Errors: `not_affine` unless
/// the sum of the coordinates of the point is 1; `degenerate_simplex` for a vertex;
/// `mismatched_dimensions`, `limit_exceeded`. Source: DeRose, section 5.2.
/// Statement: derose-tri-subdiv.
std::vector<BezierPatch> subdivide(const BezierPatch& patch, std::size_t factor, const Coordinates& point,
                                   const Limits& limits = {});

/// The vertices with which a point does not span a face of the simplex: those whose barycentric coordinates
/// are not 0.
std::vector<std::size_t> replaced_vertices(const Coordinates& point);

/// The 2^s patches into which the midpoints of the edges divide the simplex of one factor: for a triangle,
/// the three at the corners and the one between the midpoints.
///
/// `elements[k]` of a piece are the barycentric coordinates of its vertex k. Cost: that of `with_frame` per
/// piece. Errors: `limit_exceeded`. Source: Edelsbrunner and Grayson, Edgewise subdivision of a simplex
/// (2000).
struct MidpointPiece {
    BezierPatch patch;
    std::vector<Coordinates> elements;
};
std::vector<MidpointPiece> subdivide_at_midpoints(const BezierPatch& patch, std::size_t factor,
                                                  const Limits& limits = {});

/// The vertices of these pieces of a simplex of dimension s, in barycentric coordinates.
std::vector<std::vector<Coordinates>> midpoint_simplices(std::size_t dimension);

}  // namespace blossom
