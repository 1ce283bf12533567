#pragma once

#include <blossom/core/queries/curve_pieces.hpp>

namespace blossom {

/// What happens where the curvature of a plane curve has a zero.
enum class InflectionKind {
    inflection,  ///< the curvature changes its sign
    flat,        ///< it does not
    cusp,        ///< the velocity is 0, and the direction of the tangent is reversed
    singular,    ///< the velocity is 0, and the direction is not reversed
};

struct Inflection {
    Root at;
    /// The multiplicity of the zero of det(F, F', F'') in the homogeneous coordinates F on the segment at its
    /// right; 0 where this determinant jumps between signs.
    std::size_t multiplicity = 1;
    InflectionKind kind = InflectionKind::inflection;
};

struct Inflections {
    std::vector<Inflection> points;        ///< in rising order
    std::vector<ParameterRange> straight;  ///< where the curve lies on a line, in rising order
};

/// The zeros of the curvature of a plane curve, which is det(F, F', F'') / w^3 times a positive number: the
/// roots of this determinant in each piece. At a knot with one tangent, the curvatures on both sides are
/// compared; where the tangents differ there is no inflection. At the ends of the curve the polynomials are
/// continued.
///
/// Cost: products of polynomials, and `roots` of degree 3 (n - 2) a piece, 2 (n - 2) or less if it is
/// polynomial. Errors: `mismatched_dimensions` unless the curve is plane; `limit_exceeded`.
Inflections inflections(std::span<const CurvePiece> pieces, const Rational& width = 0,
                        const Limits& limits = {});

}  // namespace blossom
