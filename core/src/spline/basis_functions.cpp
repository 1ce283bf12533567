#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

#include "progressive_frame.hpp"

namespace blossom {

namespace {

/// n + 1 unit points in dimension 1: all 0 but one.
std::vector<Coordinates> unit_points(std::size_t n, std::size_t one) {
    std::vector<Coordinates> points(n + 1, Coordinates(1));
    points[one].front() = 1;
    return points;
}

/// The n + 1 unit vectors of Q^(n + 1).
std::vector<Coordinates> identity(std::size_t n) {
    std::vector<Coordinates> points(n + 1, Coordinates(n + 1));
    for (std::size_t i = 0; i <= n; ++i) points[i][i] = 1;
    return points;
}

}  // namespace

std::vector<PolynomialPiece> basis_function(const KnotVector& knots, std::size_t point,
                                            const Limits& limits) {
    if (point >= knots.points()) {
        throw Error(ErrorCode::wrong_arity, "there is no control point " + std::to_string(point) +
                                                "; their number is " + std::to_string(knots.points()));
    }
    const std::size_t n = knots.degree();
    const std::size_t first = knots.begin_index() + point - std::min(point, n);
    const std::size_t last = std::min(knots.begin_index() + point, knots.end_index() - 1);
    std::vector<PolynomialPiece> pieces;
    for (std::size_t span = first; span <= last; ++span) {
        if (knots[span] == knots[span + 1]) continue;
        const Interval interval(knots[span], knots[span + 1]);
        const ProgressiveFrame frame(knots.around(span), unit_points(n, point - knots.first_point(span)),
                                     limits);
        pieces.push_back(
            {span, interval, monomial_form(BezierCurve(frame.control_points(), interval), limits).coordinate(0)});
    }
    return pieces;
}

BasisValues basis_values(const KnotVector& knots, const Rational& t, const Limits& limits) {
    const std::size_t n = knots.degree();
    const std::size_t span = knots.span_at(t);
    const ProgressiveFrame frame(knots.around(span), identity(n), limits);
    return {knots.first_point(span), frame.value(with_copies({}, n, Parameter(t)))};
}

}  // namespace blossom
