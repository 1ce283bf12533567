#include <fmt/format.h>
#include <blossom/core/blossom/inverse_formula.hpp>

#include "map_options.hpp"
#include "maps/patch.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Json of_simplex(Fields& request, std::size_t degree, const Limits& limits) {
    const BarycentricFrame frame =
        request.required("vertices", [&](const Json& value) { return read_vertices(value, limits); });
    request.finish();
    const SimplexInverseFormula formula = inverse_formula({frame.dimension(), degree}, limits);
    std::vector<Coordinates> nodes;
    nodes.reserve(formula.nodes.size());
    for (const Coordinates& node : formula.nodes) nodes.push_back(frame.combination(node));
    return Json::Object{{"nodes", lists_json(nodes)},
                        {"weights", lists_json(formula.weights)},
                        {"indices", lists_json(multi_indices(frame.dimension(), degree))}};
}

Answer answer_inverse_formula(Request& request, const Limits& limits) {
    const std::size_t degree =
        request.required("degree", [&](const Json& value) { return read_count(value, limits); });
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    if (interval && request.has("vertices")) {
        throw Error(ErrorCode::wrong_kind,
                    R"(the formula is over an "interval" or over "vertices", not over both)",
                    Place{"interval"});
    }
    if (request.has("vertices")) return of_simplex(request, degree, limits);
    request.finish();
    InverseFormula formula = inverse_formula(degree, interval.value_or(Interval()), limits);
    return Json::Object{{"nodes", Json::Array(formula.nodes.begin(), formula.nodes.end())},
                        {"weights", lists_json(formula.weights)}};
}

std::string render_inverse_formula(const Answered& answered) {
    std::vector<std::vector<std::string>> rows{{""}};
    for (std::string& node : member_texts(answered.result(), "nodes"))
        rows.front().push_back(std::move(node));
    const Json::Array& weights = *answered.result().find("weights")->array();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Json* indices = answered.result().find("indices");
        rows.push_back({indices ? "P" + point_text((*indices->array())[i]) : fmt::format("P{}", i)});
        for (const Json& weight : *weights[i].array()) rows.back().push_back(point_text(weight));
    }
    return "Each control point is the sum of the map's values at the nodes in the first line, times the "
           "weights in its own:\n\n" +
           table_text(rows);
}

}  // namespace

Operation inverse_formula_operation() {
    return {
        .summary = "Compute the weights that turn values of a map into control points",
        .documentation = "The formula is exact for maps up to its degree.",
        .request = {{required("degree", ValueKind::count, "the degree")},
                    {{{optional("interval", ValueKind::interval, "the interval; by default [0, 1]")},
                      {required("vertices", tuples_shape(),
                                "instead of an interval: the vertices of a simplex")}}}},
        .result = {{required("nodes", Shape::list(ValueKind::point),
                             "where the values of the map are needed"),
                    required("weights", tuples_shape(),
                             "for each control point the weight of the value at each node"),
                    optional("indices", Shape::list(counts_shape()),
                             "of a simplex: the index of the control point of each row of weights")}},
        .example = {"inverse-formula", "--degree", "3"},
        .options = {field_option("--degree", "degree", "N", count),
                    field_option("--interval", "interval", "A,B", number_list,
                                 "the interval; by default 0,1"),
                    field_option("--vertices", "vertices", "P0;P1;...", tuple_list)},
        .answer = answer_inverse_formula,
        .render = render_inverse_formula,
    };
}

}  // namespace blossom::protocol
