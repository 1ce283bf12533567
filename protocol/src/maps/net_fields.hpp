#pragma once

#include <blossom/rational/net_sums.hpp>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "json/fields.hpp"
#include "points.hpp"

/// The fields of a control net: "control_net", "weights" and "homogeneous".

namespace blossom::protocol {

/// Throws `incomplete_net`.
[[noreturn]] void refuse_net(const std::string& message);

/// The points and their form; visit(value, leaf) goes through a net in order.
template <class Visit>
WeightedPoints read_net(Fields& fields, const Limits& limits, const Visit& visit) {
    Points points = fields.required("control_net", [&](const Json& value) {
        Points read;
        visit(value, [&](const Json& leaf) { read_next_point(leaf, read, limits); });
        return read;
    });
    PointForm form{.scalar = points.scalar};
    if (read_homogeneous(fields)) {
        form = within("control_net", [&] { return homogeneous_form(points); });
        refuse_weights(fields);
        return {std::move(points), form};
    }
    const auto weights = fields.optional("weights", [&](const Json& value) {
        std::vector<Rational> read;
        visit(value, [&](const Json& leaf) { read.push_back(read_weight(leaf, limits)); });
        return read;
    });
    if (weights) {
        form.rational = true;
        append_weights(points, *weights);
    }
    return {std::move(points), form};
}

/// Calls leaf(value) for each entry of nested arrays with counts[d] elements on level d; `rule(d, count)` is
/// the text of the error for another number.
template <class Leaf, class Rule>
void visit_nested(const Json& value, std::span<const std::size_t> counts, const Leaf& leaf, const Rule& rule,
                  std::size_t level = 0) {
    if (level == counts.size()) {
        leaf(value);
        return;
    }
    const Json::Array& elements = read_array(value);
    if (elements.size() != counts[level]) refuse_net(rule(level, elements.size()));
    for (std::size_t i = 0; i < elements.size(); ++i) {
        within(i, [&] { visit_nested(elements[i], counts, leaf, rule, level + 1); });
    }
}

/// The points of a net over a simplex, in the order of the net.
struct IndexedPoints {
    SimplexFactor simplex;
    Points points;
};
/// Reads pairs of an index and a point, each index once; the first determines the dimension and the degree.
/// Errors: `incomplete_net`.
IndexedPoints read_indexed_points(const Json& value, const Limits& limits);

/// The length of the first of the nested arrays on each level.
std::vector<std::size_t> counts_of_nested(const Json& value, std::size_t levels);

/// Field "degrees", one per direction. Errors: `wrong_arity` for none.
std::vector<std::size_t> read_degrees_of_directions(Fields& fields, const Limits& limits);

/// The values in order, as nested arrays with counts[d] elements on level d.
Json nested(std::span<const Json> values, std::span<const std::size_t> counts);

}  // namespace blossom::protocol
