#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/nurbs/rational_patch.hpp>
#include <blossom/rational/error.hpp>

#include <utility>
#include <vector>

namespace blossom {

Coordinates projected_derivative(std::size_t directions,
                                 const std::function<Coordinates(std::size_t subset)>& derivative,
                                 const Limits& limits) {
    std::size_t products = 1;
    for (std::size_t k = 0; k < directions && products <= limits.polarization_terms; ++k) products *= 3;
    require_within(products, limits.polarization_terms, "polarization_terms",
                   "the number of products of the quotient rule, at least", Part::order);
    std::vector<Coordinates> values{derivative(0)};
    std::vector<Coordinates> projections{projected(values.front())};
    const Rational weight = values.front().back();
    for (std::size_t subset = 1; subset < std::size_t{1} << directions; ++subset) {
        values.push_back(derivative(subset));
        Coordinates point(values.back().begin(), values.back().end() - 1);
        for (std::size_t part = subset; part > 0; part = (part - 1) & subset) {
            for (std::size_t j = 0; j < point.size(); ++j) {
                point[j] -= values[part].back() * projections[subset ^ part][j];
            }
        }
        for (Rational& coordinate : point) coordinate /= weight;
        projections.push_back(std::move(point));
    }
    return projections.back();
}

}  // namespace blossom
