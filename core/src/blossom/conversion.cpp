#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/blossom/conversion.hpp>

#include "maps/change_of_interval.hpp"
#include "maps/integer_frame.hpp"

namespace blossom {

namespace {

void require_size(const PointArray& points, std::size_t bits_a_degree, const Limits& limits) {
    require_result_bits(greatest_bit_length(points.numbers().numerators()) + points.size() * bits_a_degree,
                        limits, points.numbers().size());
}

}  // namespace

BezierCurve control_points(const PolynomialCurve& curve, const Interval& interval, const Limits& limits) {
    require_size(curve.coefficients(), cleared(interval).bits(), limits);
    std::vector<Quotients<Integer>> rows;
    for (const auto row : curve.coefficients().rows()) rows.push_back(bernstein_from_monomial(row, interval));
    return {point_array(std::move(rows), curve.coefficients().denominator()), interval};
}

// In the local coordinate s = (t - a) / (b - a), the ends of the new interval are (c - a) / (b - a) and (d -
// a) / (b - a).
BezierCurve control_points(const BezierCurve& curve, const Interval& interval, const Limits& limits) {
    const Rational& a = curve.interval().a();
    const Rational length = curve.interval().b() - a;
    const Interval local((interval.a() - a) / length, (interval.b() - a) / length);
    require_size(curve.control_points(), cleared(local).bits(), limits);
    std::vector<Quotients<Integer>> rows;
    for (const auto row : curve.control_points().rows()) {
        const std::vector<Integer> coefficients = constructions::local_monomial_from_bernstein(row);
        rows.push_back(bernstein_from_monomial(coefficients, local));
    }
    return {point_array(std::move(rows), curve.control_points().denominator()), interval};
}

PolynomialCurve monomial_form(const BezierCurve& curve, const Limits& limits) {
    const auto [a, b, q] = cleared(curve.interval());
    require_size(curve.control_points(), cleared(curve.interval()).bits(), limits);
    std::vector<Quotients<Integer>> rows;
    for (const auto row : curve.control_points().rows()) {
        rows.push_back(constructions::monomial_from_bernstein(row, a, b, q));
    }
    return PolynomialCurve(point_array(std::move(rows), curve.control_points().denominator()));
}

BezierCurve control_points(const PolynomialMap& map, const Interval& interval, const Limits& limits) {
    return std::visit([&](const auto& curve) { return control_points(curve, interval, limits); }, map);
}

PolynomialCurve monomial_form(const PolynomialMap& map, const Limits& limits) {
    const auto* curve = std::get_if<PolynomialCurve>(&map);
    return curve ? *curve : monomial_form(std::get<BezierCurve>(map), limits);
}

}  // namespace blossom
