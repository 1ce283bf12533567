#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "blossom/patch_product.hpp"
#include "maps/bracketed.hpp"

namespace blossom {

namespace {

void require_same_factors(std::span<const BarycentricFrame> left, std::span<const BarycentricFrame> right) {
    const bool same =
        std::ranges::equal(left, right, [](const BarycentricFrame& a, const BarycentricFrame& b) {
            return a.dimension() == b.dimension() && a.space_dimension() == b.space_dimension();
        });
    if (same) return;
    throw Error(ErrorCode::mismatched_dimensions,
                "the domains are products of simplices of different dimensions");
}

std::vector<std::size_t> common_degrees(const NetShape& left, const NetShape& right) {
    std::vector<std::size_t> degrees;
    degrees.reserve(left.factors());
    for (std::size_t f = 0; f < left.factors(); ++f)
        degrees.push_back(std::max(left[f].degree, right[f].degree));
    return degrees;
}

PatchArguments vertices_at(std::span<const BarycentricFrame> frames, const std::vector<MultiIndex>& indices) {
    PatchArguments arguments;
    for (std::size_t f = 0; f < indices.size(); ++f) {
        auto& list = arguments.emplace_back();
        for (std::size_t k = 0; k < indices[f].size(); ++k) {
            list.insert(list.end(), indices[f][k], frames[f].vertices()[k]);
        }
    }
    return arguments;
}

/// The number of vertices off the face, where exponents are multiplicities.
std::size_t distance_from(const std::vector<MultiIndex>& indices, const Face& face) {
    std::size_t off = 0;
    for (std::size_t f = 0; f < indices.size(); ++f) {
        off += std::accumulate(indices[f].begin(), indices[f].end(), std::size_t{0});
        for (const std::size_t vertex : face[f]) off -= indices[f][vertex];
    }
    return off;
}

/// Errors: `mismatched_dimensions`, `wrong_arity` unless the patches and the face have the same product of
/// simplices, and the points the same dimension.
void require_comparable(const PlacedPatch& left, const PlacedPatch& right, const Face& face) {
    require_same_factors(left.frames, right.frames);
    if (left.patch.dimension() != right.patch.dimension()) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "patches in " + std::to_string(left.patch.dimension()) + " and in " +
                        std::to_string(right.patch.dimension()) + " dimensions have no contact");
    }
    if (face.size() != left.frames.size()) {
        throw Error(ErrorCode::wrong_arity, "a face of a product of " + std::to_string(left.frames.size()) +
                                                " simplices has as many factors, not " +
                                                std::to_string(face.size()));
    }
}

/// The coordinates of one patch times the weight of the other.
BezierPatch crossed(const BezierPatch& patch, const BezierPatch& other, const Limits& limits) {
    Form form = form_rows(patch);
    const Form weight = form_rows(other);
    const ProductTable table(form.shape, weight.shape, limits);
    form.rows.pop_back();
    for (auto& row : form.rows) row = table.product(row, weight.rows.back());
    return patch_of<BezierPatch>(
        {table.shape(), std::move(form.rows), form.denominator * weight.denominator});
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

std::vector<Coordinates> common_vertices(const std::vector<Coordinates>& left,
                                         const std::vector<Coordinates>& right) {
    std::vector<Coordinates> common;
    std::ranges::copy_if(left, std::back_inserter(common), [&](const Coordinates& vertex) {
        return std::ranges::find(right, vertex) != right.end();
    });
    return common;
}

/// The ends of the intersection of two intervals, in the order of the left one's.
std::vector<Coordinates> common_interval(const std::vector<Coordinates>& left,
                                         const std::vector<Coordinates>& right) {
    const auto [left_least, left_greatest] = std::ranges::minmax(left);
    const auto [right_least, right_greatest] = std::ranges::minmax(right);
    const Coordinates& least = std::max(left_least, right_least);
    const Coordinates& greatest = std::min(left_greatest, right_greatest);
    if (least > greatest) return {};
    if (least == greatest) return {least};
    if (left.front() < left.back()) return {least, greatest};
    return {greatest, least};
}

}  // namespace

BezierPatch over_frames(const PlacedPatch& patch, std::span<const BarycentricFrame> frames,
                        const Limits& limits) {
    BezierPatch net = patch.patch;
    for (std::size_t factor = 0; factor < frames.size(); ++factor) {
        std::vector<Coordinates> elements;
        for (const Coordinates& vertex : frames[factor].vertices())
            elements.push_back(patch.frames[factor].of_point(vertex));
        net = with_frame(net, factor, elements, limits);
    }
    return net;
}

SharedFace shared_face(std::span<const BarycentricFrame> left, std::span<const BarycentricFrame> right) {
    require_same_factors(left, right);
    SharedFace shared;
    for (std::size_t f = 0; f < left.size(); ++f) {
        const std::vector<Coordinates>& vertices = left[f].vertices();
        const bool is_interval = left[f].dimension() == 1 && left[f].space_dimension() == 1;
        std::vector<Coordinates> common = common_vertices(vertices, right[f].vertices());
        if (is_interval) {
            std::vector<Coordinates> interval = common_interval(vertices, right[f].vertices());
            shared.is_partial = shared.is_partial || interval != common;
            common = std::move(interval);
        }
        if (common.empty()) {
            throw Error(ErrorCode::not_adjacent,
                        (is_interval ? "the intervals have no common point in factor "
                                     : "the domains share no vertex of factor ") +
                            std::to_string(f));
        }
        auto& own = shared.face.emplace_back();
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const bool is_common = std::ranges::find(common, vertices[k]) != common.end();
            if (is_common || (is_interval && common.size() == 2)) own.push_back(k);
        }
        shared.common.push_back(common);
    }
    return shared;
}

PatchContact contact(const PlacedPatch& left, const PlacedPatch& right, const Face& face,
                     const Limits& limits) {
    require_comparable(left, right, face);
    const std::vector<std::size_t> degrees = common_degrees(left.patch.shape(), right.patch.shape());
    const BezierPatch f = elevated_to(left.patch, degrees, limits);
    const BezierPatch g =
        over_frames({elevated_to(right.patch, degrees, limits), right.frames}, left.frames, limits);
    const auto indices = net_indices(f.shape());
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (first && distance_from(indices[i], face) >= distance_from(indices[*first], face)) continue;
        if (f.control_net()[i] != g.control_net()[i]) first = i;
    }
    if (!first) return {};
    return {static_cast<std::ptrdiff_t>(distance_from(indices[*first], face)) - 1,
            PatchDifference{vertices_at(left.frames, indices[*first]), f.control_net()[*first],
                            g.control_net()[*first]}};
}

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

namespace {

std::string text_of(const PatchContact& contact, const std::string& same, const std::string& what) {
    if (contact.is_infinite()) return "The patches are the same " + same;
    const PatchDifference& difference = *contact.first_difference;
    std::string arguments;
    for (const auto& list : difference.arguments) {
        arguments += (arguments.empty() ? "" : "; ") +
                     listed(list, [](const Coordinates& point) { return bracketed(point); });
    }
    const std::string values =
        what + arguments + "] are " + bracketed(difference.left) + " and " + bracketed(difference.right);
    if (*contact.order < 0) return "The patches do not meet along the face" + values;
    return "The patches meet with order " + std::to_string(*contact.order) + " along the face" + values;
}

}  // namespace

std::string to_string(const PatchContact& contact) {
    return text_of(contact, "polynomial", ": the blossom values at [");
}

std::string projected_contact_text(const PatchContact& contact) {
    return text_of(contact, "rational map",
                   ": of the points of each multiplied by the weight of the other, the blossom values at [");
}

}  // namespace blossom
