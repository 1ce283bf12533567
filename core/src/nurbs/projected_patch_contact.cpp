#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/patch_subdivision.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

#include "blossom/patch_product.hpp"
#include "patch/patch_faces.hpp"

namespace blossom {

namespace {

/// The coordinates of one patch times the weight of the other.
BezierPatch crossed(const BezierPatch& patch, const BezierPatch& other, const Limits& limits) {
    Form form = form_of(patch);
    const Form weight = form_of(other);
    const ProductTable table(form.shape, weight.shape, limits);
    form.rows.pop_back();
    for (auto& row : form.rows) row = table.product(row, weight.rows.back());
    return patch_of_form({table.shape(), std::move(form.rows), form.denominator * weight.denominator}, patch);
}

/// Errors: `zero_weight` if the weight vanishes on the whole face.
void require_weight(const BezierPatch& patch, const Face& face, const std::string& side) {
    const auto indices = net_indices(patch.shape());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (distance_from(indices[i], face) == 0 && !patch.control_net()[i].back().is_zero()) return;
    }
    throw Error(ErrorCode::zero_weight,
                "the weight of the " + side + " patch is 0 on the whole face, where it has no points");
}

}  // namespace

PatchContact projected_contact(const PlacedPatch& left, const PlacedPatch& right, const Face& face,
                               const Limits& limits) {
    require_comparable(left, right, face);
    if (left.patch.dimension() < 2) {
        throw Error(ErrorCode::mismatched_dimensions, "a rational map has a coordinate besides its weight");
    }
    const PlacedPatch moved{over_frames(right, left.frames, limits), left.frames};
    require_weight(left.patch, face, "left");
    require_weight(moved.patch, face, "right");
    return contact({crossed(left.patch, moved.patch, limits), left.frames},
                   {crossed(moved.patch, left.patch, limits), left.frames}, face, limits);
}

}  // namespace blossom
