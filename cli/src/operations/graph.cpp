#include "maps/graph.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "svg/plot.hpp"
#include "table.hpp"

namespace blossom::cli {

namespace {

Json answer(Fields& request, const Limits& limits) {
    const Map map = read_map_field(request, limits);
    request.finish();
    return Json::Object{{"map", within("map", [&] { return to_json(graph_of(map, limits)); })}};
}

}  // namespace

Operation graph_operation() {
    return {
        .name = "graph",
        .summary = "Compute the curve (t, P(t)) of a map P",
        .example = {"graph", "--control-points", "0; 3; 1"},
        .options = with_map_options({}),
        .answer = answer,
        .render = described_listing,
        .plot = plot_of_result,
    };
}

}  // namespace blossom::cli
