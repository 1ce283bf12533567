#pragma once

#include <blossom/core/queries/curve_pieces.hpp>

#include <optional>
#include <vector>

namespace blossom {

/// A common point of two plane curves, by a parameter of each; the piece of each curve that has it.
struct CurveIntersection {
    Root first;
    Root second;
    std::size_t first_piece = 0;
    std::size_t second_piece = 0;
    /// The order of contact plus 1: 1 where the tangents differ, 2 where they are the same and the curvatures
    /// differ. 0 where the velocity of one of the curves is 0, and for parts of one curve of which one goes
    /// on where the other ends, or which have another contact of an order above 2.
    std::size_t multiplicity = 1;
};

/// A range of a parameter with ends that need not be rational; it is unbounded where there is none.
struct AlgebraicRange {
    std::optional<Root> lower;
    std::optional<Root> upper;
};

/// A common part of two curves: the points of the one range are those of the other, in the same or in the
/// reversed direction. The range of a curve that is a single point there is all of the range in which it is;
/// that of the other curve then has equal ends.
struct CurveOverlap {
    AlgebraicRange first;
    AlgebraicRange second;
    bool is_reversed = false;
};

struct CurveIntersections {
    std::vector<CurveIntersection> points;  ///< in rising order of the first parameter, then of the second
    std::vector<CurveOverlap> overlaps;     ///< likewise; their ends are no points
};

/// The common points of two plane curves, each once; a parameter where pieces meet belongs to the piece on
/// its right.
///
/// For curves x / w and u / z, the common points are the solutions of x(s) z(t) = u(t) w(s), y(s) z(t) = v(t)
/// w(s). The resultants of the two equations in t and in s isolate the parameters of all of them. Pairs of
/// parameters are excluded by bounds on both coordinates; for those that remain, equality of both coordinates
/// as algebraic numbers is decided. Where a resultant is zero, both curves lie on the same irreducible curve:
/// then the ranges are cut at all parameters of the ends, stops and double points of both, and for one
/// parameter between two cuts the parameters of the same point are found.
///
/// Cost: for pieces of degrees m and n, resultants of degree 2 m n, and for each factor of one another
/// resultant of this degree. Errors: `mismatched_dimensions` unless the curves are plane; `limit_exceeded`.
CurveIntersections intersections(std::span<const CurvePiece> first, std::span<const CurvePiece> second,
                                 const Rational& width = 0, const Limits& limits = {});

/// Where a plane curve passes a point more than once, with `first` < `second`: double points and parts that
/// are passed several times.
CurveIntersections self_intersections(std::span<const CurvePiece> curve, const Rational& width = 0,
                                      const Limits& limits = {});

/// Where the velocity of a curve is 0 and its direction is reversed, in the rising order of parameters.
std::vector<Root> cusps(std::span<const CurvePiece> curve, const Rational& width = 0,
                        const Limits& limits = {});

}  // namespace blossom
