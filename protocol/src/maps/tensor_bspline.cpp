// The kind bspline in several directions.

#include <fmt/format.h>

#include "kind.hpp"
#include "net_fields.hpp"
#include "text/readable.hpp"

namespace blossom::protocol {

namespace {

std::string rule_of(std::size_t count, std::size_t needed) {
    return fmt::format("there are {} entries here, where the first list of this level has {}", count, needed);
}

std::vector<KnotVector> read_knot_vectors(Fields& fields, const std::vector<std::size_t>& degrees,
                                          const std::vector<std::size_t>& counts, const Limits& limits) {
    return fields.required("knots", [&](const Json& value) {
        std::size_t direction = 0;
        return read_each_direction(value, degrees.size(), "lists of knots", [&](const Json& list) {
            const std::size_t d = direction++;
            std::vector<Rational> numbers = read_numbers(list, limits);
            return as_parameter(Part::knots,
                                [&] { return KnotVector(degrees[d], std::move(numbers), counts[d]); });
        });
    });
}

/// {"kind": "bspline", "degrees", "knots", "control_net", "weights"?, "homogeneous"?}
Map read_tensor_bspline(Fields& fields, const Limits& limits) {
    const std::vector<std::size_t> degrees = read_degrees_of_directions(fields, limits);
    const auto counts = fields.required(
        "control_net", [&](const Json& value) { return counts_of_nested(value, degrees.size()); });
    std::vector<KnotVector> knots = read_knot_vectors(fields, degrees, counts, limits);
    const auto visit = [&](const Json& value, const auto& leaf) {
        visit_nested(value, counts, leaf,
                     [&](std::size_t level, std::size_t count) { return rule_of(count, counts[level]); });
    };
    const WeightedPoints read = read_net(fields, limits, visit);
    require_numbers(read.points.size(), read.points.dimension, limits);
    return {TensorBSpline(std::move(knots), read.points.list()), read.form};
}

Json write(const TensorBSpline& spline, const PointForm& form) {
    Json::Array degrees, knots;
    std::vector<std::size_t> counts;
    for (const KnotVector& own : spline.knots()) {
        degrees.emplace_back(own.degree());
        knots.emplace_back(Json::Array(own.knots().begin(), own.knots().end()));
        counts.push_back(own.points());
    }
    Json map =
        Json::Object{{"kind", "bspline"}, {"degrees", std::move(degrees)}, {"knots", std::move(knots)}};
    write_points(map, "control_net", spline.control_points(), form,
                 [&](std::span<const Json> values) { return nested(values, counts); });
    return map;
}

std::string formula(const TensorBSpline& spline, const Map&, std::string_view name) {
    std::string degrees, domain, counts;
    for (const KnotVector& knots : spline.knots()) {
        const bool first = degrees.empty();
        degrees += fmt::format("{}{}", first ? "" : ", ", knots.degree());
        domain += fmt::format("{}[{}, {}]", first ? "" : " x ", to_string(knots.domain().a()),
                              to_string(knots.domain().b()));
        counts += fmt::format("{}{}", first ? "" : " x ", knots.points());
    }
    return fmt::format("{}: tensor product of B-splines of degree{} {} over {}, {} control points", name,
                       spline.directions() == 1 ? "" : "s", degrees, domain, counts);
}

Members tensor_bspline_members() {
    return {
        {required("degrees", Shape::list(ValueKind::count), "one degree per direction"),
         required("knots", Shape::list(Shape::list(ValueKind::number)),
                  "one list of knots per direction, each in one of the conventions of [bspline](#bspline)"),
         required("control_net", ValueKind::nested_points, "one level of lists per direction")},
        {weights_or_homogeneous(ValueKind::nested_points)}};
}

}  // namespace

constinit const Kind tensor_bspline_kind{
    .name = "bspline in several directions",
    .words = {{{"bspline", read_tensor_bspline, tensor_bspline_members, "A tensor product of B-splines.",
                "degrees"}}},
    .write = write_value<TensorBSpline, write>,
    .formula = formula_of_value<TensorBSpline, formula>,
};

}  // namespace blossom::protocol
