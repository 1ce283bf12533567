#include <blossom/core/queries/inflections.hpp>

#include <fmt/format.h>

#include "geometric_curve.hpp"
#include "map_options.hpp"
#include "real_numbers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view inflection_kinds[] = {"inflection", "flat", "cusp", "singular"};

Answer answer_inflections(Request& request, const Limits& limits) {
    const CurveQuestion question = read_curve_question(request, limits);
    request.finish();
    const Inflections found = inflections(question.curve.pieces, question.width, limits);
    Json::Array points;
    for (const Inflection& point : found.points) {
        points.push_back(
            Json::Object{{"kind", std::string(inflection_kinds[static_cast<std::size_t>(point.kind)])},
                         {"parameter", real_json(point.at, limits)},
                         {"multiplicity", point.multiplicity}});
    }
    Json result =
        Json::Object{{"interval", to_json(question.curve.range)}, {"inflections", std::move(points)}};
    if (!found.straight.empty()) result["straight"] = ranges_json(found.straight);
    return result;
}

std::string render_inflections(const Answered& answered) {
    std::string text;
    for (const Json& point : *answered.result().find("inflections")->array()) {
        text += fmt::format("  {} at {}\n", *point.find("kind")->text(),
                            real_equation(*point.find("parameter"), "t", answered.style));
    }
    if (const Json* straight = answered.result().find("straight")) {
        for (const Json& range : *straight->array())
            text += fmt::format("  straight in {}\n", range_text(range));
    }
    return curve_answer_text(answered, std::move(text), "zero of the curvature");
}

}  // namespace

Operation inflections_operation() {
    return {
        .summary = "Find the inflections, cusps and flat points of a plane curve",
        .documentation =
            "They are the zeros of det(F, F', F'') in homogeneous coordinates F, with what "
            "happens there.",
        .request = {{map_field(), range_field("inflections"), width_field("parameters")}},
        .result =
            {{range_member("inflections"),
              required(
                  "inflections",
                  Shape::list(Shape::object(
                      {{required("kind", Shape::words(inflection_kinds),
                                 "whether the curvature changes its sign (`inflection`) or not (`flat`), or "
                                 "the velocity is zero and the direction reversed (`cusp`) or not "
                                 "(`singular`)"),
                        required("parameter", real_shape(), "where it is"),
                        required("multiplicity", ValueKind::count,
                                 "the multiplicity of the zero of the determinant; 0 where it jumps "
                                 "between signs at a knot")}})),
                  "the points in increasing order of the parameters"),
              ranges_member("straight", "the intervals in which the curve lies on a line")}},
        .example = {"inflections", "t; t^3 - t"},
        .options = with_range_options({}, "inflections"),
        .answer = answer_inflections,
        .render = render_inflections,
    };
}

}  // namespace blossom::protocol
