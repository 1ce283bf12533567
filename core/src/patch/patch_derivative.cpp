#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/patch/patch_derivative.hpp>

#include <algorithm>
#include <map>

namespace blossom {

namespace {

bool is_zero(const Coordinates& tuple) { return std::ranges::all_of(tuple, &Rational::is_zero); }

/// Lists of directions in single factors, with the number of their occurrences.
using FactorTerms = std::map<PatchArguments, Integer>;

FactorTerms factor_terms(const NetShape& shape, std::span<const PatchPoint> directions,
                         const Limits& limits) {
    FactorTerms terms{{PatchArguments(shape.factors()), 1}};
    for (const PatchPoint& direction : directions) {
        FactorTerms longer;
        // A direction that is 0 in all factors is assigned to the first factor.
        const bool zero = std::ranges::all_of(direction, is_zero);
        for (const auto& [lists, times] : terms) {
            for (std::size_t f = 0; f < shape.factors(); ++f) {
                if (is_zero(direction[f]) && (!zero || f > 0)) continue;
                PatchArguments extended = lists;
                extended[f].push_back(direction[f]);
                longer[std::move(extended)] += times;
            }
        }
        terms = std::move(longer);
        require_within(terms.size(), limits.polarization_terms, "polarization_terms",
                       "the number of mixed derivatives");
    }
    return terms;
}

}  // namespace

Coordinates directional_derivative(const PatchMap& map, std::span<const PatchPoint> directions,
                                   const PatchPoint& at, const Limits& limits) {
    Coordinates sum(points_of(map).dimension());
    for (const auto& [lists, times] : factor_terms(shape_of(map), directions, limits)) {
        const Coordinates value =
            std::visit([&](const auto& one) { return derivative(one, lists, at, limits); }, map);
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += Rational(times) * value[j];
    }
    return sum;
}

template <PatchRepresentation Map>
Map directional_derivative_patch(const Map& map, std::span<const PatchPoint> directions,
                                 const Limits& limits) {
    const FactorTerms terms = factor_terms(map.shape(), directions, limits);
    std::vector<Map> derivatives;
    std::vector<std::size_t> degrees(map.shape().factors());
    for (const auto& [lists, times] : terms) {
        const Map& derived = derivatives.emplace_back(derivative_patch(map, lists, limits));
        for (std::size_t f = 0; f < degrees.size(); ++f)
            degrees[f] = std::max(degrees[f], derived.shape()[f].degree);
    }
    std::vector<Coordinates> total;
    auto term = terms.begin();
    for (Map& derived : derivatives) {
        derived = elevated_to(derived, degrees, limits);
        const std::vector<Coordinates> points = points_of(derived).to_points();
        total.resize(points.size(), Coordinates(map.dimension()));
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t j = 0; j < map.dimension(); ++j)
                total[i][j] += Rational(term->second) * points[i][j];
        }
        ++term;
    }
    return {derivatives.front().shape(), PointArray(total)};
}

template BezierPatch directional_derivative_patch(const BezierPatch&, std::span<const PatchPoint>,
                                                  const Limits&);
template PolynomialPatch directional_derivative_patch(const PolynomialPatch&, std::span<const PatchPoint>,
                                                      const Limits&);

}  // namespace blossom
