#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "maps/bracketed.hpp"

namespace blossom {

namespace {

std::size_t formal_degree(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.degree(); }, map);
}

std::size_t dimension_of(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.dimension(); }, map);
}

Blossom blossom_of_degree(const PolynomialMap& map, std::size_t n, const Limits& limits) {
    return std::visit(
        [&](const auto& curve) { return Blossom(elevate(curve, n - curve.degree(), limits), limits); }, map);
}

}  // namespace

Contact contact(const PolynomialMap& left, const PolynomialMap& right, const Rational& s,
                const Limits& limits) {
    if (dimension_of(left) != dimension_of(right)) {
        throw Error(ErrorCode::mismatched_dimensions, "curves in " + std::to_string(dimension_of(left)) +
                                                          " and in " + std::to_string(dimension_of(right)) +
                                                          " dimensions have no contact");
    }
    const std::size_t n = std::max(formal_degree(left), formal_degree(right));
    const Blossom f = blossom_of_degree(left, n, limits);
    const Blossom g = blossom_of_degree(right, n, limits);
    const Parameter at = s;
    for (std::size_t k = 0; k <= n; ++k) {
        std::vector<Argument> arguments = with_copies(with_copies({}, n - k, at), k, at + delta);
        Coordinates of_left = f(arguments);
        Coordinates of_right = g(arguments);
        if (of_left == of_right) continue;
        return {static_cast<std::ptrdiff_t>(k) - 1,
                BlossomDifference{std::move(arguments), std::move(of_left), std::move(of_right)}};
    }
    return {};
}

std::pair<std::size_t, std::size_t> sides(const KnotVector& knots, const Rational& s) {
    const Interval domain = knots.domain();
    if (s <= domain.a() || domain.b() <= s) {
        throw Error(ErrorCode::outside_domain,
                    "the curve has no two sides at " + to_string(s) + ", which is not inside its domain [" +
                        to_string(domain.a()) + ", " + to_string(domain.b()) + "]",
                    Part::at);
    }
    return {knots.span_before(s), knots.span_at(s)};
}

Contact contact(const BSplineCurve& curve, const Rational& s, const Limits& limits) {
    const auto [before, behind] = sides(curve.knots(), s);
    if (before == behind) return {};
    return contact(sablonniere(curve, before, limits), sablonniere(curve, behind, limits), s, limits);
}

std::string osculating_name(std::size_t order) {
    switch (order) {
        case 0:
            return "the point";
        case 1:
            return "the tangent";
        case 2:
            return "the osculating parabola";
        default:
            return "the osculating curve of degree " + std::to_string(order);
    }
}

std::string contact_text(std::ptrdiff_t order, const Rational& s) {
    if (order < 0) return "The curves do not meet at " + to_string(s);
    const auto shared = static_cast<std::size_t>(order);
    return "The curves meet with order " + std::to_string(order) + " at " + to_string(s) + ", sharing " +
           osculating_name(shared) + " but not " + osculating_name(shared + 1);
}

std::string to_string(const Contact& contact, const Rational& s) {
    if (contact.is_infinite()) return "The curves are the same polynomial at " + to_string(s);
    const BlossomDifference& difference = *contact.first_difference;
    return contact_text(*contact.order, s) + ": the blossom values at (" +
           listed(difference.arguments, [](const Argument& x) { return to_string(x.u); }) + ") are " +
           bracketed(difference.left) + " and " + bracketed(difference.right);
}

}  // namespace blossom
