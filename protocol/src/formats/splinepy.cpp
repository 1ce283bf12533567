// {"Name", "NumberOfSplines", "Base64Encoding", "SplineList": [{"SplineType", "degrees": [n, ...],
// "knot_vectors": [[...], ...], "control_points": [[...], ...], "weights"?: [[w], ...], "dim", "para_dim"}]};
// the Bezier types have no knots. In the list of points the first direction runs fastest.

#include <algorithm>

#include "foreign_formats.hpp"

namespace blossom::protocol {

namespace {

/// Errors: `missing_field`, `wrong_kind` unless the spline has the members of its type.
void require_type(Fields& fields) {
    struct Type {
        std::string_view name;
        bool knots;
        bool weights;
    };
    constexpr Type types[] = {{"Bezier", false, false},
                              {"RationalBezier", false, true},
                              {"BSpline", true, false},
                              {"NURBS", true, true}};
    const auto name =
        fields.optional("SplineType", [](const Json& value) -> std::string { return read_text(value); });
    if (!name) return;
    const auto type = std::ranges::find(types, *name, &Type::name);
    if (type == std::end(types)) {
        throw Error(
            ErrorCode::wrong_kind,
            "the types of splinepy are Bezier, RationalBezier, BSpline and NURBS, and this is " + *name,
            Place{"SplineType"});
    }
    for (const auto& [member, wanted] :
         {std::pair{"knot_vectors", type->knots}, {"weights", type->weights}}) {
        if (fields.has(member) == wanted) continue;
        throw Error(wanted ? ErrorCode::missing_field : ErrorCode::wrong_kind,
                    "a spline of type " + *name + " has " + (wanted ? "" : "no ") + member, Place{member});
    }
}

NumberPlaces splinepy_places(std::size_t directions) {
    NumberPlaces places{
        .points = {"control_points"}, .weights = {"weights"}, .order = first_fastest(directions)};
    for (std::size_t d = 0; d < directions; ++d) {
        places.degrees.push_back(Place{"degrees"} / d);
        places.knots.push_back(Place{"knot_vectors"} / d);
    }
    return places;
}

/// The knots of a Bezier spline, which a document leaves out.
std::vector<std::vector<Rational>> bezier_knots(std::span<const std::size_t> degrees) {
    std::vector<std::vector<Rational>> knots;
    for (const std::size_t degree : degrees) {
        knots.emplace_back(degree + 1, Rational(0));
        knots.back().insert(knots.back().end(), degree + 1, Rational(1));
    }
    return knots;
}

/// How many control points the knots of a direction stand for. Errors: `bad_knots`.
std::size_t splinepy_count(std::size_t degree, std::size_t knots) {
    if (knots > 2 * degree + 1) return knots - degree - 1;
    throw Error(ErrorCode::bad_knots,
                std::to_string(knots) + " knots are too few for degree " + std::to_string(degree));
}

ForeignSpline read_splinepy_spline(const Json& data, const Limits& limits) {
    Fields fields(data);
    SplineNumbers numbers;
    numbers.degrees = fields.required("degrees", [&](const Json& value) {
        auto degrees = read_list(value, [&](const Json& degree) { return read_count(degree, limits); });
        if (!degrees.empty()) return degrees;
        throw Error(ErrorCode::wrong_arity, "a spline has at least one direction");
    });
    const std::size_t directions = numbers.degrees.size();
    numbers.points = fields.required("control_points", read_rows);
    numbers.weights = fields.optional("weights", read_weight_list);
    const auto knots = fields.optional("knot_vectors", [&](const Json& value) {
        return read_each_direction(value, directions, "knot vectors", read_doubles);
    });
    require_type(fields);
    if (!numbers.points.empty()) require_stated(fields, "dim", numbers.points.front().size(), "coordinates");
    require_stated(fields, "para_dim", directions, "directions");
    numbers.knots = knots ? *knots : bezier_knots(numbers.degrees);
    const NumberPlaces places = splinepy_places(directions);
    for (std::size_t d = 0; d < directions; ++d) {
        try {
            if (directions > 1 || !knots)
                numbers.counts.push_back(splinepy_count(numbers.degrees[d], numbers.knots[d].size()));
        } catch (const Error& error) {
            throw error.at(places.knots[d]);
        }
    }
    if (!knots && directions == 1 && numbers.points.size() != numbers.counts.front()) {
        throw Error(ErrorCode::wrong_arity,
                    "without knots, a curve of degree " + std::to_string(numbers.degrees.front()) + " has " +
                        std::to_string(numbers.counts.front()) + " control points, not " +
                        std::to_string(numbers.points.size()),
                    Place{"control_points"});
    }
    return foreign_spline(std::move(numbers), places);
}

std::vector<ForeignSpline> read_splinepy(const Json& document, Floats, const Limits& limits) {
    Fields fields(document);
    const bool encoded = fields.optional("Base64Encoding", read_boolean).value_or(false);
    if (encoded) {
        throw Error(ErrorCode::wrong_kind,
                    "the numbers are written in base 64; export them with base64encoding=False",
                    Place{"Base64Encoding"});
    }
    std::vector<ForeignSpline> splines = fields.required("SplineList", [&](const Json& list) {
        return read_list(list, [&](const Json& data) { return read_splinepy_spline(data, limits); });
    });
    require_stated(fields, "NumberOfSplines", splines.size(), "splines");
    for (std::size_t i = 0; i < splines.size(); ++i) splines[i].places.document = {"SplineList", i};
    return splines;
}

Json write_splinepy(const std::vector<Map>& splines) {
    Json::Array list;
    for (const Map& map : splines) {
        const std::size_t directions = knots_of(map).size();
        WrittenSpline written = written_spline(map, first_fastest(directions));
        Json data = Json::Object{{"degrees", Json::Array(written.degrees.begin(), written.degrees.end())},
                                 {"knot_vectors", Json::Array(written.knots.begin(), written.knots.end())},
                                 {"control_points", std::move(written.points)}};
        if (!written.weights.empty()) {
            Json::Array rows;
            for (const Json& weight : written.weights) rows.emplace_back(Json::Array{weight});
            data["weights"] = std::move(rows);
        }
        data["SplineType"] = written.weights.empty() ? "BSpline" : "NURBS";
        data["dim"] = written.dimension;
        data["para_dim"] = directions;
        list.push_back(std::move(data));
    }
    return Json::Object{{"Name", "SplineGroup"},
                        {"NumberOfSplines", splines.size()},
                        {"Base64Encoding", false},
                        {"SplineList", std::move(list)}};
}

}  // namespace

constinit const ForeignFormat splinepy_format{
    .name = "splinepy", .read = read_splinepy, .write = write_splinepy, .weights = true};

}  // namespace blossom::protocol
