#include <fmt/format.h>
#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <utility>

#include "comparison.hpp"
#include "foreign_options.hpp"
#include "formats/formats.hpp"
#include "json/json_text.hpp"
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

/// The two sides of the comparison.
struct Sides {
    Json exact;
    Json computed;                          ///< members with numbers
    const ForeignFormat* format = nullptr;  ///< the format of the document
    const Json* document = nullptr;         ///< the document of the request
    std::string_view without_weights;       ///< the side whose weights are taken to be 1

    /// The place in the request of the computed number at `of_numbers`. A document may leave knots out.
    Place place(const Place& of_numbers) const {
        if (!format) return Place{"computed"}.around(of_numbers);
        return Place{"document"}.around(present_part(*document, place_in_document(*format, of_numbers)));
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

/// The members of field "computed", which is a map or a part of it.
Sides read_computed(Request& request, const Map& map, const Limits& limits) {
    Sides sides;
    sides.exact = to_json(map);
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
    if (at) sides.exact["values"] = values_of(map, *at, limits);
    require_complete(sides, at.has_value());
    return sides;
}

/// The weights of a curve without weights, all 1.
Json weights_of_one(const Json& curve) {
    return Json::Array(curve.find("control_points")->array()->size(), Rational(1));
}

/// The curve in field "document", which is compared as a whole.
Sides read_document(Request& request, const Map& map, const Limits& limits) {
    const ForeignFormat& format = request.required(
        "format", [](const Json& value) -> const ForeignFormat& { return read_format(value); });
    const Json& document = *request.required("document", [](const Json& value) { return &value; });
    Sides sides;
    sides.format = &format;
    sides.document = &document;
    sides.computed = within("document", [&] {
        const std::vector<Map> maps = format.read(document, format.floats, limits);
        if (maps.size() == 1) return to_json(as_textbook_spline(maps.front(), limits));
        throw Error(ErrorCode::wrong_arity, "one curve is compared, not " + std::to_string(maps.size()));
    });
    sides.exact = within("map", [&] { return to_json(as_textbook_spline(map, limits)); });
    if (*sides.exact.find("degree") != *sides.computed.find("degree")) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the degree is " + to_text(*sides.computed.find("degree")) + ", and " +
                        to_text(*sides.exact.find("degree")) + " in the exact map",
                    sides.place(Part::degree));
    }
    const bool weighted = sides.computed.find("weights") != nullptr;
    if (map.form.homogeneous || weighted == map.form.rational) return sides;
    sides.without_weights = weighted ? "map" : "document";
    Json& lacking = weighted ? sides.exact : sides.computed;
    lacking["weights"] = weights_of_one(lacking);
    return sides;
}

Answer answer_audit(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const Sides sides =
        request.has("document") ? read_document(request, map, limits) : read_computed(request, map, limits);
    request.finish();
    const auto* patch = std::get_if<Patch>(&map.value);
    Comparison compare(patch && patch->is_polynomial(), limits);
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
    Json::Object result{{"errors", std::move(found.error)},
                        {"ulps", std::move(found.ulps)},
                        {"greatest_ulps", compare.greatest()},
                        {"numbers", compare.count()},
                        {"not_nearest", compare.wrong()}};
    if (!sides.without_weights.empty()) result.emplace_back("without_weights", sides.without_weights);
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

std::string render_audit(const Answered& answered) {
    const Json& result = answered.result();
    std::string text = description(answered.given()) + "\n\n";
    for (const auto& [field, errors] : *result.find("errors")->object()) {
        if (!is_rounded_twin(field)) text += lines_of(field, errors, *result.find("ulps")->find(field));
    }
    if (const Json* side = result.find("without_weights"))
        text += fmt::format("\nThe {} has no weights; they count as 1.\n", *side->text());
    return text +
           fmt::format("\n{} of {} numbers are not the nearest double; the greatest error is {} ulp.\n",
                       point_text(*result.find("not_nearest")), point_text(*result.find("numbers")),
                       answered.style.bold(ulps_text(*result.find("greatest_ulps"))));
}

void apply_computed(Json& request, const std::vector<std::string>& values, const Limits& limits) {
    request["computed"] = parse_json(values.front(), limits);
}

}  // namespace

Operation audit_operation() {
    const std::string computed =
        "the numbers of the other program, by members of the map, or the `values` at `at`";
    return {
        .summary =
            "Measure the error of doubles computed by another program, against the exact numbers of a map",
        .documentation = "Each double counts as the exact number that it represents.",
        .request = {{map_field()},
                    {{{required("computed", computed_shape(false), computed)},
                      {required("computed", computed_shape(true), computed),
                       required("at", parameters_shape(), "the parameters of the values")},
                      {format_field(), document_field()}}}},
        .result = {{required("errors", compared_shape(), "the computed minus the exact values"),
                    required("ulps", compared_shape(),
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
        }),
        .answer = answer_audit,
        .render = render_audit,
    };
}

}  // namespace blossom::protocol
