#include <fmt/format.h>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <utility>

#include "comparison.hpp"
#include "foreign_options.hpp"
#include "formats/formats.hpp"
#include "given_answers.hpp"
#include "json/json_text.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "maps/points.hpp"
#include "rounding.hpp"
#include "shared_fields.hpp"
#include "table.hpp"
#include "values.hpp"

namespace blossom::protocol {

namespace {

/// The members that hold the numbers of a map, in the order of the answer.
constexpr std::string_view audited[] = {"knots",          "interval",    "intervals",   "vertices", "center",
                                        "control_points", "control_net", "weights",     "left",     "right",
                                        "coefficients",   "terms",       "denominator", "values"};

/// Numbers of the member of a map: in nested lists, by indices for a net over a simplex and for terms, and at
/// two ends for the denominator of a hermite map.
Shape audited_shape(std::string_view field, ValueKind kind) {
    if (field == "control_net" || field == "terms")
        return Shape::one_of({kind, Shape::list(Shape::pair(Shape::list(ValueKind::count), kind))});
    if (field != "denominator") return kind;
    return Shape::one_of(
        {kind, Shape::object({{required("left", kind, "at a"), required("right", kind, "at b")}})});
}

/// The members of an object that contain numbers of a map.
FieldList audited_fields(ValueKind kind) {
    return mapped(std::span(audited), [&](std::string_view field) {
        return optional(field, audited_shape(field, kind), "the numbers of this member of the map");
    });
}

/// The results of another program, with or without values at parameters.
Shape computed_shape(bool with_values) {
    FieldList fields = audited_fields(ValueKind::doubles);
    fields.pop_back();
    if (with_values) fields.push_back(required("values", ValueKind::doubles, "the values at the parameters"));
    return Shape::object({.fields = std::move(fields), .some = !with_values});
}
Shape compared_shape() {
    return Shape::object({.fields = audited_fields(ValueKind::nested_points), .some = true});
}

/// The members that are multiplied by weights or divided by a denominator.
constexpr std::string_view divided_fields[] = {"control_points", "control_net",  "left",
                                               "right",          "coefficients", "terms"};

/// The values of the map at the parameters "at".
Json values_of(const Map& map, const Json& at, const Limits& limits) {
    const Json request = Json::Object{{"at", at}};
    Fields fields(request);
    return written_at(values_at(map, read_parameters(fields, parameter_form(map), limits), limits), map.form);
}

/// The two sides of a comparison.
struct Sides {
    Json exact;
    Json computed;                       ///< members with numbers
    const Json* document = nullptr;      ///< the document of the request
    std::optional<NumberPlaces> places;  ///< of the numbers in it
    std::string_view without_weights;    ///< the side whose weights are taken to be 1

    /// The place in the request of the computed number at `of_numbers`. A document may leave knots out.
    Place place(const Place& of_numbers) const {
        if (!document) return Place{"computed"}.around(of_numbers);
        return Place{"document"}.around(present_part(*document, places->of(of_numbers)));
    }
};

/// Errors: `missing_field` for points without the weights or the denominator of the exact map, and for
/// values without parameters or the other way round.
void require_complete(const Sides& sides, bool has_parameters) {
    const Json& computed = sides.computed;
    for (const std::string_view rest : {"weights", "denominator"}) {
        if (!sides.exact.find(rest) || computed.find(rest)) continue;
        for (const std::string_view field : divided_fields) {
            if (!computed.find(field)) continue;
            throw Error(ErrorCode::missing_field,
                        fmt::format(R"(the map is rational: its "{}" are compared together with its "{}")",
                                    field, rest),
                        sides.place({std::string(rest)}));
        }
    }
    if (has_parameters && !computed.find("values")) {
        throw Error(ErrorCode::missing_field, R"(the "values" at the parameters "at" are missing)",
                    sides.place({"values"}));
    }
    if (computed.find("values") && !sides.exact.find("values")) {
        throw Error(ErrorCode::missing_field, R"(the parameters of "values" are missing)", Place{"at"});
    }
}

/// How many lists are around the first number of a list of points, or of pairs of an index and a point.
std::size_t depth_of(const Json& value, bool indexed) {
    const Json::Array* elements = value.array();
    if (!elements || elements->empty()) return 0;
    const Json::Array* pair = indexed ? elements->front().array() : nullptr;
    if (pair && !pair->empty()) return 2 + depth_of(pair->back(), false);
    return 1 + depth_of(elements->front(), false);
}

/// The form in which points of one coordinate were computed: as numbers x or as lists [x].
bool is_scalar(const Json& exact, const Json& computed, bool scalar) {
    for (const std::string_view field : {"control_points", "control_net", "coefficients", "values", "left"}) {
        const Json* one = exact.find(field);
        const Json* other = computed.find(field);
        if (!one || !other) continue;
        const bool indexed = is_indexed(*one);
        if (depth_of(*other, indexed) + (scalar ? 0 : 1) == depth_of(*one, indexed) + (scalar ? 1 : 0))
            return !scalar;
    }
    return scalar;
}

/// The members of field "computed", which is a map or a part of it.
Sides read_computed(Request& request, Map map, const Limits& limits) {
    Sides sides;
    const auto at = request.optional("at", [](const Json& value) { return value; });
    request.required("computed", [&](const Json& value) {
        Fields fields(value);
        for (const std::string_view field : audited) {
            if (auto numbers = fields.optional(field, [](const Json& given) { return given; }))
                sides.computed[field] = *std::move(numbers);
        }
        fields.finish();
        if (sides.computed.is_null()) fields.missing("control_points");
        return true;
    });
    const auto write_exact = [&] {
        sides.exact = to_json(map);
        if (at) sides.exact["values"] = values_of(map, *at, limits);
    };
    write_exact();
    if (!map.form.homogeneous && point_dimension(map) == 1) {
        const bool scalar = is_scalar(sides.exact, sides.computed, map.form.scalar);
        if (std::exchange(map.form.scalar, scalar) != scalar) write_exact();
    }
    require_complete(sides, at.has_value());
    return sides;
}

/// A spline with weights, all 1.
Map with_weights_of_one(const Map& map) {
    std::vector<Coordinates> points = control_points_of(map);
    for (Coordinates& point : points) point.emplace_back(1);
    const std::span<const KnotVector> knots = knots_of(map);
    Map weighted = map;
    weighted.form.rational = true;
    if (knots.size() == 1) {
        weighted.value = BSplineCurve(knots.front(), std::move(points));
    } else {
        weighted.value = TensorBSpline({knots.begin(), knots.end()}, std::move(points));
    }
    return weighted;
}

/// The segments of a spline, as a path has them.
std::vector<Map> segments_of(const Map& spline, const Limits& limits) {
    return mapped(bezier_segments(std::get<BSplineCurve>(spline.value), limits),
                  [&](const BezierCurve& segment) { return like(spline, segment); });
}

/// The degree of a curve, or the degrees of the directions.
const Json& degrees_in(const Json& map) {
    const Json* degree = map.find("degree");
    return degree ? *degree : *map.find("degrees");
}

/// A map of the document beside the exact one, both as splines, or as the pieces of a path.
Sides compared_sides(Map exact, const Place& place_of_exact, const ForeignSpline& computed,
                     const Json& document) {
    Sides sides;
    sides.document = &document;
    sides.places = computed.places;
    Map found = computed.map;
    exact.form.homogeneous = found.form.homogeneous;
    if (point_dimension(found) == 1) exact.form.scalar = found.form.scalar;
    if (exact.form.rational != found.form.rational) {
        sides.without_weights = exact.form.rational ? "document" : "map";
        Map& lacking = exact.form.rational ? found : exact;
        lacking = with_weights_of_one(lacking);
    }
    try {
        sides.exact = to_json(exact);
    } catch (const Error& error) {
        throw error.at(place_of_exact);
    }
    sides.computed = to_json(found);
    // A path has no intervals.
    std::erase_if(*sides.computed.object(),
                  [](const Json::Member& member) { return member.first == "interval"; });
    if (degrees_in(sides.exact) != degrees_in(sides.computed)) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the degree is " + to_text(degrees_in(sides.computed)) + ", and " +
                        to_text(degrees_in(sides.exact)) + " in the exact map",
                    sides.place(Part::degree));
    }
    return sides;
}

Map foreign_spline_at(const Place& place, const ForeignFormat& format, const Map& map, const Limits& limits) {
    try {
        return as_foreign_spline(format, map, limits);
    } catch (const Error& error) {
        throw error.at(place);
    }
}

/// The maps in field "document", which are compared as wholes.
std::vector<Sides> read_documents(Request& request, const std::vector<Map>& maps, bool several,
                                  const Limits& limits) {
    const ForeignFormat& format = request.required(
        "format", [](const Json& value) -> const ForeignFormat& { return read_format(value); });
    const Json& document = *request.required("document", [](const Json& value) { return &value; });
    std::vector<Map> exact;
    std::vector<Place> places;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Place place = several ? Place{"maps", i} : Place{"map"};
        Map whole = foreign_spline_at(place, format, maps[i], limits);
        std::vector<Map> parts = format.pieces ? segments_of(whole, limits) : std::vector{std::move(whole)};
        std::ranges::move(parts, std::back_inserter(exact));
        places.resize(exact.size(), place);
    }
    const std::vector<ForeignSpline> found = within("document", [&] {
        auto splines = read_document(format, document, format.floats, limits);
        if (splines.size() == exact.size()) return splines;
        throw Error(ErrorCode::wrong_arity,
                    fmt::format("there are {} maps in the document, and {} exact ones", splines.size(),
                                exact.size()));
    });
    std::vector<Sides> all;
    for (std::size_t i = 0; i < found.size(); ++i)
        all.push_back(compared_sides(std::move(exact[i]), places[i], found[i], document));
    return all;
}

/// The comparison of all members that were computed.
Difference compare_members(Comparison& compare, const Sides& sides) {
    Difference found;
    for (const std::string_view field : audited) {
        const Json* computed = sides.computed.find(field);
        if (!computed) continue;
        const Json* exact = sides.exact.find(field);
        try {
            within(field, [&] {
                if (!exact) throw Error(ErrorCode::wrong_kind, "the exact map has no such numbers");
                Difference difference = compare(*exact, *computed);
                found.error[field] = std::move(difference.error);
                found.ulps[field] = std::move(difference.ulps);
            });
        } catch (const Error& error) {
            throw error.at(sides.place(error.place()));
        }
    }
    return found;
}

Answer answer_audit(Request& request, const Limits& limits) {
    const bool several = request.has("maps");
    std::vector<Map> maps =
        several ? read_maps_field(request, limits) : std::vector<Map>{request.map(limits)};
    const std::vector<Sides> all = several || request.has("document")
                                       ? read_documents(request, maps, several, limits)
                                       : std::vector<Sides>{read_computed(request, maps.front(), limits)};
    request.finish();
    const auto* patch = several ? nullptr : std::get_if<Patch>(&maps.front().value);
    Comparison compare(patch && patch->is_polynomial(), limits);
    Json::Array errors, ulps;
    std::string_view without_weights;
    for (const Sides& sides : all) {
        Difference found = compare_members(compare, sides);
        errors.push_back(std::move(found.error));
        ulps.push_back(std::move(found.ulps));
        if (without_weights.empty()) without_weights = sides.without_weights;
    }
    const bool listed = several || all.size() != 1;
    Json::Object result{{"errors", listed ? Json(std::move(errors)) : std::move(errors.front())},
                        {"ulps", listed ? Json(std::move(ulps)) : std::move(ulps.front())},
                        {"greatest_ulps", compare.greatest()},
                        {"numbers", compare.count()},
                        {"not_nearest", compare.wrong()}};
    if (!without_weights.empty()) result.emplace_back("without_weights", without_weights);
    return result;
}

std::string ulps_text(const Json& ulps) {
    const Json::Array* list = ulps.array();
    if (!list) return fmt::format("{:.3g}", nearest_double(*ulps.exact()));
    std::string text;
    for (const Json& element : *list) text += (text.empty() ? "" : ", ") + ulps_text(element);
    return "(" + text + ")";
}

/// One line per number or point.
std::string lines_of(const std::string& name, const Json& errors, const Json& ulps) {
    std::string text;
    if (const Json::Object* members = errors.object()) {
        for (const auto& [end, member] : *members) {
            if (!is_rounded_twin(end))
                text += lines_of(fmt::format("{} {}", name, end), member, *ulps.find(end));
        }
        return text;
    }
    const auto line = [](const std::string& place, const Json& error, const Json& in_ulps) {
        return fmt::format("  {}: error {}, {} ulp\n", place, point_text(error), ulps_text(in_ulps));
    };
    const Json::Array* list = errors.array();
    if (!list) return line(name, errors, ulps);
    const bool indexed = is_indexed(errors);
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& error = (*list)[i];
        const Json& in_ulps = (*ulps.array())[i];
        text += indexed ? line(fmt::format("{} {}", name, point_text((*error.array())[0])),
                               (*error.array())[1], (*in_ulps.array())[1])
                        : line(fmt::format("{} {}", name, i), error, in_ulps);
    }
    return text;
}

std::string lines_of_members(const Json& errors, const Json& ulps) {
    std::string text;
    for (const auto& [field, error] : *errors.object()) {
        if (!is_rounded_twin(field)) text += lines_of(field, error, *ulps.find(field));
    }
    return text;
}

std::string render_audit(const Answered& answered) {
    const Json& result = answered.result();
    const Json& errors = *result.find("errors");
    const Json& ulps = *result.find("ulps");
    std::string text = answered.has_given() ? description(answered.given()) + "\n\n" : "";
    if (const Json::Array* list = errors.array()) {
        for (std::size_t i = 0; i < list->size(); ++i)
            text += fmt::format("{}map {}\n{}", i > 0 ? "\n" : "", i,
                                lines_of_members((*list)[i], (*ulps.array())[i]));
    } else {
        text += lines_of_members(errors, ulps);
    }
    if (const Json* side = result.find("without_weights"))
        text += fmt::format("\nThe {} has no weights; they count as 1.\n", *side->text());
    return text +
           fmt::format("\n{} of {} numbers are not the nearest double; the greatest error is {} ulp.\n",
                       point_text(*result.find("not_nearest")), point_text(*result.find("numbers")),
                       answered.style.bold(ulps_text(*result.find("greatest_ulps"))));
}

void apply_computed(Json& request, const std::vector<std::string>& values, const Limits& limits) {
    request["computed"] = computed_in(parse_json(values.front(), limits), limits);
}

}  // namespace

Operation audit_operation() {
    const std::string computed =
        "the numbers of the other program, by members of the map, or the `values` at `at`";
    const Shape one_or_several = Shape::one_of({compared_shape(), Shape::list(compared_shape())});
    return {
        .summary =
            "Measure the error of doubles computed by another program, against the exact numbers of a map",
        .documentation = "Each double counts as the exact number that it represents.",
        .request = {{},
                    {{{map_field(), required("computed", computed_shape(false), computed)},
                      {map_field(), required("computed", computed_shape(true), computed),
                       required("at", parameters_shape(), "the parameters of the values")},
                      {map_field(), format_field(), document_field()},
                      {maps_field("the exact maps of a document with several"), format_field(),
                       document_field()}}}},
        .result = {{required("errors", one_or_several, "the computed minus the exact values"),
                    required("ulps", one_or_several,
                             "their sizes in units in the last place of the exact values"),
                    required("greatest_ulps", ValueKind::number, "the greatest of these"),
                    required("numbers", ValueKind::count, "how many numbers were compared"),
                    required("not_nearest", ValueKind::count, "how many of them are not the nearest double"),
                    optional("without_weights", Shape::words({"document", "map"}),
                             "the side that has no weights, which count as 1")}},
        .example = {"audit", "--control-points", "0; 1/3; 1/10", "--computed",
                    R"({"control_points": [0, 0.333, 0.1]})"},
        .options = with_map_options({
            {"--computed",
             {"computed"},
             "JSON",
             R"(the numbers of the other program, by members of the map, or the "values" at the parameters --at)",
             apply_computed},
            field_option("--at", "at", "T1,T2,...", number_list, patch_parameters),
            format_option(),
            document_option(
                R"(instead of --computed: a file of another library, "@NAME" or "-", or its text)"),
            maps_option("--maps", "instead of a map: the exact maps of a document with several"),
        }),
        .answer = answer_audit,
        .render = render_audit,
    };
}

}  // namespace blossom::protocol
