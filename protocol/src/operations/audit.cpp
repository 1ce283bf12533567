#include <fmt/format.h>
#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "evaluator.hpp"
#include "foreign_options.hpp"
#include "formats/doubles.hpp"
#include "formats/formats.hpp"
#include "json/json_text.hpp"
#include "map_options.hpp"
#include "maps/points.hpp"
#include "rounding.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The same shape as `computed`, with the exact values of its doubles.
Json exact_values(const Json& computed) {
    const Json::Array* list = computed.array();
    if (!list) return read_double(computed);
    return read_list(computed, exact_values);
}

struct Errors {
    Json errors;  ///< computed - exact
    Json ulps;    ///< their sizes in units in the last place of the exact values
    Rational greatest;
    std::size_t wrong = 0;  ///< numbers that are not the nearest double
    std::size_t count = 0;
};

std::pair<Json, Json> compare(const Json& exact, const Json& computed, Errors& errors) {
    const Json::Array* of_exact = exact.array();
    const Json::Array* of_computed = computed.array();
    if (!of_exact && !of_computed) {
        const Rational error = *computed.exact() - *exact.exact();
        const Rational ulps = abs(error) / unit_in_last_place(*exact.exact());
        errors.greatest = std::max(errors.greatest, ulps);
        if (*computed.exact() != exact_rational(nearest_double(*exact.exact()))) ++errors.wrong;
        ++errors.count;
        return {error, ulps};
    }
    if (!of_exact || !of_computed || of_exact->size() != of_computed->size()) {
        const auto size = [](const Json::Array* list) {
            return list ? std::to_string(list->size()) + " values" : std::string("one number");
        };
        throw Error(ErrorCode::mismatched_dimensions,
                    "there are " + size(of_computed) + ", and " + size(of_exact) + " in the exact map");
    }
    Json::Array differences;
    Json::Array ulps;
    for (std::size_t i = 0; i < of_exact->size(); ++i) {
        auto [error, in_ulps] = within(i, [&] { return compare((*of_exact)[i], (*of_computed)[i], errors); });
        differences.push_back(std::move(error));
        ulps.push_back(std::move(in_ulps));
    }
    return {std::move(differences), std::move(ulps)};
}

/// The members that hold the numbers of a map, in the order of the answer.
constexpr std::string_view audited[] = {"knots",        "control_points", "weights",
                                        "coefficients", "denominator",    "values"};

/// An object with some of these members.
Shape audited_numbers(ValueKind kind) {
    Members members{.fields = {}, .some = true};
    for (const std::string_view field : audited)
        members.fields.push_back(optional(field, kind, "the numbers of this member of the map"));
    return Shape::object(std::move(members));
}

/// The numbers that the request gives as computed, by field.
struct Computed {
    Json numbers;
    const ForeignFormat* format = nullptr;  ///< of the document that they come from

    /// Where the request has what lies at `of_numbers`.
    Place place(const Place& of_numbers) const {
        if (!format) return Place{"computed"}.around(of_numbers);
        return Place{"document"}.around(place_in_document(*format, of_numbers));
    }
};

Computed read_computed(Fields& request, const Limits& limits) {
    if (!request.has("document")) {
        return {request.required("computed", [](const Json& value) {
            Fields fields(value);
            Json computed;
            for (const std::string_view field : audited) {
                if (auto numbers = fields.optional(field, exact_values))
                    computed[field] = std::move(*numbers);
            }
            fields.finish();
            if (computed.is_null()) fields.missing("control_points");
            return computed;
        })};
    }
    const ForeignFormat& format = request.required(
        "format", [](const Json& value) -> const ForeignFormat& { return read_format(value); });
    Json numbers = request.required("document", [&](const Json& value) {
        const std::vector<Map> maps = format.read(value, limits);
        if (maps.size() != 1) {
            throw Error(ErrorCode::wrong_arity, "one curve is compared, not " + std::to_string(maps.size()));
        }
        return to_json(maps.front());
    });
    return {std::move(numbers), &format};
}

Answer answer(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto parameters =
        request.optional("at", [&](const Json& value) { return read_numbers(value, limits); });
    const Computed computed = read_computed(request, limits);
    request.finish();
    Json exact = to_json(computed.format ? as_textbook_spline(map, limits) : map);
    if (parameters) {
        exact["values"] = values_at(value_evaluator(map, parameters->size(), limits), *parameters, map.form,
                                    dimension_of(map), limits);
    }
    Errors errors;
    Json differences;
    Json ulps;
    for (const std::string_view field : audited) {
        const Json* numbers = computed.numbers.find(field);
        if (!numbers) continue;
        const Json* expected = exact.find(field);
        try {
            within(field, [&] {
                if (!expected) throw Error(ErrorCode::wrong_kind, "the exact map has no such numbers");
                auto [error, in_ulps] = compare(*expected, *numbers, errors);
                differences[field] = std::move(error);
                ulps[field] = std::move(in_ulps);
            });
        } catch (const Error& error) {
            throw error.at(computed.place(error.place()));
        }
    }
    return Json::Object{{"errors", std::move(differences)},
                        {"ulps", std::move(ulps)},
                        {"greatest_ulps", errors.greatest},
                        {"numbers", errors.count},
                        {"not_nearest", errors.wrong}};
}

std::string ulps_text(const Json& ulps) {
    const Json::Array* list = ulps.array();
    if (!list) return fmt::format("{:.3g}", nearest_double(*ulps.exact()));
    std::string text;
    for (const Json& element : *list) text += (text.empty() ? "" : ", ") + ulps_text(element);
    return "(" + text + ")";
}

std::string render(const Answered& answered) {
    const Json& result = answered.result();
    std::string text = description(answered.given()) + "\n\n";
    for (const auto& [field, ulps] : *result.find("ulps")->object()) {
        if (is_rounded_twin(field)) continue;
        const Json::Array& errors = *result.find("errors")->find(field)->array();
        for (std::size_t i = 0; i < errors.size(); ++i) {
            text += fmt::format("  {} {}: error {}, {} ulp\n", field, i, point_text(errors[i]),
                                ulps_text((*ulps.array())[i]));
        }
    }
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
    return {
        .name = "audit",
        .summary =
            "Measure the error of doubles computed by another program, against the exact numbers of a map",
        .documentation = "Each double counts as the exact number that it represents.",
        .request =
            {{map_field(), optional("at", numbers_shape(), "the parameters of the values")},
             {{{required("computed", audited_numbers(ValueKind::doubles),
                         "the numbers of the other program, by members of the map, or the `values` at `at`")},
               {format_field(), document_field()}}}},
        .result = {{required("errors", audited_numbers(ValueKind::nested_points),
                             "the computed minus the exact values"),
                    required("ulps", audited_numbers(ValueKind::nested_points),
                             "their sizes in units in the last place of the exact values"),
                    required("greatest_ulps", ValueKind::number, "the greatest of these"),
                    required("numbers", ValueKind::count, "how many numbers were compared"),
                    required("not_nearest", ValueKind::count,
                             "how many of them are not the nearest double")}},
        .example = {"audit", "--control-points", "0; 1/3; 1/10", "--computed",
                    R"({"control_points": [0, 0.333, 0.1]})"},
        .options = with_map_options({
            {"--computed",
             {"computed"},
             "JSON",
             R"(the numbers of the other program: "control_points", "weights", "knots", "coefficients", )"
             R"(or the "values" at the parameters --at)",
             apply_computed},
            field_option("--at", "at", "T1,T2,...", number_list),
            format_option(),
            document_option(
                R"(instead of --computed: a file of another library, "@NAME" or "-", or its text)"),
        }),
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::protocol
