// The kinds tensor and simplex.

#include <fmt/format.h>

#include <algorithm>

#include "kind.hpp"
#include "net_fields.hpp"
#include "several_variables.hpp"
#include "text/readable.hpp"

namespace blossom::protocol {

namespace {

MultiIndex read_index_of(const Json& value, std::size_t entries, std::size_t degree, const Limits& limits) {
    MultiIndex index = read_list(value, [&](const Json& element) { return read_count(element, limits); });
    std::size_t sum = 0;
    for (const std::size_t entry : index) sum += entry;
    if (index.size() != entries || sum != degree) {
        refuse_net(fmt::format("an index has {} entries of sum {}; this one has {} of sum {}", entries,
                               degree, index.size(), sum));
    }
    return index;
}

std::string index_text(const MultiIndex& index) { return fmt::format("({})", fmt::join(index, ", ")); }

/// Calls leaf(value) for each index in the order of the net. Each index must occur once.
template <class Leaf>
void visit_indexed(const Json& value, std::size_t dimension, std::size_t degree, const Limits& limits,
                   const Leaf& leaf) {
    const Json::Array& entries = read_array(value);
    const std::size_t count = multi_index_count(dimension, degree, limits);
    std::vector<std::size_t> place(count, entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        within(i, [&] {
            const Json::Array& pair = read_array(entries[i]);
            if (pair.size() != 2) refuse_net("an entry of a net is a pair of an index and a value");
            const MultiIndex index =
                within(0, [&] { return read_index_of(pair[0], dimension + 1, degree, limits); });
            std::size_t& known = place[position(index)];
            if (known != entries.size()) {
                refuse_net("the index " + index_text(index) + " occurs twice, first in entry " +
                           std::to_string(known));
            }
            known = i;
        });
    }
    const auto missing = std::ranges::find(place, entries.size());
    if (missing != place.end()) {
        const auto indices = multi_indices(dimension, degree);
        refuse_net("the index " + index_text(indices[static_cast<std::size_t>(missing - place.begin())]) +
                   " is missing");
    }
    for (const std::size_t i : place) {
        within(i, [&] { within(1, [&] { leaf((*entries[i].array())[1]); }); });
    }
}

/// The first index of a net, as it is written.
const Json::Array& first_index(const Json& value) {
    const Json::Array& entries = read_array(value);
    if (entries.empty()) refuse_net("a control net has at least one point");
    return within(std::size_t{0}, [&]() -> const Json::Array& {
        const Json::Array& pair = read_array(entries.front());
        if (pair.empty()) refuse_net("an entry of a net is a pair of an index and a value");
        return within(std::size_t{0}, [&]() -> const Json::Array& {
            const Json::Array* index = pair.front().array();
            if (!index || index->empty()) refuse_net("an entry of a net is a pair of an index and a value");
            return *index;
        });
    });
}

/// Writes one pair of an index and a value per point.
Json indexed(std::span<const Json> values, const SimplexFactor& factor) {
    Json::Array entries;
    std::size_t place = 0;
    for (const MultiIndex& index : multi_indices(factor.dimension, factor.degree)) {
        entries.emplace_back(Json::Array{Json::Array(index.begin(), index.end()), values[place++]});
    }
    return entries;
}

/// One more than the degree in each direction.
std::vector<std::size_t> counts_of(const NetShape& shape) {
    std::vector<std::size_t> counts;
    counts.reserve(shape.factors());
    for (std::size_t f = 0; f < shape.factors(); ++f) counts.push_back(shape.count(f));
    return counts;
}

Json write_tensor(const BezierPatch& patch, const std::vector<BarycentricFrame>& frames,
                  const PointForm& form) {
    const std::vector<std::size_t> degrees = degrees_of(patch.shape());
    Json::Array intervals;
    for (const BarycentricFrame& frame : frames) {
        intervals.emplace_back(Json::Array{frame.vertices()[0][0], frame.vertices()[1][0]});
    }
    Json map = Json::Object{{"kind", "tensor"},
                            {"degrees", Json::Array(degrees.begin(), degrees.end())},
                            {"intervals", std::move(intervals)}};
    write_points(map, "control_net", patch.control_net().to_points(), form,
                 [&](std::span<const Json> values) { return nested(values, counts_of(patch.shape())); });
    return map;
}

Json write_simplex(const BezierPatch& patch, const std::vector<BarycentricFrame>& frames,
                   const PointForm& form) {
    Json map = Json::Object{{"kind", "simplex"}, {"degree", patch.shape()[0].degree}};
    if (!frames.empty()) map["vertices"] = lists_json(frames.front().vertices());
    write_points(map, "control_net", patch.control_net().to_points(), form,
                 [&](std::span<const Json> values) { return indexed(values, patch.shape()[0]); });
    return map;
}

/// {"kind": "tensor", "degrees", "control_net", "intervals"?, "weights"?, "homogeneous"?}
Map read_tensor(Fields& fields, const Limits& limits) {
    const std::vector<std::size_t> degrees = read_degrees_of_directions(fields, limits);
    const NetShape shape = within("degrees", [&] { return NetShape::tensor(degrees, limits); });
    const std::vector<std::size_t> counts = counts_of(shape);
    const auto visit = [&](const Json& value, const auto& leaf) {
        visit_nested(value, counts, leaf, [&](std::size_t level, std::size_t count) {
            return fmt::format("there are {} entries here; degree {} needs {}", count, degrees[level],
                               counts[level]);
        });
    };
    const WeightedPoints read = read_net(fields, limits, visit);
    auto frames = fields.optional(
        "intervals", [&](const Json& value) { return read_intervals(value, degrees.size(), limits); });
    if (!frames) frames.emplace(degrees.size(), BarycentricFrame::standard(1));
    require_numbers(read.points.size(), read.points.dimension, limits);
    return {Patch{BezierPatch(shape, read.points.array()), true, std::move(*frames), {}}, read.form};
}

/// {"kind": "simplex", "degree", "control_net", "vertices"?, "weights"?, "homogeneous"?}
Map read_simplex(Fields& fields, const Limits& limits) {
    const std::size_t degree =
        fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    std::size_t dimension = 0;
    // The first index determines the dimension.
    const auto visit = [&](const Json& value, const auto& leaf) {
        dimension = first_index(value).size() - 1;
        visit_indexed(value, dimension, degree, limits, leaf);
    };
    const WeightedPoints read = read_net(fields, limits, visit);
    std::vector<BarycentricFrame> frames;
    const auto vertices = fields.optional(
        "vertices", [&](const Json& value) { return read_vertices(value, dimension, limits); });
    if (vertices) frames.push_back(*vertices);
    require_numbers(read.points.size(), read.points.dimension, limits);
    return {Patch{BezierPatch(NetShape::simplex(dimension, degree, limits), read.points.array()),
                  false,
                  std::move(frames),
                  {}},
            read.form};
}

Json write(const Patch& patch, const PointForm& form) {
    if (const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map))
        return protocol::write(*polynomial, patch, form);
    const auto& net = std::get<BezierPatch>(patch.map);
    return patch.tensor ? write_tensor(net, patch.frames, form) : write_simplex(net, patch.frames, form);
}

std::string formula(const Patch& patch, const Map& map, std::string_view name) {
    if (const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map))
        return protocol::formula(*polynomial, map, name);
    std::string domain;
    for (const BarycentricFrame& frame : patch.frames) {
        std::string vertices;
        for (const Coordinates& vertex : frame.vertices()) {
            vertices +=
                (vertices.empty() ? "" : ", ") +
                (patch.tensor ? to_string(vertex[0]) : point_text(Json::Array(vertex.begin(), vertex.end())));
        }
        domain += fmt::format("{}[{}]", domain.empty() ? " over " : " x ", vertices);
    }
    const std::vector<std::size_t> degrees = degrees_of(patch.shape());
    return fmt::format("{}: {} patch of degree{} {}{}, {} control points", name,
                       patch.tensor ? "tensor product" : "simplex", degrees.size() == 1 ? "" : "s",
                       fmt::join(degrees, ", "), domain, patch.shape().size());
}

std::string patch_degree(const Map& map) {
    const auto& patch = std::get<Patch>(map.value);
    return patch.is_polynomial() ? ", " + degree_text(patch) : "";
}

Members tensor_members() {
    return {
        {required("degrees", Shape::list(ValueKind::count), "one degree per direction"),
         required("control_net", ValueKind::nested_points,
                  "one level of lists per direction; a list on level d has one element more than the degree "
                  "in direction d"),
         defaulted("intervals", Shape::list(ValueKind::interval),
                   "one interval per direction; by default all `[0, 1]`")},
        {weights_or_homogeneous(ValueKind::nested_points)}};
}

std::string_view patch_name(const Map& map) {
    const auto& patch = std::get<Patch>(map.value);
    if (!patch.center.empty()) return "taylor in several variables";
    if (patch.is_polynomial()) return "polynomial in several variables";
    return patch.tensor ? "tensor" : "simplex";
}

Members simplex_members() {
    const Shape index = Shape::list(ValueKind::count);
    return {
        {required("degree", ValueKind::count, "the degree n"),
         required("control_net", Shape::list(Shape::pair(index, ValueKind::point), 1),
                  "pairs of an index (i_0, ..., i_s) with the sum n and its point, each once, in any order; "
                  "results list them from (n, 0, ..., 0) down"),
         optional("vertices", Shape::list(Shape::list(ValueKind::number)),
                  "the s + 1 vertices, each a list of s numbers; without them, parameters are barycentric "
                  "coordinates, s + 1 numbers with sum 1")},
        {weights_or_homogeneous(Shape::list(Shape::pair(index, ValueKind::number), 1))}};
}

}  // namespace

IndexedPoints read_indexed_points(const Json& value, const Limits& limits) {
    const Json::Array& first = first_index(value);
    SimplexFactor simplex{first.size() - 1, 0};
    within(std::size_t{0}, [&] {
        within(std::size_t{0}, [&] {
            for (std::size_t k = 0; k < first.size(); ++k)
                simplex.degree += within(k, [&] { return read_count(first[k], limits); });
            require_within(simplex.degree, limits.degree, "degree", "the degree");
        });
    });
    Points points;
    visit_indexed(value, simplex.dimension, simplex.degree, limits,
                  [&](const Json& leaf) { read_next_point(leaf, points, limits); });
    return {simplex, std::move(points)};
}

constinit const Kind patch_kind{
    .name = "tensor, simplex, polynomial in several variables",
    .words = {{{"tensor", read_tensor, tensor_members, "A control net over a box."},
               {"simplex", read_simplex, simplex_members, "A control net over a simplex of dimension s."},
               {"polynomial", read_several_variables, members_in_several_variables,
                "A polynomial in several variables.", "variables"},
               {"taylor", read_expansion, expansion_members,
                "A polynomial in several variables by its expansion at a point.", "variables"}}},
    .write = write_value<Patch, write>,
    .formula = formula_of_value<Patch, formula>,
    .degree_text = patch_degree,
    .name_of = patch_name,
};

}  // namespace blossom::protocol
