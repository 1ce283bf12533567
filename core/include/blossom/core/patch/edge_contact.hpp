#pragma once

#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

// Surfaces whose domains are triangles or boxes of the plane, in pieces that are polynomial, and the contact
// of two of them along a segment, which may be a part of an edge of each.

/// A segment of the plane of parameters, run through by begin + t (end - begin) from t = 0 to 1.
struct PlaneSegment {
    Coordinates begin;
    Coordinates end;

    Coordinates at(const Rational& t) const;
};

/// The edges of a triangle or box in order around it. Errors: `mismatched_dimensions` for another domain.
std::vector<PlaneSegment> edges_of(const PlacedPatch& patch);

/// What belongs together along a common edge of two pieces: a triangle over the domain of each, whose first
/// two vertices are the ends of the segment. The affine map of one triangle to the other says how the domains
/// are glued.
struct Joint {
    std::size_t left_piece;
    std::size_t right_piece;
    std::vector<Coordinates> left;
    std::vector<Coordinates> right;

    PlaneSegment left_segment() const { return {left[0], left[1]}; }
    PlaneSegment right_segment() const { return {right[0], right[1]}; }
};

/// The joints of pieces of two surfaces over one plane: wherever an edge of one and an edge of the other have
/// more than a point in common. The triangles of both are the same. Cost: one pass over the pairs of edges.
std::vector<Joint> joints(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right);

/// A segment on the boundary of the domain, and perhaps a point off it.
struct NamedEdge {
    PlaneSegment segment;
    std::optional<Coordinates> off;
};

/// The joints of two surfaces over domains of their own, along segments that correspond to each other. The
/// domains are glued by the affine map of one triangle of points to the other; where no points off the
/// segments are given, the right domain lies behind the segment as far as the left one lies before it: a box
/// by the unit vector across its side, a triangle by that from the first point to its opposite vertex.
///
/// Errors: `not_adjacent` at `Part::left` or `Part::right` unless edges of pieces make up the whole segment;
/// `degenerate_simplex` for a segment without length or a point on it, likewise.
std::vector<Joint> joints(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                          const NamedEdge& left_edge, const NamedEdge& right_edge);

/// The joints where boundary curves are the same up to an affine change of their parameters, in each pair of
/// pieces; glued as above. Curves that are one point have none. Homogeneous points are compared as they
/// stand. Cost: one comparison of polynomials per pair of edges, and rational roots of one number.
std::vector<Joint> matching_joints(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                                   const Limits& limits = {});

/// The control net of the polynomial over a triangle of the plane, of the sum of its degrees.
/// Errors: `degenerate_simplex`, `limit_exceeded`.
BezierPatch over_triangle(const PlacedPatch& patch, const std::vector<Coordinates>& vertices,
                          const Limits& limits = {});

/// The contact of two pieces at a joint, see `contact` and `projected_contact`, as that of the nets over its
/// triangles. The points of the first difference are those of the left domain.
PatchContact joint_contact(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                           const Joint& joint, bool projected, const Limits& limits = {});

}  // namespace blossom
