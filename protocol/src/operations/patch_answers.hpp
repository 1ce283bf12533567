#pragma once

#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "operation.hpp"

/// What the operations answer for maps on products of simplices and in several variables. Each reads the
/// fields of the request besides the map and finishes it.

namespace blossom::protocol {

/// The patch of a map, or nullptr for a curve.
inline const Patch* patch_of(const Map& map) { return std::get_if<Patch>(&map.value); }

/// The B-splines in several directions of a map, or nullptr for any other.
inline const TensorBSpline* tensor_bspline_of(const Map& map) {
    return std::get_if<TensorBSpline>(&map.value);
}

/// Answers by the shape of the map: of a curve, of a patch, and of B-splines in several directions. Where one
/// of the last two is nullptr, the first answers, which refuses the kinds that it does not take.
template <auto of_curve, auto of_patch, auto of_tensor_bspline>
Answer answer_about(Fields& request, const Map& map, const Limits& limits) {
    if constexpr (!std::is_null_pointer_v<decltype(of_patch)>) {
        if (patch_of(map)) return of_patch(request, map, limits);
    }
    if constexpr (!std::is_null_pointer_v<decltype(of_tensor_bspline)>) {
        if (tensor_bspline_of(map)) return of_tensor_bspline(request, map, limits);
    }
    return of_curve(request, map, limits);
}

/// The same of field "map", as the answer of an operation.
template <auto of_curve, auto of_patch, auto of_tensor_bspline>
Answer answer_by_shape(Request& request, const Limits& limits) {
    return answer_about<of_curve, of_patch, of_tensor_bspline>(request, request.map(limits), limits);
}

/// What patches are converted to.
enum class PatchForm { monomial, bspline, bernstein, tensor, simplex };
inline constexpr std::string_view patch_form_names[] = {"monomial", "bspline", "bernstein", "tensor",
                                                        "simplex"};
/// Those that are control nets.
inline constexpr std::span net_form_names = std::span(patch_form_names).last<3>();

/// The patch as a control net with its domain, a polynomial over the unit box or simplex.
Patch as_net(const Patch& patch, const Limits& limits);

Json evaluate_patch(Fields& request, const Map& map, const Limits& limits);
Json blossom_of_patch(Fields& request, const Map& map, const Limits& limits);
Json agree_on_patch(Fields& request, const Map& map, const Limits& limits);
/// "direction" and "order", or "directions"; without "at" the derived map.
Answer derivative_of_patch(Fields& request, const Map& map, const Limits& limits);
/// "vertices" or "intervals", "degree" or "degrees".
Answer control_net_of_patch(Fields& request, const Map& map, const Limits& limits);
/// "to": monomial, bernstein, bspline, tensor or simplex, the last two and bernstein with the fields of a
/// control net.
Answer convert_patch(Fields& request, const Map& map, const Limits& limits);
/// "at": a point of the simplex or "midpoints"; for a tensor product one number or null a direction.
Answer subdivide_patch(Fields& request, const Map& map, const Limits& limits);
/// "by": a number, or one a direction.
Answer elevate_patch(Fields& request, const Map& map, const Limits& limits);
/// Of two patches along what their domains share.
Json continuity_of_patches(Fields& request, std::vector<Map> maps, const Limits& limits);

/// The mixed derivative at a point, of the map divided by its weight where that is asked for. Errors:
/// `zero_weight`, `limit_exceeded`.
Coordinates derivative_value(const Patch& patch, std::span<const PatchPoint> directions, const PatchPoint& at,
                             bool divided, const Limits& limits);

// The same for tensor products of B-splines.

/// The polynomial on a box of spans, over this box.
Patch segment_patch(const TensorBSpline& spline, std::span<const std::size_t> spans, const Limits& limits);
/// That of field "segment", one index of a knot a direction; without it the only one. Errors:
/// `outside_domain` if there is no such span, or if none is named and there are several.
Map chosen_segment(Fields& request, const Map& map, const Limits& limits);

Json evaluate_tensor_bspline(Fields& request, const Map& map, const Limits& limits);
/// As for patches; without "at" in directions along one parameter each.
Answer derivative_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits);
/// "intervals", "degrees": the part over a box, a tensor map where it is one polynomial.
Answer control_net_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits);
/// "knots": one list a direction.
Answer insert_knots_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits);
Answer segments_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits);
/// "at": one number or null a direction.
Answer subdivide_tensor_bspline(Fields& request, const Map& map, const Limits& limits);
/// As for patches, of the polynomial of field "segment"; to bspline it is what it is.
Answer convert_tensor_bspline(Fields& request, const Map& map, const Limits& limits);
/// "by": a number, or one a direction.
Answer elevate_tensor_bspline(Fields& request, const Map& map, const Limits& limits);

/// At a knot of one direction, "at" with null in the others.
Json continuity_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits);

/// The blossom of a patch expanded, for a person.
std::string patch_expansion_text(const Answered& answered);

}  // namespace blossom::protocol
