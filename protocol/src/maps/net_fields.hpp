#pragma once

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

/// The points of a net in order, all of the form of the first.
class NetPoints {
public:
    explicit NetPoints(const Limits& limits) : limits_(limits) {}

    /// Errors: `mismatched_dimensions` for a point of another form.
    void add(const Json& value);
    Points finish() && { return {std::move(points_), scalar_}; }

private:
    const Limits& limits_;
    std::vector<Coordinates> points_;
    bool scalar_ = true;
};

/// Multiplies a point by its weight and appends that. Errors: `zero_weight`.
void append_weight(Coordinates& point, const Rational& weight);

/// Errors: `wrong_kind` for "weights" beside "homogeneous".
void refuse_weights(const Fields& fields);

/// The points and their form; visit(value, leaf) goes through a net in order.
template <class Visit>
WeightedPoints read_net(Fields& fields, const Limits& limits, const Visit& visit) {
    Points points = fields.required("control_net", [&](const Json& value) {
        NetPoints read(limits);
        visit(value, [&](const Json& leaf) { read.add(leaf); });
        return std::move(read).finish();
    });
    PointForm form{.scalar = points.scalar};
    if (read_homogeneous(fields)) {
        form = within("control_net", [&] { return homogeneous_form(points); });
        refuse_weights(fields);
        return {std::move(points.points), form};
    }
    std::size_t place = 0;
    const auto read_weights = [&](const Json& value) {
        visit(value,
              [&](const Json& leaf) { append_weight(points.points[place++], read_number(leaf, limits)); });
        return true;
    };
    form.rational = fields.optional("weights", read_weights).value_or(false);
    return {std::move(points.points), form};
}

/// Writes the same fields; arrange(values) puts a list in the form of the net.
template <class Arrange>
void write_net(Json& map, std::span<const Coordinates> points, const PointForm& form,
               const Arrange& arrange) {
    Json::Array written, weights;
    for (const Coordinates& point : points) {
        written.push_back(to_json(point, form));
        if (form.separate_weights()) weights.emplace_back(point.back());
    }
    map["control_net"] = arrange(written);
    if (form.separate_weights()) map["weights"] = arrange(weights);
    if (form.homogeneous) map["homogeneous"] = true;
}

/// leaf(value) for every entry of nested arrays with counts[d] elements on level d; `rule(d, count)` is what
/// a message says of another number.
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

/// Field "degrees", one a direction. Errors: `wrong_arity` for none.
std::vector<std::size_t> read_degrees_of_directions(Fields& fields, const Limits& limits);

/// The values in order, as nested arrays with counts[d] elements on level d.
Json nested(std::span<const Json> values, std::span<const std::size_t> counts);

}  // namespace blossom::protocol
