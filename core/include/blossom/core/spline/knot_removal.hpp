#pragma once

#include <blossom/core/maps/bspline_curve.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace blossom {

/// Why a knot cannot go: the blossoms of the segments on both sides differ at n knots that would be
/// consecutive without it, so that no single control point can be their value.
struct RemovalObstruction {
    std::vector<Rational> knots;
    Coordinates from_left;
    Coordinates from_right;

    /// from_left - from_right; not zero.
    Coordinates residual() const;

    friend bool operator==(const RemovalObstruction&, const RemovalObstruction&) = default;
};

struct KnotRemoval {
    BSplineCurve curve;                             ///< the same map as before
    std::size_t removed = 0;                        ///< how many of the knots are gone
    std::optional<RemovalObstruction> obstruction;  ///< if fewer than were asked for
};

/// The same curve with `knot` removed as often as it can be, up to `times`: exactly, or not at all.
///
/// The inverse of Boehm's algorithm: its n equations for n - 1 unknown points are solved from the left up to
/// the last one, which holds or is the obstruction. That is one more order of contact at the knot (DeRose,
/// theorem 2). Cost: `times` passes over the points, and n combinations each. Errors: `bad_knots` if there
/// are fewer than `times` such knots between the two that bound the domain; those cannot be removed without
/// changing it. Source: DeRose, section 4.7. Statements: derose-boehm-new, derose-thm2.
KnotRemoval remove_knot(const BSplineCurve& curve, const Rational& knot, std::size_t times = 1);

}  // namespace blossom
