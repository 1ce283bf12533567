#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/curve/roots.hpp>
#include <blossom/core/patch/edge_contact.hpp>
#include <blossom/rational/limits.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// How the tangent planes of two surfaces lie along a joint. The vectors are the derivative X of the left
/// surface across the edge into its domain, the derivative Y of the right one into its own, and the
/// derivative Z along the edge, each a polynomial in t, which runs from 0 to 1 along the joint.
///
/// They are in one plane for all t if and only if alpha X + beta Y + gamma Z = 0 for polynomials that are not
/// all 0. Of homogeneous points a multiple delta of the point itself is added.
struct TangentContact {
    enum class Kind {
        apart,     ///< the surfaces do not meet along the edge
        bent,      ///< the three vectors are independent at a parameter
        singular,  ///< alpha or beta vanishes: there one of the surfaces has no tangent plane of its own
        folded,    ///< one tangent plane, but both surfaces are on the same side of the edge
        smooth,    ///< geometric contact of order 1
    };

    Kind kind;
    /// alpha, beta, gamma and, of homogeneous points, delta, without common factors.
    std::vector<Polynomial> functions;
    /// Where the vectors are independent, with X, Y and Z there.
    std::optional<Rational> parameter;
    std::array<Coordinates, 3> vectors;
    /// Where alpha or beta vanishes; empty where that is everywhere.
    std::vector<Root> singular;
};

/// The tangent planes of two pieces at a joint. The directions across the edge are those of `across`.
///
/// The functions are found by elimination over the polynomials: they are minors of the matrix of the three
/// vectors, divided by their greatest common divisor, and the sum has to vanish in every coordinate. The sign
/// of alpha beta, which is decided exactly, says on which sides of the edge the surfaces are.
///
/// Cost: minors of at most three rows for each choice of rows until one is not 0, and gcds. Errors:
/// `mismatched_dimensions` for points of one coordinate, besides the weight; `limit_exceeded`.
/// Source: DeRose, "Necessary and sufficient conditions for tangent plane continuity of Bezier surfaces",
/// 1990.
TangentContact tangent_contact(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                               const Joint& joint, bool projected, const Limits& limits = {});

/// The vectors into the two domains along which `tangent_contact` takes the derivatives.
std::array<Coordinates, 2> across(std::span<const PlacedPatch> left, std::span<const PlacedPatch> right,
                                  const Joint& joint);

}  // namespace blossom
