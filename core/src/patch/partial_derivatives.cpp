#include <blossom/core/patch/partial_derivatives.hpp>
#include <blossom/core/patch/patch_derivative.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>

namespace blossom {

namespace {

/// `argument(f, vector)` is the argument of factor f for a vector of its space.
template <class Map, class Argument>
std::vector<Map> with_derivatives(const Map& patch, const Argument& argument, const Limits& limits) {
    std::vector<Map> maps{patch};
    for (std::size_t factor = 0; factor < patch.shape().factors(); ++factor) {
        for (std::size_t k = 0; k < patch.shape()[factor].dimension; ++k) {
            PatchPoint direction;
            for (std::size_t f = 0; f < patch.shape().factors(); ++f) {
                Coordinates vector(patch.shape()[f].dimension);
                if (f == factor) vector[k] = 1;
                direction.push_back(argument(f, vector));
            }
            maps.push_back(directional_derivative_patch(patch, std::span(&direction, 1), limits));
        }
    }
    return maps;
}

void multiply(CoordinateSums& sums, const Rational& factor) {
    for (CoordinateSum& sum : sums) {
        for (CoordinateProduct& product : sum) product.factor *= factor;
    }
}

/// The maps 1, 2, ... in the place of 0, 1, ...
CoordinateSums of_derivatives(CoordinateSums sums) {
    for (CoordinateSum& sum : sums) {
        for (CoordinateProduct& product : sum) {
            for (CoordinateOf& coordinate : product.coordinates) ++coordinate.map;
        }
    }
    return sums;
}

CoordinateSum power_of_weight(std::size_t dimension, std::size_t exponent) {
    return {{std::vector(exponent, CoordinateOf{0, dimension})}};
}

Rational sign(std::size_t exponent) { return exponent % 2 == 0 ? 1 : -1; }

}  // namespace

std::vector<PolynomialPatch> with_partial_derivatives(const PolynomialPatch& patch, const Limits& limits) {
    return with_derivatives(
        patch, [](std::size_t, const Coordinates& vector) { return vector_argument(vector); }, limits);
}

std::vector<BezierPatch> with_partial_derivatives(const BezierPatch& patch,
                                                  std::span<const BarycentricFrame> frames,
                                                  const Limits& limits) {
    return with_derivatives(
        patch, [&](std::size_t f, const Coordinates& vector) { return frames[f].of_vector(vector); }, limits);
}

std::vector<TensorBSpline> with_partial_derivatives(const TensorBSpline& spline, const Limits& limits) {
    std::vector<TensorBSpline> maps{spline};
    for (std::size_t d = 0; d < spline.directions(); ++d) {
        std::vector<std::size_t> orders(spline.directions());
        orders[d] = 1;
        maps.push_back(derivative_spline(spline, orders, limits));
    }
    return maps;
}

CoordinateSums partial_derivative(std::size_t i, std::size_t dimension, bool rational) {
    CoordinateSums sums;
    for (std::size_t j = 0; j < dimension; ++j) {
        if (rational) {
            sums.push_back({{{{i, j}, {0, dimension}}}, {{{0, j}, {i, dimension}}, -1}});
        } else {
            sums.push_back({{{{i, j}}}});
        }
    }
    if (rational) sums.push_back(power_of_weight(dimension, 2));
    return sums;
}

CoordinateSums jacobian_determinant(std::size_t dimension, bool rational, const Limits& limits) {
    if (!rational) return of_derivatives(determinant(dimension, limits));
    CoordinateSums sums = determinant(dimension + 1, limits);
    multiply(sums, sign(dimension));
    sums.push_back(power_of_weight(dimension, dimension + 1));
    return sums;
}

CoordinateSums normal_vector(std::size_t dimension, bool rational, const Limits& limits) {
    if (!rational) return of_derivatives(cross_product(dimension, limits));
    CoordinateSums sums = cross_product(dimension + 1, limits);
    sums.pop_back();
    multiply(sums, sign(dimension + 1));
    sums.push_back(power_of_weight(dimension, dimension));
    return sums;
}

}  // namespace blossom
