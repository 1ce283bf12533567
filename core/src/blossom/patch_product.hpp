#pragma once

// Products of patches, as homogeneous polynomials in the coordinates of their arguments.

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <vector>

namespace blossom {

/// Coefficients, one row a coordinate, over one denominator.
struct Form {
    NetShape shape;
    std::vector<std::vector<Integer>> rows;
    Integer denominator;
};

Form form_of(const BezierPatch& patch);
Form form_of(const PolynomialPatch& patch);

/// The patch with this form, in the representation that is asked for.
BezierPatch patch_of_form(const Form& form, const BezierPatch& kind);
PolynomialPatch patch_of_form(const Form& form, const PolynomialPatch& kind);

/// Where the product of two coefficients belongs, for two shapes of the same factors.
///
/// Cost: one number for each pair of coefficients. Errors: `limit_exceeded` when there are more than
/// `limits.numbers` of them or the degrees are too high.
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
