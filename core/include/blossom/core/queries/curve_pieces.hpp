#pragma once

#include <blossom/core/curve/algebraic_number.hpp>
#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/core/spline/spline_roots.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// A polynomial or rational curve in a range of its parameter, by its homogeneous coordinates (w x_1, ..., w
/// x_d, w). They have no common factor, so that the weight is 0 exactly where the curve is at infinity; the
/// weight of a polynomial curve is 1.
struct CurvePiece {
    std::vector<Polynomial> coordinates;
    ParameterRange range;
    /// Whether the upper end of the range belongs to this piece, not to the next one.
    bool closed = true;

    std::size_t dimension() const { return coordinates.size() - 1; }
    const Polynomial& weight() const { return coordinates.back(); }
};

/// A curve as one piece, and a spline as its segments in the part of the range that belongs to its domain.
/// `rational` says that the last coordinate is a weight. Cost: gcds of polynomials. Errors: `zero_weight` if
/// the weight is the zero polynomial; `limit_exceeded`.
std::vector<CurvePiece> curve_pieces(const PolynomialMap& map, bool rational, const ParameterRange& range,
                                     const Limits& limits = {});
std::vector<CurvePiece> curve_pieces(const BSplineCurve& curve, bool rational, const ParameterRange& range,
                                     const Limits& limits = {});

/// The polynomial divided by all factors that it shares with another one, as often as they divide it; 0 for
/// 0.
Polynomial without_factors_of(Polynomial polynomial, const Polynomial& other);

/// The numerators of the derivatives of the coordinates: x_i' w - x_i w', which are over w^2.
std::vector<Polynomial> velocity(const CurvePiece& piece);

/// The sign of a polynomial, which is not zero, directly behind t if `side` > 0, and directly before t if
/// `side` < 0.
int sign_beside(Polynomial polynomial, const Rational& t, int side);

/// The coordinates of the curve at a number where the weight is not 0.
class PointsOnCurve {
public:
    PointsOnCurve(const CurvePiece& piece, const Limits& limits);

    std::vector<Root> at(const Root& root);
    AlgebraicValues& coordinate(std::size_t j) { return coordinates_[j]; }

private:
    std::vector<AlgebraicValues> coordinates_;
};

}  // namespace blossom
