#include "scaled_contact.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_elevation.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace blossom {

namespace {

bool is_zero(const Coordinates& point) {
    return std::ranges::all_of(point, [](const Rational& coordinate) { return coordinate.is_zero(); });
}

/// The number by which `right` must be multiplied to be `left`, if there is one other than 0.
std::optional<Rational> quotient(const Coordinates& left, const Coordinates& right) {
    const auto leading = std::ranges::find_if(right, [](const Rational& x) { return !x.is_zero(); });
    if (leading == right.end() || is_zero(left)) return std::nullopt;
    Rational factor = left[static_cast<std::size_t>(leading - right.begin())] / *leading;
    for (std::size_t j = 0; j < left.size(); ++j) {
        if (left[j] != factor * right[j]) return std::nullopt;
    }
    return factor;
}

}  // namespace

ScaledContact scaled_contact(const BezierCurve& left, const BezierCurve& right, const Limits& limits) {
    const Rational& s = right.interval().a();
    const std::size_t n = std::max(left.degree(), right.degree());
    // The blossom values at (s^(n-k), (s + 1)^k), as in `contact`.
    const auto polygon = [&](const BezierCurve& curve) {
        return elevate(control_points(curve, {s, s + 1}, limits), n - curve.degree(), limits)
            .control_points();
    };
    const PointArray f = polygon(left);
    const PointArray g = polygon(right);
    ScaledContact result;
    for (std::size_t k = 0; k <= n; ++k) {
        const Coordinates value = f[k];
        const Coordinates other = g[k];
        if (is_zero(value) && is_zero(other)) continue;
        const auto factor = quotient(value, other);
        if (!factor || (result.factor && *result.factor != *factor)) return result;
        result.factor = factor;
    }
    result.is_infinite = true;
    return result;
}

BezierCurve scaled(const BezierCurve& curve, const Rational& factor) {
    std::vector<Coordinates> points = curve.control_points().to_points();
    for (Coordinates& point : points) {
        for (Rational& coordinate : point) coordinate *= factor;
    }
    return BezierCurve(points, curve.interval());
}

}  // namespace blossom
