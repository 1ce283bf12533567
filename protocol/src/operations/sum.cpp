#include "common_domain.hpp"
#include "listing.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer answer_sum(Request& request, const Limits& limits) {
    const std::vector<Map> maps = read_maps_field(request, limits);
    const auto factors = request.optional(
        "factors", [&](const Json& value) { return read_each_map(value, maps.size(), "factors", limits); });
    request.finish();
    const CommonMaps given = on_common_domain(maps, limits);
    require_points_alike(given);
    return answer_of(combined_map(given,
                                  linear_combination(factors.value_or(std::vector<Rational>(maps.size(), 1)),
                                                     given.dimension(0)),
                                  given.forms.front().scalar, limits),
                     "maps");
}

}  // namespace

Operation sum_operation() {
    return {
        .summary = "Add maps on one domain, each times a number",
        .documentation = "Splines get the knots of all, and rational maps a common denominator.",
        .request = {{maps_field("the maps, of any kinds on one domain"),
                     optional("factors", numbers_shape(), "one number per map; by default all 1")}},
        .result = {{map_member("the sum")}},
        .example = {"sum", R"({"kind": "bezier", "control_points": [0, 1, 4]})", "t^3", "--factors", "1,-1"},
        .options = {maps_option("MAP",
                                "the maps: polynomials, maps of the protocol, lists of them, or the "
                                "output of other commands"),
                    field_option("--factors", "factors", "C0,C1,...", number_list)},
        .answer = answer_sum,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
