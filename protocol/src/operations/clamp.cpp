#include <blossom/core/spline/spline_split.hpp>

#include "along_direction.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct Clamp {
    const Limits& limits;

    AnyMap operator()(const BSplineCurve& curve) const { return clamped(curve, limits); }
};

Answer answer_clamp(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto directions = directions_or_all(read_direction(request, map, limits), map);
    request.finish();
    const Clamp clamp{limits};
    return answer_of(
        like(map, dispatch_on_kind<AnyMap>(map, AlongDirections<Clamp>{clamp, directions, limits})));
}

}  // namespace

Operation clamp_operation() {
    return {
        .summary = "Repeat the end knots of a B-spline until it begins and ends with its control points",
        .documentation =
            "The curve and the number of knots that its convention has room for at each end stay the same.",
        .request = {{map_field(),
                     direction_field(
                         "of a tensor product: the only direction that is clamped; by default all")}},
        .result = {{map_member("the same B-spline without knots outside its domain")}},
        .example = {"clamp", "--control-points", "0,0; 1,2; 3,3; 5,1", "--knots", "0,1,2,3,4,5", "--degree",
                    "3"},
        .options = with_map_options({direction_option()}),
        .answer = answer_clamp,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
