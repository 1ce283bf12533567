#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

void require_affine_point(const NetShape& shape, const PatchPoint& point) {
    require_point(shape, point);
    for (std::size_t f = 0; f < point.size(); ++f) {
        within(f, [&] { require_mass(point[f], 1, "a point"); });
    }
}

void require_vectors(const PatchArguments& directions) {
    within(Part::directions, [&] { require_masses(directions, 0, "a direction"); });
}

}  // namespace

Coordinates blossom_value(const BezierPatch& patch, const PatchArguments& arguments, const Limits& limits) {
    return polar_value(patch.shape(), patch.control_net(), arguments, limits);
}

std::vector<Coordinates> evaluate(const BezierPatch& patch, std::span<const PatchPoint> points,
                                  const Limits& limits) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        within(Part::at, [&] { within(i, [&] { require_affine_point(patch.shape(), points[i]); }); });
    }
    return form_values(patch.shape(), form_of(patch.shape(), patch.control_net()), points, limits);
}

Coordinates evaluate(const BezierPatch& patch, const PatchPoint& point, const Limits& limits) {
    return evaluate(patch, std::span(&point, 1), limits).front();
}

Coordinates derivative(const BezierPatch& patch, const PatchArguments& directions, const PatchPoint& at,
                       const Limits& limits) {
    const NetShape& shape = patch.shape();
    require_directions(shape, directions);
    require_vectors(directions);
    within(Part::at, [&] { require_affine_point(shape, at); });
    return polar_derivative_at(shape, patch.control_net(), directions, at, limits);
}

BezierPatch derivative_patch(const BezierPatch& patch, const PatchArguments& directions,
                             const Limits& limits) {
    require_directions(patch.shape(), directions);
    require_vectors(directions);
    auto [shape, net] = polar_derivative(patch.shape(), patch.control_net(), directions, limits);
    return {std::move(shape), std::move(net)};
}

}  // namespace blossom
