#include <blossom/core/spline/spline_reparametrisation.hpp>

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

struct Reparametrise {
    std::optional<Interval> from;
    const Interval& to;
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        return std::visit([&](const auto& one) -> AnyMap { return moved(one); },
                          polynomial_map(curve, limits));
    }
    AnyMap operator()(const TaylorCurve& curve) const { return moved(curve); }
    AnyMap operator()(const BSplineCurve& curve) const { return moved(curve); }

private:
    template <class Curve>
    Curve moved(const Curve& curve) const {
        return reparametrised(curve, ParameterChange(from.value_or(interval_of(curve)), to), limits);
    }
};

Answer answer_reparametrise(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto read = [&](const Json& value) { return read_interval(value, limits); };
    const Interval to = request.optional("interval", read).value_or(Interval());
    const auto from = request.optional("from", read);
    const auto directions = directions_or_all(read_direction(request, map, limits), map);
    request.finish();
    const Reparametrise change{from, to, limits};
    return answer_of(
        like(map, dispatch_on_kind<AnyMap>(map, AlongDirections<Reparametrise>{change, directions, limits})));
}

}  // namespace

Operation reparametrise_operation() {
    return {
        .summary =
            "Change the parameter of a curve, spline or tensor product so that its interval becomes another",
        .documentation = "Blossom values, and with them control points, stay the same at the new parameters.",
        .request =
            {{map_field(),
              optional("interval", ValueKind::interval,
                       "what the interval becomes, by default [0, 1]; a reversed one reverses the curve"),
              optional("from", ValueKind::interval,
                       "what becomes `interval`; by default the interval of the map, or [0, 1]"),
              direction_field("of a tensor product: the only direction that is changed; by default all")}},
        .result = {{map_member("the same points at other parameters")}},
        .example = {"reparametrise", "--control-points", "0,0; 1,2; 3,3; 5,1", "--knots", "0,1,2,3,4,5",
                    "--degree", "3"},
        .options = with_map_options({
            own_interval_option(
                "the interval of the given control points, by default 0,1, or else what it becomes"),
            field_option("--to", "interval", "A,B", number_list),
            field_option("--from", "from", "A,B", number_list),
            direction_option(),
        }),
        .answer = answer_reparametrise,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
