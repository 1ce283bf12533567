#include <blossom/core/curve/newton_form.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/rational_vector.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "maps/integer_frame.hpp"
#include "newton_steps.hpp"

namespace blossom {

namespace {

RationalVector first_nodes(std::span<const Rational> nodes, std::size_t degree) {
    if (nodes.size() < degree) {
        throw Error(ErrorCode::wrong_arity,
                    "degree " + std::to_string(degree) + " needs " + std::to_string(degree) + " nodes, not " +
                        std::to_string(nodes.size()),
                    Part::nodes);
    }
    return RationalVector(nodes.first(degree));
}

/// Runs `steps` on the coefficients for the variable y = q t, where the nodes a_k / q are the integers a_k:
/// q^n P(y / q) has the coefficients c_k q^(n-k).
template <class Steps>
PointArray with_integer_nodes(const PointArray& coefficients, const RationalVector& nodes,
                              const Limits& limits, const Steps& steps) {
    const std::size_t n = coefficients.size() - 1;
    const Integer& q = nodes.denominator();
    const std::size_t bits = std::max(greatest_bit_length(nodes.numerators()), q.bit_length()) + 1;
    require_result_bits(greatest_bit_length(coefficients.numbers().numerators()) + n * bits, limits,
                        coefficients.numbers().size());
    std::vector<Integer> powers{1};
    for (std::size_t k = 0; k < n; ++k) powers.push_back(powers.back() * q);
    std::vector<Quotients<Integer>> rows;
    for (const auto given : coefficients.rows()) {
        std::vector<Integer> row(given.begin(), given.end());
        for (std::size_t k = 0; k <= n; ++k) row[k] *= powers[n - k];
        steps(std::span(row), std::span(nodes.numerators()));
        for (std::size_t k = 0; k <= n; ++k) row[k] *= powers[k];
        rows.push_back({std::move(row), powers[n]});
    }
    return point_array(std::move(rows), coefficients.denominator());
}

}  // namespace

PointArray newton_form(const PolynomialCurve& curve, std::span<const Rational> nodes, const Limits& limits) {
    return with_integer_nodes(curve.coefficients(), first_nodes(nodes, curve.degree()), limits,
                              divide_by_nodes);
}

PolynomialCurve monomial_form_of_newton(const PointArray& coefficients, std::span<const Rational> nodes,
                                        const Limits& limits) {
    return PolynomialCurve(with_integer_nodes(coefficients, first_nodes(nodes, coefficients.size() - 1),
                                              limits, multiply_by_nodes));
}

void require_distinct(std::span<const Rational> nodes) {
    std::map<Rational, std::size_t> first;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto [known, is_new] = first.emplace(nodes[i], i);
        if (is_new) continue;
        throw Error(ErrorCode::wrong_arity,
                    "the nodes " + std::to_string(known->second) + " and " + std::to_string(i) +
                        " are equal (" + to_string(nodes[i]) + "); they must be distinct",
                    Part::nodes / i);
    }
}

PolynomialCurve lagrange_polynomials(std::span<const Rational> nodes, const Limits& limits) {
    if (nodes.empty()) throw Error(ErrorCode::wrong_arity, "at least one node is needed", Part::nodes);
    require_distinct(nodes);
    const RationalVector cleared(nodes);
    const std::vector<Integer>& all = cleared.numerators();
    const std::size_t n = all.size() - 1;
    const std::size_t bits = std::max(greatest_bit_length(all), cleared.denominator().bit_length()) + 1;
    require_result_bits((n + 1) * bits, limits, (n + 1) * (n + 1));
    std::vector<Integer> product(n + 2);
    product[n + 1] = 1;
    multiply_by_nodes(product, all);
    std::vector<Quotients<Integer>> rows;
    for (std::size_t i = 0; i <= n; ++i) {
        std::vector<Integer> quotient(product.begin() + 1, product.end());
        for (std::size_t k = n; k-- > 0;) quotient[k].add_product(all[i], quotient[k + 1]);
        Integer value = quotient[n];
        for (std::size_t k = n; k-- > 0;) value = value * all[i] + quotient[k];
        Integer power = 1;
        for (Integer& coefficient : quotient) {
            coefficient *= power;
            power *= cleared.denominator();
        }
        if (value.sign() < 0) {
            value.negate();
            for (Integer& coefficient : quotient) coefficient.negate();
        }
        rows.push_back({std::move(quotient), std::move(value)});
    }
    return PolynomialCurve(point_array(std::move(rows), 1));
}

}  // namespace blossom
