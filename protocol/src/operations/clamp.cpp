#include <blossom/core/spline/spline_split.hpp>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer answer_clamp(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    request.finish();
    return answer_of(like(map, dispatch_on_kind<AnyMap>(
                                   map, [&](const BSplineCurve& curve) { return clamped(curve, limits); })));
}

}  // namespace

Operation clamp_operation() {
    return {
        .summary = "Repeat the end knots of a B-spline until it begins and ends with its control points",
        .documentation =
            "The curve and the number of knots that its convention has room for at each end stay the same.",
        .request = {{map_field()}},
        .result = {{map_member("the same B-spline without knots outside its domain")}},
        .example = {"clamp", "--control-points", "0,0; 1,2; 3,3; 5,1", "--knots", "0,1,2,3,4,5", "--degree",
                    "3"},
        .options = with_map_options({}),
        .answer = answer_clamp,
        .render = described_listing,
        .plot = plot_of_maps,
    };
}

}  // namespace blossom::protocol
