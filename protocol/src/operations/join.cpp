#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/nurbs/rational_join.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <algorithm>

#include "along_direction.hpp"
#include "listing.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// A curve by its polynomials, over its own interval.
struct PiecesOf {
    const Limits& limits;

    std::vector<BezierCurve> operator()(const OnePolynomial auto& curve) const {
        return {control_points(polynomial_map(curve, limits), interval_of(curve), limits)};
    }
    std::vector<BezierCurve> operator()(const BSplineCurve& curve) const {
        return bezier_segments(curve, limits);
    }
};

std::vector<std::vector<BezierCurve>> pieces_of(const std::vector<Map>& maps, const Limits& limits) {
    std::vector<std::vector<BezierCurve>> pieces;
    pieces.reserve(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Place place = Place{"maps"} / i;
        pieces.push_back(dispatch_on_kind<std::vector<BezierCurve>>(maps[i], PiecesOf{limits}, place));
    }
    return pieces;
}

/// Tensor products as splines.
struct TensorOf {
    const Limits& limits;

    TensorBSpline operator()(const TensorBSpline& spline) const { return spline; }
    TensorBSpline operator()(const Patch& patch) const {
        return bspline_of(placed_tensor(patch, limits), limits);
    }
};

std::vector<TensorBSpline> tensors_of(const std::vector<Map>& maps, const Limits& limits) {
    std::vector<TensorBSpline> tensors;
    tensors.reserve(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Place place = Place{"maps"} / i;
        tensors.push_back(dispatch_on_kind<TensorBSpline>(maps[i], TensorOf{limits}, place));
    }
    return tensors;
}

std::vector<std::vector<BezierCurve>> pieces_along(const std::vector<TensorBSpline>& tensors,
                                                   std::size_t direction, const Limits& limits) {
    std::vector<std::vector<BezierCurve>> pieces;
    pieces.reserve(tensors.size());
    for (const TensorBSpline& tensor : tensors)
        pieces.push_back(bezier_segments(curve_along(tensor, direction), limits));
    return pieces;
}

std::size_t greatest_degree(std::span<const std::vector<BezierCurve>> maps) {
    std::size_t greatest = 0;
    for (const auto& pieces : maps) {
        for (const BezierCurve& piece : pieces) greatest = std::max(greatest, piece.degree());
    }
    return greatest;
}

/// From the beginning of the first curve to the end of the last.
Interval covered(std::span<const std::vector<BezierCurve>> maps) {
    return within("maps", [&] {
        return Interval(blossom::covered(maps.front()).a(), blossom::covered(maps.back()).b());
    });
}

/// Runs `action`; an error in what a map leaves out, as its interval, is in this map.
template <class Action>
auto at_given_part(const Json& maps, const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        if (!error.place().begins_with(Part::maps)) throw;
        throw error.at(Place(Part::maps).around(present_part(maps, error.place().inside(Part::maps))));
    }
}

Answer answer_join(Request& request, const Limits& limits) {
    std::vector<Map> maps = read_maps_field(request, limits);
    const Json& given = *request.required("maps", [](const Json& value) { return &value; });
    const auto knots =
        request.optional("knots", [&](const Json& value) { return read_numbers(value, limits); });
    const auto degree =
        request.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    const bool chain = request.optional("chain", read_boolean).value_or(false);
    if (maps.empty()) throw Error(ErrorCode::wrong_arity, "at least one map is needed", Place{"maps"});
    const auto direction = require_direction(request, maps.front(), limits);
    request.finish();
    if (degree && !knots) {
        throw Error(ErrorCode::wrong_kind, "the degree is that of given knots, and none are given",
                    Place{"degree"});
    }
    make_form_common(maps, limits);
    std::vector<TensorBSpline> tensors;
    if (direction)
        tensors = at_given_part(
            given, [&] { return with_common_knots(tensors_of(maps, limits), *direction, limits); });
    auto pieces = direction ? pieces_along(tensors, *direction, limits) : pieces_of(maps, limits);
    if (chain) pieces = chained(std::move(pieces));
    const bool divided = maps.front().form.separate_weights();
    const BSplineCurve spline = at_given_part(given, [&] {
        if (!knots) return divided ? rational_join(pieces, limits) : join(pieces, limits);
        const KnotVector over = knots_over(degree.value_or(greatest_degree(pieces)), *knots, covered(pieces));
        if (direction) {
            const std::size_t rows = pieces.front().front().dimension() / tensors.front().dimension();
            return divided ? rational_join_rows(pieces, rows, over, limits)
                           : join_rows(pieces, rows, over, limits);
        }
        return divided ? rational_join(pieces, over, limits) : join(pieces, over, limits);
    });
    if (direction)
        return answer_of(like(maps.front(), with_curve_along(tensors.front(), *direction, spline)), "maps");
    return answer_of(like(maps.front(), spline), "maps");
}

}  // namespace

Operation join_operation() {
    return {
        .summary = "Join curves, splines or tensor products on adjacent intervals to a B-spline",
        .documentation =
            "There are as few knots as the curves allow; rational curves are scaled to have common weights.",
        .request = {{maps_field("the curves and splines; a curve without an interval is over [0, 1]"),
                     optional("chain", ValueKind::boolean,
                              "whether each interval is moved to begin where the last ends"),
                     optional(
                         "knots", numbers_shape(),
                         "the knots of the spline, for which the curves must be smooth enough; by default "
                         "as few as they allow"),
                     optional("degree", ValueKind::count,
                              "the degree of the spline; by default the greatest degree of the curves"),
                     direction_field("of tensor products: the direction in which they are adjacent")}},
        .result = {{map_member("the B-spline")}},
        .example = {"join", R"({"kind": "bezier", "control_points": [0, 1, 4], "interval": [0, 1]})",
                    R"({"kind": "bezier", "control_points": [4, 7, 9], "interval": [1, 2]})"},
        .options = {maps_option("MAP",
                                "the curves, as maps of the protocol, lists of them, or the output of "
                                "'segments --json'"),
                    flag_option("--chain", "chain"),
                    field_option("--knots", "knots", "T0,T1,...", number_list),
                    field_option("--degree", "degree", "N", count), direction_option()},
        .answer = answer_join,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
