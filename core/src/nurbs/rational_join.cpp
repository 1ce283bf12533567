#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/nurbs/rational_join.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <algorithm>
#include <optional>

#include "maps/bracketed.hpp"
#include "scaled_contact.hpp"
#include "spline/joined_pieces.hpp"

namespace blossom {

namespace {

/// The curve without the factors that all its coordinates share.
BezierCurve in_lowest_terms(const BezierCurve& curve, const Limits& limits) {
    std::vector<Polynomial> coordinates = coordinates_of(monomial_form(curve, limits));
    Polynomial common = coordinates.back();
    for (const Polynomial& coordinate : coordinates) {
        if (!common.is_zero() && common.degree() == 0) return curve;
        common = gcd(common, coordinate);
    }
    if (common.degree() == 0) return curve;
    for (Polynomial& coordinate : coordinates) coordinate = divide_exactly(coordinate, common);
    const PolynomialCurve divided(coordinates, curve.degree() - common.degree());
    return control_points(divided, curve.interval(), limits);
}

/// Divides the common factors out of neighbours that are one rational curve only without them.
void unite_representations(std::vector<JoinedPiece>& pieces, const Limits& limits) {
    std::vector<BezierCurve> lowest;
    lowest.reserve(pieces.size());
    for (const JoinedPiece& piece : pieces) lowest.push_back(in_lowest_terms(piece.curve, limits));
    std::size_t begin = 0;
    bool differ = false;
    for (std::size_t i = 1; i <= pieces.size(); ++i) {
        const bool one_curve =
            i < pieces.size() && scaled_contact(lowest[i - 1], lowest[i], limits).is_infinite;
        if (one_curve) {
            differ = differ || !scaled_contact(pieces[i - 1].curve, pieces[i].curve, limits).is_infinite;
            continue;
        }
        for (std::size_t k = begin; differ && k < i; ++k) pieces[k].curve = lowest[k];
        begin = i;
        differ = false;
    }
}

/// Multiplies each piece by the number with which it meets the one before best.
void scale_to_neighbours(std::vector<JoinedPiece>& pieces, const Limits& limits) {
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const auto factor = scaled_contact(pieces[i - 1].curve, pieces[i].curve, limits).factor;
        if (factor && *factor != Rational(1)) pieces[i].curve = scaled(pieces[i].curve, *factor);
    }
}

std::vector<JoinedPiece> pieces_in_one_representation(std::span<const std::vector<BezierCurve>> maps,
                                                      const Limits& limits) {
    std::vector<JoinedPiece> pieces = adjacent_pieces(maps);
    const std::size_t n = std::ranges::max_element(pieces, {}, [](const JoinedPiece& piece) {
                              return piece.curve.degree();
                          })->curve.degree();
    unite_representations(pieces, limits);
    // Division may have lowered every degree.
    pieces.front().curve = elevate(pieces.front().curve, n - pieces.front().curve.degree(), limits);
    scale_to_neighbours(pieces, limits);
    return pieces;
}

std::string reason_of_rational_curves(const BezierCurve& left, const BezierCurve& right, const Rational& s,
                                      const Contact& contact) {
    const ProjectedContact projected = projected_contact(left, right, s);
    if (projected.order && *projected.order > *contact.order) {
        const BlossomDifference& difference = *contact.first_difference;
        return contact_text(*projected.order, s) +
               ", but their homogeneous points, multiplied by any number, only with order " +
               std::to_string(*contact.order) + ": the blossom values at (" +
               listed(difference.arguments, [](const Argument& x) { return to_string(x.u); }) + ") are " +
               bracketed(difference.left) + " and " + bracketed(difference.right);
    }
    const auto& [from_left, from_right] = *projected.first_difference;
    return contact_text(*projected.order, s) + ": the derivatives of order " +
           std::to_string(*projected.order + 1) + " are " + bracketed(from_left) + " and " +
           bracketed(from_right);
}

}  // namespace

BSplineCurve rational_join(std::span<const std::vector<BezierCurve>> maps, const Limits& limits) {
    return joined(pieces_in_one_representation(maps, limits), limits);
}

BSplineCurve rational_join(std::span<const std::vector<BezierCurve>> maps, const KnotVector& knots,
                           const Limits& limits) {
    return joined(pieces_in_one_representation(maps, limits), knots, reason_of_rational_curves, limits);
}

BSplineCurve rational_join_rows(std::span<const std::vector<BezierCurve>> maps, std::size_t rows,
                                const KnotVector& knots, const Limits& limits) {
    return joined(pieces_in_one_representation(maps, limits), knots, reason_of_rows(rows), limits);
}

}  // namespace blossom
