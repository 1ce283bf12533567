#pragma once

#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/limits.hpp>

#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// A coordinate of one of several maps.
struct CoordinateOf {
    std::size_t map;
    std::size_t coordinate;

    friend auto operator<=>(const CoordinateOf&, const CoordinateOf&) = default;
};

/// A number times a product of coordinates; without coordinates, the number.
struct CoordinateProduct {
    std::vector<CoordinateOf> coordinates;
    Rational factor = 1;
};

/// A polynomial in the coordinates of several maps: the sum of these products.
using CoordinateSum = std::vector<CoordinateProduct>;

/// One polynomial per coordinate of a map made of others, see `combined`.
using CoordinateSums = std::vector<CoordinateSum>;

/// sum_i factors[i] P_i of maps into Q^dimension.
CoordinateSums linear_combination(std::span<const Rational> factors, std::size_t dimension);

/// The product of scalar maps, and of at most one map with more than one coordinate. `dimensions[i]` is that
/// of map i. Errors: `mismatched_dimensions` at `Part::maps / i` for a second map with more coordinates.
CoordinateSums scalar_multiple(std::span<const std::size_t> dimensions);

/// sum_j P_j Q_j of two maps.
CoordinateSums dot_product(std::size_t dimension);

/// det(P_1, ..., P_n) of n maps into Q^n. Errors: `limit_exceeded` if n! is greater than
/// `limits.expansion_terms`.
CoordinateSums determinant(std::size_t dimension, const Limits& limits = {});

/// The map N with det(C, P_1, ..., P_(n-1)) = C . N for every C, of n - 1 maps into Q^n: the cross product in
/// space, and (y, -x) of one map (x, y). Errors: as for `determinant`.
CoordinateSums cross_product(std::size_t dimension, const Limits& limits = {});

/// matrix P + translation of one map: a row per coordinate of the result.
CoordinateSums affine_image(std::span<const Coordinates> matrix, std::span<const Rational> translation);

/// The same polynomials of rational maps A_i / w_i, as a rational map: numerators and, last, the denominator.
///
/// `weights[i]` is the weight w_i of map i, nullopt for 1. Maps with the same weight share it: it is raised
/// to the greatest number of their coordinates in one product, and no further.
CoordinateSums projective(CoordinateSums sums, std::span<const std::optional<CoordinateOf>> weights);

}  // namespace blossom
