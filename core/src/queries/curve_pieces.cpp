#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/queries/curve_pieces.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

namespace blossom {

namespace {

CurvePiece curve_piece(const PolynomialMap& map, bool rational, ParameterRange range, bool closed,
                       const Limits& limits) {
    std::vector<Polynomial> coordinates = coordinates_of(monomial_form(map, limits));
    if (!rational) {
        coordinates.emplace_back(1);
        return {std::move(coordinates), std::move(range), closed};
    }
    if (coordinates.back().is_zero())
        throw Error(ErrorCode::zero_weight, "the weight is 0 everywhere", Part::map);
    Polynomial common = coordinates.back();
    for (const Polynomial& coordinate : coordinates) common = gcd(common, coordinate);
    if (common.degree() > 0) {
        for (Polynomial& coordinate : coordinates) coordinate = divide_exactly(coordinate, common);
    }
    return {std::move(coordinates), std::move(range), closed};
}

}  // namespace

std::vector<CurvePiece> curve_pieces(const PolynomialMap& map, bool rational, const ParameterRange& range,
                                     const Limits& limits) {
    return {curve_piece(map, rational, range, true, limits)};
}

std::vector<CurvePiece> curve_pieces(const BSplineCurve& curve, bool rational, const ParameterRange& range,
                                     const Limits& limits) {
    std::vector<CurvePiece> pieces;
    for_each_segment(curve, range, limits,
                     [&](const BezierCurve& segment, const ParameterRange& part, bool closed) {
                         pieces.push_back(curve_piece(segment, rational, part, closed, limits));
                     });
    return pieces;
}

Polynomial without_factors_of(Polynomial polynomial, const Polynomial& other) {
    if (polynomial.is_zero()) return polynomial;
    for (Polynomial common = gcd(polynomial, other); common.degree() > 0; common = gcd(polynomial, common))
        polynomial = divide_exactly(polynomial, common);
    return polynomial;
}

std::vector<Polynomial> velocity(const CurvePiece& piece) {
    const Polynomial slope_of_weight = derivative(piece.weight());
    std::vector<Polynomial> velocity;
    for (std::size_t j = 0; j < piece.dimension(); ++j) {
        const Polynomial& coordinate = piece.coordinates[j];
        velocity.push_back(derivative(coordinate) * piece.weight() - coordinate * slope_of_weight);
    }
    return velocity;
}

int sign_beside(Polynomial polynomial, const Rational& t, int side) {
    int odd = 1;
    while (true) {
        if (const int sign = polynomial(t).sign(); sign != 0) return sign * odd;
        polynomial = derivative(polynomial);
        odd *= side;
    }
}

PointsOnCurve::PointsOnCurve(const CurvePiece& piece, const Limits& limits) {
    for (std::size_t j = 0; j < piece.dimension(); ++j)
        coordinates_.emplace_back(piece.coordinates[j], piece.weight(), limits);
}

std::vector<Root> PointsOnCurve::at(const Root& root) {
    std::vector<Root> point;
    point.reserve(coordinates_.size());
    for (AlgebraicValues& coordinate : coordinates_) point.push_back(coordinate.at(root));
    return point;
}

}  // namespace blossom
