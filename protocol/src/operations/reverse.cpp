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

/// P(a + b - t) over the same interval [a, b].
struct Reverse {
    const Limits& limits;

    AnyMap operator()(const BezierCurve& curve) const { return seen_from_the_end(turned(curve)); }
    AnyMap operator()(const OnePolynomial auto& curve) const {
        return std::visit(Overloads{[&](const BezierCurve& one) { return (*this)(one); },
                                    [&](const PolynomialCurve& one) -> AnyMap { return turned(one); }},
                          polynomial_map(curve, limits));
    }
    AnyMap operator()(const TaylorCurve& curve) const { return turned(curve); }
    AnyMap operator()(const BSplineCurve& curve) const { return turned(curve); }

private:
    template <class Curve>
    Curve turned(const Curve& curve) const {
        const Interval own = interval_of(curve);
        return reparametrised(curve, ParameterChange(own, {own.b(), own.a()}), limits);
    }
};

Answer answer_reverse(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto directions = directions_or_all(require_direction(request, map, limits), map);
    request.finish();
    const Reverse reverse{limits};
    return answer_of(
        like(map, dispatch_on_kind<AnyMap>(map, AlongDirections<Reverse>{reverse, directions, limits})));
}

}  // namespace

Operation reverse_operation() {
    return {
        .summary = "Reverse the direction of a curve or spline, or a direction of a tensor product",
        .documentation = "The interval stays the same, and is [0, 1] for a map without one.",
        .request = {{map_field(), direction_field("of a tensor product: the direction that is reversed")}},
        .result = {{map_member("the curve that runs from the end to the beginning")}},
        .example = {"reverse", "--control-points", "0,0; 1,2; 3,0; 4,0", "--knots", "0,0,0,1,4,4,4",
                    "--degree", "2"},
        .options = with_map_options({direction_option()}),
        .answer = answer_reverse,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
