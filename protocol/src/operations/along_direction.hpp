#pragma once

#include <blossom/core/patch/curve_along.hpp>

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "control_nets.hpp"
#include "maps/dispatch_on_kind.hpp"

/// Operations on curves, applied along directions of tensor products. See `curve_along`.

namespace blossom::protocol {

/// Field "direction".
Field direction_field(std::string documentation);
/// The option --direction for this field.
Option direction_option();

/// Field "direction" of a request about a tensor product, the index of a direction; other maps have no such
/// field. Errors: `wrong_arity`.
std::optional<std::size_t> read_direction(Fields& request, const Map& map, const Limits& limits);
/// The same where it must be given. Errors: as well `missing_field`.
std::optional<std::size_t> require_direction(Fields& request, const Map& map, const Limits& limits);
/// The direction alone, or all directions of the map; none of a curve.
std::vector<std::size_t> directions_or_all(std::optional<std::size_t> direction, const Map& map);

/// Errors: `wrong_kind` for a simplex.
void require_tensor(const Patch& patch);
/// The control net with the intervals of its directions. Errors: `wrong_kind` for a simplex.
PlacedPatch placed_tensor(const Patch& patch, const Limits& limits);
Patch tensor_patch(PlacedPatch placed);

/// An operation on curves for curves and, in each of some directions, for tensor products. operation(curve)
/// is a map of the kind of the curve, or a Bezier curve.
template <class Operation>
struct AlongDirections {
    const Operation& operation;
    std::vector<std::size_t> directions;
    const Limits& limits;

    template <class Curve>
        requires std::is_invocable_v<const Operation&, const Curve&>
    AnyMap operator()(const Curve& curve) const {
        return operation(curve);
    }
    AnyMap operator()(TensorBSpline spline) const
        requires std::is_invocable_v<const Operation&, const BSplineCurve&>
    {
        for (const std::size_t d : directions) spline = along(spline, d);
        return spline;
    }
    AnyMap operator()(Patch patch) const
        requires std::is_invocable_v<const Operation&, const BezierCurve&>
    {
        require_tensor(patch);
        for (const std::size_t d : directions) patch = in_direction(patch, d);
        return patch;
    }

private:
    template <class Tensor>
    Tensor along(const Tensor& tensor, std::size_t direction) const {
        return changed_along(tensor, direction, [&](const auto& curve) {
            return std::get<std::remove_cvref_t<decltype(curve)>>(operation(curve));
        });
    }
    Patch in_direction(Patch patch, std::size_t direction) const {
        if (const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map)) {
            const AnyMap changed = operation(curve_along(*polynomial, direction));
            if (const auto* curve = std::get_if<PolynomialCurve>(&changed)) {
                patch.map = with_curve_along(*polynomial, direction, *curve);
                return patch;
            }
        }
        return tensor_patch(along(placed_tensor(patch, limits), direction));
    }
};

}  // namespace blossom::protocol
