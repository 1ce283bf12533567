#pragma once

// Products of patches, as homogeneous polynomials in the coordinates of their arguments.

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <utility>
#include <vector>

#include "maps/patch_kernel.hpp"

namespace blossom {

/// Coefficients over one denominator, one row per coordinate.
struct Form {
    NetShape shape;
    std::vector<std::vector<Integer>> rows;
    Integer denominator;
};

/// The homogeneous polynomial of a patch.
template <PatchRepresentation Map>
Form form_rows(const Map& patch) {
    const PointArray& coefficients = form_of(patch);
    Form form{patch.shape(), {}, coefficients.denominator()};
    for (const auto row : coefficients.rows()) form.rows.emplace_back(row.begin(), row.end());
    return form;
}

/// The patch of a homogeneous polynomial.
template <PatchRepresentation Map>
Map patch_of(const Form& form) {
    PointArray points = canonical_points(form.rows, form.denominator);
    if constexpr (std::same_as<Map, BezierPatch>) points = polar_of(form.shape, points);
    return {form.shape, std::move(points)};
}

/// The positions in the product of the products of two coefficients, for two shapes with the same factors.
///
/// Cost: one number per pair of coefficients. Errors: `limit_exceeded` if there are more than
/// `limits.numbers` pairs or the degrees are too high.
class ProductTable {
public:
    ProductTable(const NetShape& a, const NetShape& b, const Limits& limits);

    const NetShape& shape() const { return shape_; }
    std::vector<Integer> product(std::span<const Integer> a, std::span<const Integer> b) const;

private:
    NetShape shape_;
    std::vector<std::size_t> places_;
};

}  // namespace blossom
