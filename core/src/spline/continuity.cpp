#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "maps/bracketed.hpp"

namespace blossom {

Contact contact(const PolynomialMap& left, const PolynomialMap& right, const Rational& s,
                const Limits& limits) {
    if (dimension_of(left) != dimension_of(right)) {
        throw Error(ErrorCode::mismatched_dimensions, "curves in " + std::to_string(dimension_of(left)) +
                                                          " and in " + std::to_string(dimension_of(right)) +
                                                          " dimensions have no contact");
    }
    const std::size_t n = std::max(degree_of(left), degree_of(right));
    // The values at (s^(n-k), (s + 1)^k) are the control points over [s, s + 1].
    const auto polygon = [&](const PolynomialMap& map) {
        return elevate(control_points(map, {s, s + 1}, limits), n - degree_of(map), limits).control_points();
    };
    const PointArray f = polygon(left);
    const PointArray g = polygon(right);
    for (std::size_t k = 0; k <= n; ++k) {
        if (f[k] == g[k]) continue;
        std::vector<Argument> arguments =
            with_copies(with_copies({}, n - k, Parameter(s)), k, Parameter(s + 1));
        return {static_cast<std::ptrdiff_t>(k) - 1, BlossomDifference{std::move(arguments), f[k], g[k]}};
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
