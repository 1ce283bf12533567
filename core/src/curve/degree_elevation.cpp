#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/curve/degree_elevation.hpp>

#include <algorithm>

#include "maps/integer_frame.hpp"

namespace blossom {

namespace {

void require_degree(std::size_t n, std::size_t r, const Limits& limits) {
    require_within(r, limits.degree, "degree", "the number of degrees to raise by", Part::by);
    require_within(n + r, limits.degree, "degree", "the raised degree", Part::by);
}

}  // namespace

// In the Bernstein form sum_j C(n, j) P_j x^j y^(n-j) raising the degree is multiplication by (x + y)^r.
BezierCurve elevate(const BezierCurve& curve, std::size_t r, const Limits& limits) {
    const std::size_t n = curve.degree();
    require_degree(n, r, limits);
    require_result_bits(greatest_bit_length(curve.control_points().numbers().numerators()) + 4 * (n + r),
                        limits, (n + r + 1) * curve.dimension());
    const std::vector<Integer> binomials = binomial_row(r);
    std::vector<Quotients<Integer>> rows;
    for (const auto row : curve.control_points().rows()) {
        const std::vector<Integer> form = constructions::bernstein_form(row);
        std::vector<Integer> raised(n + r + 1);
        for (std::size_t j = 0; j <= n; ++j) {
            for (std::size_t i = 0; i <= r; ++i) raised[j + i].add_product(form[j], binomials[i]);
        }
        rows.push_back(constructions::normalised_coefficients(std::span<const Integer>(raised)));
    }
    return {point_array(std::move(rows), curve.control_points().denominator()), curve.interval()};
}

PolynomialCurve elevate(const PolynomialCurve& curve, std::size_t r, const Limits& limits) {
    require_degree(curve.degree(), r, limits);
    return PolynomialCurve(curve.coefficients().to_points(), curve.degree() + r);
}

}  // namespace blossom
