#pragma once

#include <blossom/core/queries/curve_pieces.hpp>

namespace blossom {

/// Where a curve lies on the hyperplane a_1 x_1 + ... + a_d x_d + c = 0, a line in the plane, given by (a_1,
/// ..., a_d, c): the roots of this functional along the curve, with their multiplicities, and the ranges in
/// which it is 0 everywhere. Points at infinity do not count.
///
/// Cost: `roots` a piece. Errors: `mismatched_dimensions` unless there are d + 1 numbers; `limit_exceeded`.
SplineRoots cuts(std::span<const CurvePiece> pieces, std::span<const Rational> hyperplane,
                 const Rational& width = 0, const Limits& limits = {});

/// The common roots of several scalar curves in the part of their ranges that they share: the roots of the
/// greatest common divisor of their numerators, and the ranges in which all of them are 0. The multiplicity
/// is the least one. Each curve is a list of pieces of dimension 1 in rising order.
/// Cost: `roots` a part. Errors: `limit_exceeded`.
SplineRoots common_roots(std::span<const std::vector<CurvePiece>> curves, const Rational& width = 0,
                         const Limits& limits = {});

}  // namespace blossom
