#include "maps/graph.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer answer_graph(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    request.finish();
    return answer_of(within("map", [&] { return graph_of(map, limits); }));
}

}  // namespace

Operation graph_operation() {
    return {
        .summary = "Compute the map (t, P(t)) of a map P",
        .documentation = "The parameter, or each of its coordinates, is added in front.",
        .request = {{map_field()}},
        .result = {{map_member("the graph")}},
        .example = {"graph", "--control-points", "0; 3; 1"},
        .options = with_map_options({}),
        .answer = answer_graph,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
