// {"shape": {"type": "curve", "surface" or "volume", "count", "data": [{"degree", "knotvector",
// "control_points": {"points", "weights"?}, ...}]}}. Surfaces and volumes have "degree_u", "knotvector_u" and
// "size_u" for each direction. In the list of points v runs fastest, then u, and w slowest.

#include <array>
#include <deque>

#include "foreign_formats.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view geomdl_types[] = {"curve", "surface", "volume"};

/// "degree", or "degree_u" where there are several directions.
std::string geomdl_member(std::string_view name, std::size_t direction, std::size_t directions) {
    if (directions == 1) return std::string(name);
    return std::string(name) + std::array{"_u", "_v", "_w"}[direction];
}

FlatOrder geomdl_order(std::size_t directions) {
    constexpr std::size_t order[] = {1, 0, 2};
    if (directions == 1) return {0};
    return {order, order + directions};
}

NumberPlaces geomdl_places(std::size_t directions) {
    NumberPlaces places{.points = {"control_points", "points"},
                        .weights = {"control_points", "weights"},
                        .order = geomdl_order(directions)};
    for (std::size_t d = 0; d < directions; ++d) {
        places.degrees.push_back({geomdl_member("degree", d, directions)});
        places.knots.push_back({geomdl_member("knotvector", d, directions)});
        if (directions > 1) places.sizes.push_back({geomdl_member("size", d, directions)});
    }
    return places;
}

/// Errors: `missing_field` for a rational spline without weights; `wrong_kind` for a polynomial one with
/// weights.
void require_kind(Fields& fields, bool weighted) {
    const bool rational = fields.optional("rational", read_boolean).value_or(weighted);
    if (rational == weighted) return;
    if (rational) {
        throw Error(ErrorCode::missing_field,
                    "the document says that the spline is rational, and its weights are missing",
                    {"control_points", "weights"});
    }
    throw Error(ErrorCode::wrong_kind,
                "the spline has weights, and the document says that it is not rational", {"rational"});
}

ForeignSpline read_geomdl_spline(const Json& data, std::size_t directions, const Limits& limits) {
    std::deque<std::string> names;  // to which the fields refer
    Fields fields(data);
    const auto each = [&](std::string_view name, const auto& read) {
        std::vector<std::invoke_result_t<decltype(read), const Json&>> list;
        for (std::size_t d = 0; d < directions; ++d) {
            names.push_back(geomdl_member(name, d, directions));
            list.push_back(fields.required(names.back(), read));
        }
        return list;
    };
    const auto count = [&](const Json& value) { return read_count(value, limits); };
    const auto size = [&](const Json& value) { return read_index(value, limits); };
    SplineNumbers numbers;
    numbers.degrees = each("degree", count);
    numbers.knots = each("knotvector", read_doubles);
    if (directions > 1) numbers.counts = each("size", size);
    numbers.points = fields.required("control_points", [&](const Json& value) {
        Fields inner(value);
        numbers.weights = inner.optional("weights", read_weight_list);
        return inner.required("points", read_rows);
    });
    require_kind(fields, numbers.weights.has_value());
    if (!numbers.points.empty())
        require_stated(fields, "dimension", numbers.points.front().size(), "coordinates");
    if (fields.has("trims")) {
        throw Error(ErrorCode::wrong_kind, "a surface with trim curves is only read without them",
                    Place{"trims"});
    }
    return foreign_spline(std::move(numbers), geomdl_places(directions));
}

std::vector<ForeignSpline> read_geomdl(const Json& document, Floats, const Limits& limits) {
    Fields fields(document);
    const auto read_shape = [&](const Json& value) {
        Fields shape(value);
        const std::size_t directions = 1 + shape.required("type", [](const Json& type) {
            return read_alternative(type, geomdl_types, "a type");
        });
        auto splines = shape.required("data", [&](const Json& data) {
            return read_list(
                data, [&](const Json& spline) { return read_geomdl_spline(spline, directions, limits); });
        });
        require_stated(shape, "count", splines.size(), "splines");
        return splines;
    };
    std::vector<ForeignSpline> splines = fields.required("shape", read_shape);
    for (std::size_t i = 0; i < splines.size(); ++i) splines[i].places.document = {"shape", "data", i};
    return splines;
}

Json write_geomdl(const std::vector<Map>& splines) {
    const std::size_t directions = splines.empty() ? 1 : knots_of(splines.front()).size();
    if (directions > std::size(geomdl_types)) {
        throw Error(ErrorCode::wrong_kind, "geomdl has curves, surfaces and volumes, and this map has " +
                                               std::to_string(directions) + " directions");
    }
    Json::Array data;
    for (const Map& map : splines) {
        if (knots_of(map).size() != directions) {
            throw Error(ErrorCode::wrong_kind,
                        "a file of geomdl has only curves, only surfaces or only volumes");
        }
        WrittenSpline written = written_spline(map, geomdl_order(directions));
        Json spline = Json::Object{
            {"type", "spline"}, {"rational", !written.weights.empty()}, {"dimension", written.dimension}};
        const auto write_each = [&](std::string_view name, const auto& values) {
            for (std::size_t d = 0; d < directions; ++d)
                spline[geomdl_member(name, d, directions)] = values[d];
        };
        write_each("degree", written.degrees);
        write_each("knotvector", written.knots);
        if (directions > 1) write_each("size", written.counts);
        Json control_points = Json::Object{{"points", std::move(written.points)}};
        if (!written.weights.empty()) control_points["weights"] = std::move(written.weights);
        spline["control_points"] = std::move(control_points);
        data.push_back(std::move(spline));
    }
    return Json::Object{{"shape", Json::Object{{"type", geomdl_types[directions - 1]},
                                               {"count", splines.size()},
                                               {"data", std::move(data)}}}};
}

}  // namespace

constinit const ForeignFormat geomdl_format{
    .name = "geomdl", .read = read_geomdl, .write = write_geomdl, .weights = true};

}  // namespace blossom::protocol
