#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/nurbs/rational_patch.hpp>
#include <blossom/core/patch/patch_derivative.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "blossom/patch_product.hpp"

namespace blossom {

namespace {

/// The derivative in a direction of the whole domain, raised to the degrees of the map.
template <class Map>
Form full_derivative(const Map& map, const PatchPoint& direction, const Limits& limits) {
    std::vector<std::size_t> degrees;
    degrees.reserve(map.shape().factors());
    for (std::size_t f = 0; f < map.shape().factors(); ++f) degrees.push_back(map.shape()[f].degree);
    return form_rows(
        elevated_to(directional_derivative_patch(map, std::span(&direction, 1), limits), degrees, limits));
}

/// N w' - k N' w over the common denominator of both terms, where k is the number of derivatives.
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

/// Errors: `limit_exceeded` unless the products of all steps are within `expansion_work`. The products of
/// step k count k times, because their numbers have k times as many digits.
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

}  // namespace

Coordinates rational_derivative(const PatchMap& map, std::span<const PatchPoint> directions,
                                const PatchPoint& at, const Limits& limits) {
    const auto groups = constructions::grouped(directions);
    std::vector<std::size_t> orders;
    std::size_t products = 1;
    for (const auto& [direction, times] : groups) {
        orders.push_back(times);
        if (products <= limits.polarization_terms) products *= (times + 1) * (times + 2) / 2;
    }
    require_within(products, limits.polarization_terms, "polarization_terms",
                   "the number of products of the quotient rule, at least", Part::order);
    return quotient_rule(orders, [&](std::span<const std::size_t> counts) {
        std::vector<PatchPoint> chosen;
        for (std::size_t i = 0; i < counts.size(); ++i)
            chosen.insert(chosen.end(), counts[i], groups[i].first);
        return directional_derivative(map, chosen, at, limits);
    });
}

template <PatchRepresentation Map>
Map rational_derivative_patch(const Map& map, std::span<const PatchPoint> directions, const Limits& limits) {
    Form weight = form_rows(map);
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
        const Form derived = full_derivative(patch_of<Map>(numerator), direction, limits);
        const Form derived_weight = full_derivative(patch_of<Map>(weight), direction, limits);
        const ProductTable table(power.shape, weight.shape, limits);
        numerator = quotient_step(numerator, derived, weight, derived_weight, k, limits);
        power = {table.shape(),
                 {table.product(power.rows.front(), weight.rows.front())},
                 power.denominator * weight.denominator};
    }
    // Both are over the same denominator.
    Form result{numerator.shape, {}, numerator.denominator * power.denominator};
    for (auto& row : numerator.rows) {
        for (Integer& entry : row) entry *= power.denominator;
        result.rows.push_back(std::move(row));
    }
    for (Integer& entry : power.rows.front()) entry *= numerator.denominator;
    result.rows.push_back(std::move(power.rows.front()));
    return patch_of<Map>(result);
}

template BezierPatch rational_derivative_patch(const BezierPatch&, std::span<const PatchPoint>,
                                               const Limits&);
template PolynomialPatch rational_derivative_patch(const PolynomialPatch&, std::span<const PatchPoint>,
                                                   const Limits&);

}  // namespace blossom
