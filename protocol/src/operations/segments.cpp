#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct Segments {
    const Limits& limits;

    std::vector<AnyMap> operator()(const BSplineCurve& curve) const {
        require_numbers(curve.knots().spans().size() * (curve.degree() + 1), curve.dimension(), limits);
        const std::vector<BezierCurve> segments = bezier_segments(curve, limits);
        return {segments.begin(), segments.end()};
    }
    std::vector<AnyMap> operator()(const TensorBSpline& spline) const {
        std::vector<AnyMap> segments;
        for (const auto& spans : boxes_of(spline, limits))
            segments.emplace_back(segment(spline, spans, limits));
        return segments;
    }
};

Answer answer_segments(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    request.finish();
    return answer_of(like(map, dispatch_on_kind<std::vector<AnyMap>>(map, Segments{limits})));
}

}  // namespace

Operation segments_operation() {
    return {
        .summary = "Split a B-spline into its Bezier curves",
        .documentation = "There is one for each non-empty span of the knots.",
        .request = {{map_field()}},
        .result = {{maps_member("the Bezier curves or patches in their order")}},
        .example = {"segments", "--control-points", "0,0; 1,2; 3,3; 5,1", "--knots", "0,0,0,1,2,2,2",
                    "--degree", "2"},
        .options = with_map_options({}),
        .answer = answer_segments,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
