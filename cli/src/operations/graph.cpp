#include <blossom/core/graph.hpp>

#include "maps/serve.hpp"
#include "operations/listing.hpp"
#include "operations/map_options.hpp"
#include "operations/table.hpp"

namespace blossom::cli {

namespace {

Json answer(Fields& request, const Limits& limits) {
    const Map map = read_map_field(request, limits);
    request.finish();
    const GraphForm form = map.form.rational ? GraphForm::homogeneous : GraphForm::points;
    const auto of_curve = [&](const OnePolynomial auto& curve) -> AnyMap {
        const auto one = [&](const auto& single) -> AnyMap { return graph(single, form, limits); };
        return std::visit(one, polynomial_map(curve, limits));
    };
    const auto of_spline = [&](const BSplineCurve& curve) -> AnyMap { return graph(curve, form, limits); };
    PointForm of_points = map.form;
    of_points.scalar = false;
    const Map drawn{serve<AnyMap>(map, Overloads{of_curve, of_spline}), of_points, map.variable};
    return Json::Object{{"map", within("map", [&] { return to_json(drawn); })}};
}

}  // namespace

Operation graph_operation() {
    return {
        .name = "graph",
        .summary = "The curve (t, P(t)) of a map P",
        .example = {"graph", "--control-points", "0; 3; 1"},
        .options = with_map_options({}),
        .answer = answer,
        .render = described_listing,
    };
}

}  // namespace blossom::cli
