#include <blossom/core/blossom/polar.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>

#include "blossom_arguments.hpp"
#include "common_domain.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The segment of a B-spline, or any other map.
struct OneSegment {
    Fields& request;
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const { return curve; }
    AnyMap operator()(const Samples& samples) const { return samples; }
    AnyMap operator()(const Patch& patch) const { return patch; }
    AnyMap operator()(const BSplineCurve& curve) const {
        return sablonniere(curve, chosen_span(curve, read_span(request, limits)), limits);
    }
    AnyMap operator()(const TensorBSpline& spline) const { return read_segment(request, spline, limits); }
};

PatchArguments read_polar_arguments(const Json& value, const Patch& patch, bool is_curve,
                                    const Limits& limits) {
    // A vector is an argument of a polar of a rational map, too, because others remain.
    const PointForm form;
    if (!is_curve) return read_arguments(value, patch, form, limits);
    std::vector<Coordinates> list;
    for (const Argument& argument : read_arguments(value, form, limits))
        list.push_back(engine_argument(patch, 0, std::span(&argument.u, 1), argument.mass));
    return {std::move(list)};
}

Answer answer_polar(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const Map segment = like(map, dispatch_on_kind<AnyMap>(map, OneSegment{request, limits}));
    const CommonMaps given = on_own_domain(segment, limits);
    Patch patch = patch_of(given);
    patch.tensor = patch.tensor && !given.are_curves;  // with one list of arguments
    const PatchArguments arguments = request.required("arguments", [&](const Json& value) {
        return read_polar_arguments(value, patch, given.are_curves, limits);
    });
    request.finish();
    const auto take = [&](const auto& one) -> CommonMap { return polar(one, arguments, limits); };
    return at_arguments(patch,
                        [&] { return answer_of(map_of(given, std::visit(take, patch.map), map.form)); });
}

}  // namespace

Operation polar_operation() {
    return {
        .summary = "Fix some arguments of the blossom of a map: a map of lower degree",
        .documentation = "A polar takes fewer arguments than the blossom, and is a map in those that remain.",
        .request = {{map_field(),
                     arguments_field(Presence::required,
                                     "the arguments that are fixed, at most as many as the formal degree"),
                     segment_field()}},
        .result = {{map_member("the polar")}},
        .example = {"polar", "--control-points", "0,0; 1,2; 3,2; 4,0", "--at", "1/2"},
        .options = with_map_options({
            arguments_option(
                "the arguments that are fixed, at most as many as the formal degree: T, vector:V, delta, "
                "pair:U:MASS"),
            segment_option(),
        }),
        .answer = answer_polar,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
