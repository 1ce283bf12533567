#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/interpolation.hpp>
#include <blossom/core/patch/net_interpolation.hpp>
#include <blossom/core/spline/greville.hpp>
#include <blossom/core/spline/spline_interpolation.hpp>

#include <algorithm>
#include <optional>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/net_fields.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"
#include "text/shapes.hpp"

namespace blossom::protocol {

namespace {

/// Knots for so many values, which determine their convention.
KnotVector read_knots_of_values(const Json& value, std::size_t degree, std::size_t values,
                                const Limits& limits) {
    std::vector<Rational> knots = read_numbers(value, limits);
    return as_parameter(Part::knots, [&] { return KnotVector(degree, std::move(knots), values); });
}

/// The Greville abscissae as nodes. Errors: `missing_field` where they do not serve as such.
std::vector<Rational> usual_nodes(const KnotVector& knots, std::string_view field) {
    std::vector<Rational> nodes;
    if (knots.degree() > 0) nodes = greville_abscissae(knots);
    const Interval domain = knots.domain();
    if (nodes.empty() || nodes.front() < domain.a() || nodes.back() > domain.b() ||
        std::ranges::adjacent_find(nodes) != nodes.end()) {
        throw Error(
            ErrorCode::missing_field,
            "the Greville abscissae of these knots are not distinct parameters of the domain, so that "
            "the nodes must be given",
            Place{std::string(field)});
    }
    return nodes;
}

/// From the least node to the greatest; [0, 1] if they are equal.
Interval covered_by_nodes(std::span<const Rational> nodes) {
    const auto [least, greatest] = std::ranges::minmax(nodes);
    return least == greatest ? Interval() : Interval(least, greatest);
}

AnyMap spline_through(Fields& request, const Points& values, std::optional<std::vector<Rational>> nodes,
                      const Limits& limits) {
    const std::size_t degree =
        request.required("degree", [&](const Json& value) { return read_count(value, limits); });
    if (values.size() <= degree) {
        throw Error(ErrorCode::wrong_arity,
                    "a spline of degree " + std::to_string(degree) + " needs more than " +
                        std::to_string(degree) + " values, not " + std::to_string(values.size()),
                    Place{"values"});
    }
    const KnotVector knots = request.required("knots", [&](const Json& value) {
        return read_knots_of_values(value, degree, values.size(), limits);
    });
    request.finish();
    if (!nodes) nodes = usual_nodes(knots, "nodes");
    return interpolate(knots, *nodes, values.list(), limits);
}

AnyMap curve_through(Fields& request, const Points& values, std::optional<std::vector<Rational>> nodes,
                     const Limits& limits) {
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    request.finish();
    within("values", [&] { require_degree(values.size(), limits); });
    if (!nodes) nodes = uniform_nodes(interval.value_or(Interval()), values.size() - 1);
    const PolynomialCurve curve = interpolate(*nodes, values.list(), limits);
    return control_points(curve, interval.value_or(covered_by_nodes(*nodes)), limits);
}

Map through_values(Fields& request, const Limits& limits) {
    const Points values =
        request.required("values", [&](const Json& value) { return read_points(value, limits); });
    auto nodes = request.optional("nodes", [&](const Json& value) { return read_numbers(value, limits); });
    const bool spline = request.has("knots") || request.has("degree");
    AnyMap map = spline ? spline_through(request, values, std::move(nodes), limits)
                        : curve_through(request, values, std::move(nodes), limits);
    return {std::move(map), PointForm{.scalar = values.scalar}};
}

/// Values on a grid, and what the request says of its directions.
struct ValueGrid {
    std::vector<std::size_t> counts;
    Points values;
    std::optional<std::vector<std::vector<Rational>>> nodes;
    std::optional<std::vector<std::size_t>> degrees;

    std::size_t directions() const { return counts.size(); }
};

ValueGrid read_value_grid(Fields& request, const Limits& limits) {
    ValueGrid grid;
    grid.nodes = request.optional("grid", [&](const Json& value) {
        return read_list(value, [&](const Json& list) { return read_numbers(list, limits); });
    });
    if (request.has("degrees")) grid.degrees = read_degrees_of_directions(request, limits);
    const std::size_t directions = grid.degrees ? grid.degrees->size() : grid.nodes->size();
    if (directions == 0 || (grid.nodes && grid.nodes->size() != directions)) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(grid.nodes->size()) + " lists of nodes for " + std::to_string(directions) +
                        " directions",
                    Place{"grid"});
    }
    request.required("values", [&](const Json& value) {
        grid.counts = counts_of_nested(value, directions);
        visit_nested(
            value, grid.counts, [&](const Json& leaf) { read_next_point(leaf, grid.values, limits); },
            [&](std::size_t level, std::size_t count) {
                return "there are " + std::to_string(count) +
                       " entries here, where the first list of this level has " +
                       std::to_string(grid.counts[level]);
            });
        return true;
    });
    require_numbers(grid.values.size(), grid.values.dimension, limits);
    for (std::size_t d = 0; grid.nodes && d < directions; ++d) {
        if ((*grid.nodes)[d].size() == grid.counts[d]) continue;
        throw Error(ErrorCode::wrong_arity,
                    std::to_string((*grid.nodes)[d].size()) + " nodes for " + std::to_string(grid.counts[d]) +
                        " values in direction " + std::to_string(d),
                    Place{"grid"} / d);
    }
    return grid;
}

/// The nodes given, or usual(d) in direction d.
template <class Usual>
GridData grid_data(ValueGrid grid, const Usual& usual) {
    if (!grid.nodes) {
        grid.nodes.emplace();
        for (std::size_t d = 0; d < grid.directions(); ++d) grid.nodes->push_back(usual(d));
    }
    return {std::move(*grid.nodes), grid.values.list()};
}

/// An error at the nodes is in the field "grid".
template <class Action>
auto at_grid(const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        if (!error.place().begins_with(Part::nodes)) throw;
        throw error.at(Place{"grid"}.around(error.place().inside(Part::nodes)));
    }
}

AnyMap splines_on_grid(Fields& request, ValueGrid grid, const Limits& limits) {
    if (!grid.degrees) request.missing("degrees");
    const auto knots = request.required("knots", [&](const Json& value) {
        std::size_t direction = 0;
        return read_each_direction(value, grid.directions(), "lists of knots", [&](const Json& list) {
            const std::size_t d = direction++;
            return read_knots_of_values(list, (*grid.degrees)[d], grid.counts[d], limits);
        });
    });
    request.finish();
    const GridData data =
        grid_data(std::move(grid), [&](std::size_t d) { return usual_nodes(knots[d], "grid"); });
    return at_grid([&] { return interpolate(data, knots, limits); });
}

AnyMap polynomial_on_grid(Fields& request, ValueGrid grid, const Limits& limits) {
    const auto intervals = request.optional("intervals", [&](const Json& value) {
        return read_each_direction(value, grid.directions(), "intervals",
                                   [&](const Json& ends) { return read_interval(ends, limits); });
    });
    request.finish();
    for (std::size_t d = 0; grid.degrees && d < grid.directions(); ++d) {
        if (grid.counts[d] == (*grid.degrees)[d] + 1) continue;
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(grid.counts[d]) + " values in direction " + std::to_string(d) +
                        " are not those of degree " + std::to_string((*grid.degrees)[d]),
                    Place{"degrees"} / d);
    }
    const std::vector<std::size_t> counts = grid.counts;
    const GridData data = grid_data(std::move(grid), [&](std::size_t d) {
        return uniform_nodes(intervals ? (*intervals)[d] : Interval(), counts[d] - 1);
    });
    std::vector<Interval> box;
    std::vector<BarycentricFrame> frames;
    for (std::size_t d = 0; d < data.nodes.size(); ++d) {
        box.push_back(intervals ? (*intervals)[d] : covered_by_nodes(data.nodes[d]));
        frames.push_back(BarycentricFrame({{box[d].a()}, {box[d].b()}}));
    }
    return at_grid([&] { return Patch{interpolate(data, box, limits), true, std::move(frames), {}}; });
}

Map on_grid(Fields& request, const Limits& limits) {
    ValueGrid grid = read_value_grid(request, limits);
    const PointForm form{.scalar = grid.values.scalar};
    return {request.has("knots") ? splines_on_grid(request, std::move(grid), limits)
                                 : polynomial_on_grid(request, std::move(grid), limits),
            form};
}

Map on_lattice(Fields& request, const Limits& limits) {
    const IndexedPoints values =
        request.required("lattice", [&](const Json& value) { return read_indexed_points(value, limits); });
    std::vector<BarycentricFrame> frames;
    const auto vertices = request.optional("vertices", [&](const Json& value) {
        return read_vertices(value, values.simplex.dimension, limits);
    });
    request.finish();
    require_numbers(values.points.size(), values.points.dimension, limits);
    if (vertices) frames.push_back(*vertices);
    return {Patch{interpolate_on_lattice(values.simplex, values.points.array(), limits),
                  false,
                  std::move(frames),
                  {}},
            PointForm{.scalar = values.points.scalar}};
}

Answer answer_interpolate(Request& request, const Limits& limits) {
    if (request.has("lattice")) return answer_of(on_lattice(request, limits), "lattice");
    const bool grid = request.has("grid") || request.has("degrees");
    return answer_of(grid ? on_grid(request, limits) : through_values(request, limits), "values");
}

Members interpolate_request() {
    const Field nodes =
        optional("nodes", numbers_shape(),
                 "the nodes; a node that occurs again stands for a derivative of the next "
                 "order. By default uniform in the interval; with `knots`, the Greville abscissae");
    const Field values = required("values", Shape::list(ValueKind::point, 1), "one value per node");
    const Field nested =
        required("values", ValueKind::nested_points, "on a grid: one level of lists per direction");
    const Field grid =
        optional("grid", tuples_shape(), "the nodes of each direction, by default as for curves");
    const Field degrees =
        required("degrees", counts_shape(), "of a tensor product: one degree per direction");
    const Field intervals = optional("intervals", Shape::list(ValueKind::interval),
                                     "the box of the control net; by default from the least to the greatest "
                                     "nodes, [0, 1] without `grid`");
    return {
        {},
        {{{values, nodes,
           optional("interval", ValueKind::interval,
                    "the interval of the control points; by default from the least to the greatest node, "
                    "[0, 1] without `nodes`")},
          {values, nodes, required("degree", ValueKind::count, "the degree of the spline"),
           required("knots", numbers_shape(),
                    "the knots of the spline, in one of the conventions of "
                    "[bspline](#bspline)")},
          {nested, required("grid", tuples_shape(), grid.documentation), intervals},
          {nested, degrees, grid, intervals},
          {nested, degrees, grid, required("knots", tuples_shape(), "the same, one list per direction")},
          {required("lattice", Shape::list(Shape::pair(counts_shape(), ValueKind::point), 1),
                    "instead of values: pairs of an index (i_0, ..., i_s) with the sum n and the value at "
                    "the barycentric coordinates i / n, each once, in any order"),
           optional("vertices", tuples_shape(), "the vertices of the simplex")}}}};
}

}  // namespace

Operation interpolate_operation() {
    return {
        .summary = "Compute the polynomial, spline or patch with given values and derivatives at nodes",
        .documentation = "The result is exact, and is refused where the nodes do not determine it.",
        .request = interpolate_request(),
        .result = {{map_member("the map with its control points")}},
        .example = {"interpolate", "--nodes", "0,1,1,2", "--values", "0; 1; 3; 8"},
        .options = {field_option("--values", "values", "P0;P1;...", number_list,
                                 "one value per node, \"0,0; 1,2; 3,0\", on a grid one row after the other, "
                                 "\"1,2; 3,4\", or JSON"),
                    field_option("--nodes", "nodes", "T0,T1,...", number_list),
                    field_option("--interval", "interval", "A,B", number_list),
                    field_option("--degree", "degree", "N", count),
                    field_option(
                        "--knots", "knots", "T0,T1,...",
                        [](std::string_view text) {
                            return text.find(';') == std::string_view::npos ? number_list(text)
                                                                            : tuple_list(text);
                        },
                        "the knots of the spline, on a grid one list per direction, "
                        "\"0,0,1,1; 0,0,1,1\""),
                    field_option("--grid", "grid", "S0,S1,...;T0,...", tuple_list),
                    field_option("--degrees", "degrees", "M,N,...", number_list),
                    field_option("--intervals", "intervals", "A,B;C,D;...", tuple_list),
                    field_option("--lattice", "lattice", "JSON", number_list),
                    field_option("--vertices", "vertices", "P0;P1;...", tuple_list)},
        .answer = answer_interpolate,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
