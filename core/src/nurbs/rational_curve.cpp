#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace blossom {

namespace {

void require_weight(const Rational& weight) {
    if (weight.is_zero()) {
        throw Error(ErrorCode::zero_weight,
                    "a point of weight 0 lies at infinity and has no Euclidean coordinates");
    }
}

/// Requires that the degree n (k + 1) is within the limits.
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

Coordinates quotient_rule(std::span<const std::size_t> orders,
                          const std::function<Coordinates(std::span<const std::size_t>)>& derivative) {
    // The position of m - k is that of m minus that of k.
    std::vector<std::vector<std::size_t>> indices{{}};
    for (const std::size_t order : orders) {
        std::vector<std::vector<std::size_t>> longer;
        for (const auto& index : indices) {
            for (std::size_t k = 0; k <= order; ++k) {
                longer.push_back(index);
                longer.back().push_back(k);
            }
        }
        indices = std::move(longer);
    }
    Coordinates weights;
    std::vector<Coordinates> derivatives;
    for (std::size_t m = 0; m < indices.size(); ++m) {
        Coordinates value = derivative(indices[m]);
        weights.push_back(value.back());
        require_weight(weights.front());
        value.pop_back();
        for (std::size_t k = 1; k <= m; ++k) {
            if (!std::ranges::equal(indices[k], indices[m], std::less_equal())) continue;
            Rational factor = weights[k];
            for (std::size_t i = 0; i < orders.size(); ++i) factor *= binomial(indices[m][i], indices[k][i]);
            for (std::size_t j = 0; j < value.size(); ++j) value[j] -= factor * derivatives[m - k][j];
        }
        for (Rational& coordinate : value) coordinate /= weights.front();
        derivatives.push_back(std::move(value));
    }
    return std::move(derivatives.back());
}

Coordinates rational_derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                                const Limits& limits) {
    return quotient_rule(std::span(&order, 1),
                         [&](std::span<const std::size_t> k) { return derivative(map, k[0], t, limits); });
}

PolynomialMap rational_derivative_map(const PolynomialMap& map, std::size_t order, const Limits& limits) {
    if (order == 0) return map;
    const PolynomialCurve curve = monomial_form(map, limits);
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
    const std::vector<Polynomial> a = coordinates_of(monomial_form(left, limits));
    const std::vector<Polynomial> b = coordinates_of(monomial_form(right, limits));
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
