#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/blossom/evaluation.hpp>

#include "maps/integer_frame.hpp"

namespace blossom {

namespace {

/// t = u/v in integers; also checks the size of the result.
HomogeneousPair<Integer> cleared_parameter(const PointArray& numbers, const Parameter& t,
                                           std::size_t more_bits, const Limits& limits) {
    const std::size_t bits = std::max(t.value.numerator().bit_length(), t.value.denominator().bit_length());
    require_result_bits(
        greatest_bit_length(numbers.numbers().numerators()) + (numbers.size() - 1) * (bits + more_bits + 1),
        limits);
    return {t.value.numerator(), t.value.denominator()};
}

}  // namespace

Coordinates evaluate(const PolynomialCurve& curve, const Parameter& t, const Limits& limits) {
    const PointArray& coefficients = curve.coefficients();
    const auto [u, v] = cleared_parameter(coefficients, t, 0, limits);
    Quotients<Integer> value{{}, coefficients.denominator()};
    for (const auto row : coefficients.rows())
        value.numerators.push_back(constructions::form_value(row, u, v));
    return reduced(value, pow(v, curve.degree()));
}

Coordinates evaluate(const BezierCurve& curve, const Parameter& t, const Limits& limits) {
    const auto interval = cleared(curve.interval());
    const auto& [a, b, q] = interval;
    const PointArray& points = curve.control_points();
    const auto [u, v] = cleared_parameter(points, t, interval.bits(), limits);
    const Integer x = q * u - a * v;
    const Integer y = b * v - q * u;
    Quotients<Integer> value{{}, points.denominator()};
    for (const auto row : points.rows()) {
        value.numerators.push_back(
            constructions::form_value(std::span<const Integer>(constructions::bernstein_form(row)), x, y));
    }
    return reduced(value, pow(v * (b - a), curve.degree()));
}

}  // namespace blossom
