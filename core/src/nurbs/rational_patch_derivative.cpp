#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/nurbs/rational_patch.hpp>
#include <blossom/core/patch/patch_elevation.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "blossom/patch_product.hpp"

namespace blossom {

namespace {

/// The derivative in a direction of the whole domain, with the degrees of the map: the sum over the factors,
/// in each raised by one.
template <class Kind>
Form full_derivative(const Kind& map, const PatchPoint& direction, const Limits& limits) {
    const NetShape& shape = map.shape();
    std::vector<Coordinates> sum(shape.size(), Coordinates(map.dimension()));
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        const bool zero = std::ranges::all_of(direction[f], &Rational::is_zero);
        if (zero || shape[f].degree == 0) continue;
        PatchArguments directions(shape.factors());
        directions[f].push_back(direction[f]);
        const Kind part = elevate(derivative_patch(map, directions, limits), f, 1, limits);
        const Form form = form_of(part);
        for (std::size_t j = 0; j < form.rows.size(); ++j) {
            for (std::size_t i = 0; i < form.rows[j].size(); ++i)
                sum[i][j] += Rational(form.rows[j][i], form.denominator);
        }
    }
    const PointArray total(sum);
    Form form{shape, {}, total.denominator()};
    for (const auto row : total.rows()) form.rows.emplace_back(row.begin(), row.end());
    return form;
}

/// N w' - k N' w over the common denominator of both, for k the number of derivatives.
Form quotient_step(const Form& numerator, const Form& derived, const Form& weight, const Form& derived_weight,
                   std::size_t k, const Limits& limits) {
    const ProductTable table(numerator.shape, weight.shape, limits);
    const Integer plus = numerator.denominator * derived_weight.denominator;
    const Integer minus = derived.denominator * weight.denominator * Integer(k);
    Form step{table.shape(), {}, plus * derived.denominator * weight.denominator};
    for (std::size_t j = 0; j < numerator.rows.size(); ++j) {
        auto row = table.product(derived.rows[j], weight.rows.back());
        const auto other = table.product(numerator.rows[j], derived_weight.rows.back());
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] * plus - other[i] * minus;
        step.rows.push_back(std::move(row));
    }
    return step;
}

/// Errors: `limit_exceeded` unless the products of all steps are within `expansion_work`; those of step k
/// count k times, since their numbers have k times the digits.
void require_work(const NetShape& shape, std::size_t dimension, std::size_t steps, const Limits& limits) {
    std::size_t work = 0;
    for (std::size_t k = 1; k <= steps && work <= limits.expansion_work; ++k) {
        std::vector<SimplexFactor> factors;
        factors.reserve(shape.factors());
        for (std::size_t f = 0; f < shape.factors(); ++f)
            factors.push_back({shape[f].dimension, k * shape[f].degree});
        work += 2 * k * dimension * shape.size() * NetShape(std::move(factors), limits).size();
    }
    require_within(work, limits.expansion_work, "expansion_work",
                   "the number of products of the quotient rule, at least", Part::order);
}

template <class Kind>
Kind quotient_derivative(const Kind& map, std::span<const PatchPoint> directions, const Limits& limits) {
    Form weight = form_of(map);
    Form numerator = weight;
    numerator.rows.pop_back();
    weight.rows.erase(weight.rows.begin(), weight.rows.end() - 1);
    if (std::ranges::all_of(weight.rows.front(), &Integer::is_zero)) {
        throw Error(ErrorCode::zero_weight, "the weight is 0 everywhere, so that there is no map to derive");
    }
    if (numerator.rows.empty()) {
        throw Error(ErrorCode::mismatched_dimensions, "a rational map has a coordinate besides its weight");
    }
    require_work(map.shape(), map.dimension(), directions.size(), limits);
    Form power = weight;
    for (std::size_t k = 1; k <= directions.size(); ++k) {
        const PatchPoint& direction = directions[k - 1];
        const Form derived = full_derivative(patch_of_form(numerator, map), direction, limits);
        const Form derived_weight = full_derivative(patch_of_form(weight, map), direction, limits);
        const ProductTable table(power.shape, weight.shape, limits);
        numerator = quotient_step(numerator, derived, weight, derived_weight, k, limits);
        power = {table.shape(),
                 {table.product(power.rows.front(), weight.rows.front())},
                 power.denominator * weight.denominator};
    }
    // Both over one denominator.
    Form result{numerator.shape, {}, numerator.denominator * power.denominator};
    for (auto& row : numerator.rows) {
        for (Integer& entry : row) entry *= power.denominator;
        result.rows.push_back(std::move(row));
    }
    for (Integer& entry : power.rows.front()) entry *= numerator.denominator;
    result.rows.push_back(std::move(power.rows.front()));
    return patch_of_form(result, map);
}

}  // namespace

BezierPatch rational_derivative_patch(const BezierPatch& patch, std::span<const PatchPoint> directions,
                                      const Limits& limits) {
    return quotient_derivative(patch, directions, limits);
}

PolynomialPatch rational_derivative_patch(const PolynomialPatch& patch,
                                          std::span<const PatchPoint> directions, const Limits& limits) {
    return quotient_derivative(patch, directions, limits);
}

}  // namespace blossom
