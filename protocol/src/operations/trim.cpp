#include <blossom/core/blossom/conversion.hpp>
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

struct Trim {
    const Interval& interval;
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        return control_points(polynomial_map(curve, limits), interval, limits);
    }
    AnyMap operator()(const BSplineCurve& curve) const {
        return within("interval", [&] { return trimmed(curve, interval, limits); });
    }
};

Answer answer_trim(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const Interval interval =
        request.required("interval", [&](const Json& value) { return read_interval(value, limits); });
    const auto directions = directions_or_all(require_direction(request, map, limits), map);
    request.finish();
    const Trim trim{interval, limits};
    return answer_of(
        like(map, dispatch_on_kind<AnyMap>(map, AlongDirections<Trim>{trim, directions, limits})),
        "interval");
}

}  // namespace

Operation trim_operation() {
    return {
        .summary = "Compute the part of a curve, spline or tensor product over an interval",
        .documentation = "A spline is clamped at both ends; any other curve becomes a Bezier curve.",
        .request = {{map_field(),
                     required("interval", ValueKind::interval,
                              "the interval; of a spline an increasing one within its domain"),
                     direction_field("of a tensor product: the direction of the interval")}},
        .result = {{map_member("the part")}},
        .example = {"trim", "--control-points", "0,0; 1,2; 3,3; 5,1", "--knots", "0,1,2,3,4,5", "--degree",
                    "3", "--over", "2,5/2"},
        .options = with_map_options({
            own_interval_option(
                "the interval of the given control points, by default 0,1, or else that of the part"),
            field_option("--over", "interval", "A,B", number_list),
            direction_option(),
        }),
        .answer = answer_trim,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
