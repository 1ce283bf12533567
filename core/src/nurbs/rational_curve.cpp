#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <vector>

#include "blossom/run_construction.hpp"

namespace blossom {

namespace {

void require_weight(const Rational& weight) {
    if (weight.is_zero()) {
        throw Error(ErrorCode::zero_weight,
                    "a point of weight 0 lies at infinity and has no Euclidean coordinates");
    }
}

std::vector<Polynomial> coordinates_of(const PolynomialCurve& curve) {
    std::vector<Polynomial> coordinates;
    coordinates.reserve(curve.dimension());
    for (std::size_t j = 0; j < curve.dimension(); ++j) coordinates.push_back(curve.coordinate(j));
    return coordinates;
}

/// n (k + 1).
std::size_t require_degree(std::size_t n, std::size_t order, const Limits& limits) {
    std::size_t degree = 0;
    if (__builtin_mul_overflow(n, order + 1, &degree)) degree = limits.degree + 1;
    require_within(degree, limits.degree, "degree", "the degree of the derivative", Part::order);
    return degree;
}

}  // namespace

Coordinates projected(const Coordinates& homogeneous) {
    if (homogeneous.size() < 2) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "homogeneous coordinates are at least one coordinate and a weight");
    }
    require_weight(homogeneous.back());
    Coordinates point(homogeneous.begin(), homogeneous.end() - 1);
    for (Rational& coordinate : point) coordinate /= homogeneous.back();
    return point;
}

Coordinates homogeneous_point(const Coordinates& point, const Rational& weight) {
    require_weight(weight);
    Coordinates homogeneous = point;
    for (Rational& coordinate : homogeneous) coordinate *= weight;
    homogeneous.push_back(weight);
    return homogeneous;
}

Coordinates quotient_rule(std::span<const Coordinates> homogeneous_derivatives) {
    if (homogeneous_derivatives.empty()) {
        throw Error(ErrorCode::wrong_arity, "the quotient rule needs the value of the map at least");
    }
    const Rational& weight = homogeneous_derivatives.front().back();
    require_weight(weight);
    std::vector<Coordinates> derivatives;
    for (std::size_t k = 0; k < homogeneous_derivatives.size(); ++k) {
        Coordinates value(homogeneous_derivatives[k].begin(), homogeneous_derivatives[k].end() - 1);
        for (std::size_t i = 1; i <= k; ++i) {
            const Rational factor = Rational(binomial(k, i)) * homogeneous_derivatives[i].back();
            for (std::size_t j = 0; j < value.size(); ++j) value[j] -= factor * derivatives[k - i][j];
        }
        for (Rational& coordinate : value) coordinate /= weight;
        derivatives.push_back(std::move(value));
    }
    return derivatives.back();
}

Coordinates rational_derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                                const Limits& limits) {
    std::vector<Coordinates> derivatives;
    for (std::size_t k = 0; k <= order; ++k) derivatives.push_back(derivative(map, k, t, limits));
    return quotient_rule(derivatives);
}

PolynomialMap rational_derivative_map(const PolynomialMap& map, std::size_t order, const Limits& limits) {
    if (order == 0) return map;
    const PolynomialCurve curve = monomial(map, limits);
    const std::size_t degree = require_degree(curve.degree(), order, limits);
    std::vector<Polynomial> coordinates = coordinates_of(curve);
    const Polynomial weight = coordinates.back();
    coordinates.pop_back();
    if (weight.is_zero()) require_weight(0);
    const Polynomial slope = derivative(weight);
    for (std::size_t k = 0; k < order; ++k) {
        for (Polynomial& numerator : coordinates) {
            numerator = derivative(numerator) * weight - Polynomial(Rational(k + 1)) * numerator * slope;
        }
    }
    coordinates.push_back(pow(weight, order + 1));
    PolynomialCurve derived(coordinates, degree);
    if (const auto* bezier = std::get_if<BezierCurve>(&map)) {
        return control_points(derived, bezier->interval(), limits);
    }
    return derived;
}

ProjectedContact projected_contact(const PolynomialMap& left, const PolynomialMap& right, const Rational& s,
                                   const Limits& limits) {
    const std::vector<Polynomial> a = coordinates_of(monomial(left, limits));
    const std::vector<Polynomial> b = coordinates_of(monomial(right, limits));
    if (a.size() != b.size() || a.size() < 2) {
        throw Error(ErrorCode::mismatched_dimensions, "rational curves of " + std::to_string(a.size()) +
                                                          " and " + std::to_string(b.size()) +
                                                          " homogeneous coordinates have no contact");
    }
    require_weight(a.back()(s));
    require_weight(b.back()(s));
    std::vector<Polynomial> from_left;
    std::vector<Polynomial> from_right;
    for (std::size_t j = 0; j + 1 < a.size(); ++j) {
        from_left.push_back(a[j] * b.back());
        from_right.push_back(b[j] * a.back());
    }
    const auto order = contact(PolynomialCurve(from_left), PolynomialCurve(from_right), s, limits).order;
    if (!order) return {};
    const auto differing = static_cast<std::size_t>(*order + 1);
    return {order, std::pair(rational_derivative(left, differing, s, limits),
                             rational_derivative(right, differing, s, limits))};
}

}  // namespace blossom
