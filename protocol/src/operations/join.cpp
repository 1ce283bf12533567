#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <algorithm>

#include "listing.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

std::vector<BezierCurve> bezier_curves(std::vector<Map>& maps, const Limits& limits) {
    make_form_common(maps, limits);
    std::vector<BezierCurve> curves;
    curves.reserve(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        curves.push_back(dispatch_on_kind<BezierCurve>(
            maps[i], [](const BezierCurve& curve) { return curve; }, Place{"maps"} / i));
    }
    return curves;
}

/// From the lower end of the first interval to the upper end of the last.
Interval covered(const std::vector<BezierCurve>& curves) {
    const Interval& first = curves.front().interval();
    const Interval& last = curves.back().interval();
    return within("maps",
                  [&] { return Interval(std::min(first.a(), first.b()), std::max(last.a(), last.b())); });
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
    request.finish();
    const std::vector<BezierCurve> curves = bezier_curves(maps, limits);
    if (curves.empty()) throw Error(ErrorCode::wrong_arity, "at least one map is needed", Place{"maps"});
    const std::size_t greatest = std::ranges::max_element(curves, {}, &BezierCurve::degree)->degree();
    if (degree && !knots) {
        throw Error(ErrorCode::wrong_kind, "the degree is that of given knots, and none are given",
                    Place{"degree"});
    }
    const BSplineCurve spline = at_given_part(given, [&] {
        return knots ? join(curves, knots_over(degree.value_or(greatest), *knots, covered(curves)), limits)
                     : join(curves, limits);
    });
    return answer_of(like(maps.front(), spline), "maps");
}

}  // namespace

Operation join_operation() {
    return {
        .summary = "Join Bezier curves on adjacent intervals to a B-spline",
        .documentation = "Given knots must fit the curves, which must be as smooth as the knots say.",
        .request = {{maps_field("the Bezier curves"),
                     optional("knots", numbers_shape(),
                              "the knots of the spline; by default as few as the curves allow"),
                     optional("degree", ValueKind::count,
                              "the degree of the spline; by default the greatest degree of the curves")}},
        .result = {{map_member("the B-spline")}},
        .example = {"join", R"({"kind": "bezier", "control_points": [0, 1, 4], "interval": [0, 1]})",
                    R"({"kind": "bezier", "control_points": [4, 7, 9], "interval": [1, 2]})"},
        .options = {maps_option("MAP",
                                "the Bezier curves, as maps of the protocol, lists of them, or the output of "
                                "'segments --json'"),
                    field_option("--knots", "knots", "T0,T1,...", number_list),
                    field_option("--degree", "degree", "N", count)},
        .answer = answer_join,
        .render = described_listing,
        .plot = plot_of_result,
    };
}

}  // namespace blossom::protocol
