#include <blossom/core/derivative.hpp>
#include <blossom/core/rational_curve.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <vector>

namespace blossom {

namespace {

void require_weight(const Rational& weight) {
    if (weight.is_zero()) {
        throw Error(ErrorCode::zero_weight,
                    "a point of weight 0 lies at infinity and has no Euclidean coordinates");
    }
}

}  // namespace

Coordinates projected(const Coordinates& homogeneous) {
    if (homogeneous.size() < 2) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "homogeneous coordinates are at least one coordinate and a weight");
    }
    require_weight(homogeneous.back());
    Coordinates point(homogeneous.begin(), homogeneous.end() - 1);
    for (Rational& coordinate : point) coordinate /= homogeneous.back();
    return point;
}

Coordinates homogeneous_point(const Coordinates& point, const Rational& weight) {
    require_weight(weight);
    Coordinates homogeneous = point;
    for (Rational& coordinate : homogeneous) coordinate *= weight;
    homogeneous.push_back(weight);
    return homogeneous;
}

Coordinates rational_derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                                const Limits& limits) {
    std::vector<Coordinates> numerators;
    std::vector<Rational> weights;
    for (std::size_t k = 0; k <= order; ++k) {
        Coordinates value = derivative(map, k, t, limits);
        weights.push_back(value.back());
        value.pop_back();
        numerators.push_back(std::move(value));
    }
    require_weight(weights.front());
    std::vector<Coordinates> derivatives;
    for (std::size_t k = 0; k <= order; ++k) {
        Coordinates value = numerators[k];
        for (std::size_t i = 1; i <= k; ++i) {
            const Rational factor = Rational(binomial(k, i)) * weights[i];
            for (std::size_t j = 0; j < value.size(); ++j) value[j] -= factor * derivatives[k - i][j];
        }
        for (Rational& coordinate : value) coordinate /= weights.front();
        derivatives.push_back(std::move(value));
    }
    return derivatives.back();
}

}  // namespace blossom
