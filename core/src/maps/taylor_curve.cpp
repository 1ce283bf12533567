#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/rational/combinatorics.hpp>

#include "change_of_interval.hpp"
#include "integer_frame.hpp"
#include "stated_points.hpp"

namespace blossom {

namespace {

/// The coefficients of sum_k c_k (t + shift)^k.
PointArray shifted(const PointArray& coefficients, const Rational& shift, const Limits& limits) {
    const Integer& q = shift.denominator();
    const std::size_t n = coefficients.size() - 1;
    require_result_bits(greatest_bit_length(coefficients.numbers().numerators()) +
                            n * (shift.numerator().bit_length() + q.bit_length() + 1),
                        limits, coefficients.numbers().size());
    std::vector<Quotients<Integer>> rows;
    for (const auto row : coefficients.rows()) rows.push_back(taylor_coefficients(row, shift));
    return point_array(std::move(rows), coefficients.denominator());
}

}  // namespace

TaylorCurve taylor_form(const PolynomialCurve& curve, const Rational& center, const Limits& limits) {
    return {center, shifted(curve.coefficients(), center, limits)};
}

PolynomialCurve monomial_form(const TaylorCurve& curve, const Limits& limits) {
    return PolynomialCurve(shifted(curve.coefficients, -curve.center, limits));
}

std::vector<StatedValue> stated_values(const TaylorCurve& curve) {
    const std::size_t n = curve.degree();
    const std::vector<Coordinates> points = curve.coefficients.to_points();
    return stated_points(
        "coefficient", points,
        [&](std::size_t k) { return two_arguments(n, k, Parameter(curve.center), delta); },
        [n](std::size_t k) { return binomial(n, k); });
}

}  // namespace blossom
