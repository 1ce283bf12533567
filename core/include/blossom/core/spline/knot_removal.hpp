#pragma once

#include <blossom/core/maps/bspline_curve.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace blossom {

/// Why a knot cannot be removed: n knots would be consecutive without it, but the blossoms of the segments on
/// both sides differ at them, so that no control point can be the value of both.
struct RemovalObstruction {
    std::vector<Rational> knots;
    Coordinates from_left;
    Coordinates from_right;

    /// from_left - from_right, which is not zero.
    Coordinates residual() const;

    friend bool operator==(const RemovalObstruction&, const RemovalObstruction&) = default;
};

struct KnotRemoval {
    BSplineCurve curve;                             ///< the same map as before
    std::size_t removed = 0;                        ///< the number of copies of the knot that were removed
    std::optional<RemovalObstruction> obstruction;  ///< present if fewer were removed than requested
};

/// The same curve with `knot` removed as often as is possible exactly, up to `times`.
///
/// This inverts Boehm's algorithm: its n equations for n - 1 unknown points are solved from the left; the
/// last equation either holds or is the obstruction. It holds if the contact at the knot has one more order
/// (DeRose, theorem 2). Cost: `times` passes over the points, and n combinations per pass. Errors:
/// `bad_knots` if there are fewer than `times` such knots strictly between the two that bound the domain,
/// which cannot be removed without changing the domain. Source: DeRose, section 4.7. Statements:
/// derose-boehm-new, derose-thm2.
KnotRemoval remove_knot(const BSplineCurve& curve, const Rational& knot, std::size_t times = 1);

}  // namespace blossom
