#pragma once

#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace blossom {

/// Whether a scalar map is positive on its domain.
enum class Positivity {
    positive,      ///< everywhere
    not_positive,  ///< it is 0 or negative at a point that is known
    undecided,     ///< neither is known after the last subdivision
};

/// A point of the domain, one point per factor, and the value there.
struct ValueAt {
    std::vector<Coordinates> at;
    Rational value;
};

/// Bounds of a scalar map, and what they say of its sign.
struct NetBounds {
    Positivity positivity = Positivity::undecided;
    /// Of all values on the domain; none where a weight changes its sign or is 0.
    std::optional<Rational> lower, upper;
    std::optional<ValueAt> witness;  ///< of a value that is not positive
    std::size_t nets = 0;            ///< in which the bounds were found
};

/// Bounds of a scalar map by its control points, on pieces that make up its domain. The map is divided by the
/// last coordinate where there are two.
///
/// On each piece the map lies between its least and its greatest control point, and has that of a vertex as
/// its value there. A piece with both positive and other control points, and only positive ones at its
/// vertices, is divided at the midpoints of all its edges, at most `depth` times, until a value that is not
/// positive is found. Cost: that of `with_frame` per piece. Errors: `mismatched_dimensions` for a map that is
/// not scalar; `limit_exceeded` at the midpoints of a simplex of high dimension. Source: Farouki, The
/// Bernstein polynomial basis: a centennial retrospective (2012), section 5; Johnen, Remacle and Geuzaine,
/// Geometrical validity of curvilinear finite elements (2013).
NetBounds net_bounds(std::span<const PlacedPatch> pieces, std::size_t depth, const Limits& limits = {});

}  // namespace blossom
