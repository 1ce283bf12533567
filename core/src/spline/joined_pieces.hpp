#pragma once

// Curves in pieces that are to be one spline.

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// A polynomial over an increasing interval, and which of the curves it is part of.
struct JoinedPiece {
    BezierCurve curve;
    std::size_t map = 0;
};

/// The pieces of all curves, each of which begins where the last ended.
/// Errors: `wrong_arity` for none; `not_adjacent`, `mismatched_dimensions`, below `Part::maps / i`.
std::vector<JoinedPiece> adjacent_pieces(std::span<const std::vector<BezierCurve>> maps);

/// `join` of the pieces.
BSplineCurve joined(std::vector<JoinedPiece> pieces, const Limits& limits);

/// Why two pieces do not meet with a higher order at s than that of their contact, as a sentence.
using Reason = std::function<std::string(const BezierCurve& left, const BezierCurve& right, const Rational& s,
                                         const Contact& contact)>;

/// That of the first row of curves side by side, see `join_rows`.
Reason reason_of_rows(std::size_t rows);

/// `join` of the pieces over given knots.
BSplineCurve joined(std::vector<JoinedPiece> pieces, const KnotVector& knots, const Reason& reason,
                    const Limits& limits);

}  // namespace blossom
