#include <blossom/core/nurbs/rational_basis.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <utility>

namespace blossom {

namespace {

void require_weights(const KnotVector& knots, std::span<const Rational> weights) {
    if (weights.size() == knots.points()) return;
    throw Error(ErrorCode::wrong_arity, std::to_string(weights.size()) + " weights for " +
                                            std::to_string(knots.points()) + " basis functions");
}

/// The functions on one span times their weights, and the sum of these.
std::vector<RationalPieces> undivided(const KnotVector& knots, std::span<const Rational> weights,
                                      const Limits& limits) {
    std::vector<RationalPieces> spans;
    std::vector<std::size_t> place(knots.size());
    for (const std::size_t span : knots.spans()) {
        place[span] = spans.size();
        spans.push_back({span,
                         {knots[span], knots[span + 1]},
                         knots.first_point(span),
                         std::vector<Polynomial>(knots.degree() + 1),
                         {}});
    }
    for (std::size_t j = 0; j < knots.points(); ++j) {
        for (PolynomialPiece& piece : basis_function(knots, j, limits)) {
            RationalPieces& pieces = spans[place[piece.span]];
            Polynomial& numerator = pieces.numerators[j - pieces.first_point];
            numerator = Polynomial(weights[j]) * piece.polynomial;
            pieces.denominator += numerator;
        }
    }
    return spans;
}

}  // namespace

std::vector<RationalPieces> rational_basis(const KnotVector& knots, std::span<const Rational> weights,
                                           std::size_t order, const Limits& limits) {
    require_weights(knots, weights);
    std::vector<RationalPieces> spans = undivided(knots, weights, limits);
    for (RationalPieces& pieces : spans) {
        if (pieces.denominator.is_zero()) {
            throw Error(ErrorCode::zero_weight, "the sum of the weighted basis functions is 0 between " +
                                                    to_string(pieces.interval.a()) + " and " +
                                                    to_string(pieces.interval.b()));
        }
        if (order == 0) continue;
        pieces.numerators.push_back(std::move(pieces.denominator));
        const PolynomialMap map = PolynomialCurve(pieces.numerators, knots.degree());
        pieces.numerators =
            coordinates_of(std::get<PolynomialCurve>(rational_derivative_map(map, order, limits)));
        pieces.denominator = std::move(pieces.numerators.back());
        pieces.numerators.pop_back();
    }
    return spans;
}

BasisValues rational_basis_derivatives(const KnotVector& knots, std::span<const Rational> weights,
                                       std::size_t order, const Rational& t, const Limits& limits) {
    require_weights(knots, weights);
    const std::size_t first = knots.first_point(knots.span_at(t));
    const auto weighted = [&](std::span<const std::size_t> k) {
        Coordinates values = basis_derivatives(knots, k[0], t, limits).values;
        Rational sum;
        for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] *= weights[first + i];
        values.push_back(std::move(sum));
        return values;
    };
    return {first, quotient_rule(std::span(&order, 1), weighted)};
}

}  // namespace blossom
