#include <blossom/core/spline/bezier_extraction.hpp>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer segments_of_curve(Fields& request, const Map& map, const Limits& limits) {
    request.finish();
    const auto segments = dispatch_on_kind<std::vector<BezierCurve>>(map, [&](const BSplineCurve& curve) {
        require_numbers(curve.knots().spans().size() * (curve.degree() + 1), curve.dimension(), limits);
        return bezier_segments(curve, limits);
    });
    std::vector<Map> maps;
    maps.reserve(segments.size());
    for (const BezierCurve& segment : segments) maps.push_back(like(map, segment));
    return answer_of(std::move(maps));
}

}  // namespace

Operation segments_operation() {
    return {
        .name = "segments",
        .summary = "Split a B-spline into its Bezier curves",
        .documentation = "There is one for each non-empty span of the knots.",
        .request = {{map_field()}},
        .result = {{maps_member("the Bezier curves or patches in their order")}},
        .example = {"segments", "--control-points", "0,0; 1,2; 3,3; 5,1", "--knots", "0,0,0,1,2,2,2",
                    "--degree", "2"},
        .options = with_map_options({}),
        .answer = answer_by_shape<segments_of_curve, nullptr, segments_of_tensor_bspline>,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
