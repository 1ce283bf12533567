#include <blossom/core/queries/extrema.hpp>

#include <fmt/format.h>

#include "geometric_curve.hpp"
#include "map_options.hpp"
#include "real_numbers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Json global_extremum_json(const GlobalExtremum& extremum, const Limits& limits) {
    Json json = Json::Object{{"value", real_json(extremum.value, limits)},
                             {"parameters", real_json(extremum.parameters, limits)}};
    if (!extremum.ranges.empty()) json["constant"] = ranges_json(extremum.ranges);
    return json;
}

Answer answer_extrema(Request& request, const Limits& limits) {
    const CurveQuestion question = read_curve_question(request, limits);
    const bool scalar = question.map.form.scalar;
    const auto direction =
        request.optional("direction", [&](const Json& value) { return read_numbers(value, limits); });
    request.finish();
    if (!direction && !scalar) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the values of the map are points; a direction is needed", Place{"map"});
    }
    const std::vector<Rational> itself{1};
    const auto functions = within(
        "direction", [&] { return component(question.curve.pieces, direction ? *direction : itself); });
    const Extrema found = extrema(functions, question.width, limits);
    Json::Array local;
    for (const Extremum& extremum : found.local) {
        local.push_back(Json::Object{{"kind", extremum.is_maximum ? "maximum" : "minimum"},
                                     {"parameter", real_json(extremum.at, limits)},
                                     {"value", real_json(extremum.value, limits)}});
    }
    Json result = Json::Object{{"interval", to_json(question.curve.range)}, {"extrema", std::move(local)}};
    if (!found.constant.empty()) result["constant"] = ranges_json(found.constant);
    if (found.least) result["least"] = global_extremum_json(*found.least, limits);
    if (found.greatest) result["greatest"] = global_extremum_json(*found.greatest, limits);
    return result;
}

std::string render_extrema(const Answered& answered) {
    std::string text;
    for (const Json& extremum : *answered.result().find("extrema")->array()) {
        text += fmt::format("  {} {} at {}\n", *extremum.find("kind")->text(),
                            answered.style.bold(real_text(*extremum.find("value"))),
                            real_equation(*extremum.find("parameter"), "t", {}));
    }
    if (const Json* constant = answered.result().find("constant")) {
        for (const Json& range : *constant->array())
            text += fmt::format("  constant in {}\n", range_text(range));
    }
    for (const char* name : {"least", "greatest"}) {
        const Json* global = answered.result().find(name);
        text += global ? fmt::format("The {} value is {}.\n", name, real_text(*global->find("value")))
                       : fmt::format("There is no {} value.\n", name);
    }
    return curve_answer_text(answered, std::move(text), "");
}

Shape global_extremum_shape() {
    return Shape::object({{required("value", real_shape(), "the value"),
                           required("parameters", Shape::list(real_shape()),
                                    "where it is taken, in increasing order, besides `constant`"),
                           ranges_member("constant", "the intervals in which it is the only value")}});
}

}  // namespace

Operation extrema_operation() {
    return {
        .summary = "Find the extrema of a scalar map, or of a curve in a direction",
        .documentation =
            "The local and the global extrema in a closed interval are decided exactly, its ends "
            "included.",
        .request = {{map_field(),
                     optional("direction", numbers_shape(),
                              "for a map whose values are points: the extrema of this linear combination "
                              "of the coordinates are wanted"),
                     range_field("extrema"), width_field("parameters")}},
        .result = {{range_member("extrema"),
                    required("extrema",
                             Shape::list(Shape::object(
                                 {{required("kind", Shape::words({"minimum", "maximum"}), "which of them"),
                                   required("parameter", real_shape(), "where it is"),
                                   required("value", real_shape(), "the value there")}})),
                             "the local extrema in increasing order of the parameters"),
                    ranges_member("constant",
                                  "the intervals in which the value is constant; their ends are "
                                  "no local extrema"),
                    optional(
                        "least", global_extremum_shape(),
                        "the least value; not there if the map is not bounded below or does not take it"),
                    optional("greatest", global_extremum_shape(), "the greatest value, likewise")}},
        .example = {"extrema", "t^3 - 2t", "--over", "-1,2"},
        .options = with_range_options({field_option("--direction", "direction", "A1,A2,...", number_list)},
                                      "extrema"),
        .answer = answer_extrema,
        .render = render_extrema,
    };
}

}  // namespace blossom::protocol
