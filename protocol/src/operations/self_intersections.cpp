#include <fmt/format.h>

#include "curve_meetings.hpp"
#include "geometric_curve.hpp"
#include "map_options.hpp"
#include "real_numbers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

bool is_at(const Root& root, const std::optional<Rational>& end) {
    return end && root.is_rational() && root.lower == *end;
}

Answer answer_self_intersections(Request& request, const Limits& limits) {
    const CurveQuestion question = read_curve_question(request, limits);
    request.finish();
    require_plane(question.curve, Place{"map"});
    const auto& [range, pieces, dimension] = question.curve;
    const auto [points, overlaps] = self_intersections(pieces, question.width, limits);
    Json result = Json::Object{{"interval", to_json(range)}};
    result["intersections"] =
        meetings_json(points, pieces, limits, [&](const CurveIntersection& point, Json::Object& entry) {
            const bool closes = is_at(point.first, range.lower) && is_at(point.second, range.upper);
            entry.emplace(entry.begin(), "kind", closes ? "closed" : "double");
        });
    result["cusps"] = real_json(cusps(pieces, question.width, limits), limits);
    if (!overlaps.empty()) result["overlaps"] = overlaps_json(overlaps, limits);
    return result;
}

std::string render_self_intersections(const Answered& answered) {
    const Json& result = answered.result();
    std::string text;
    for (const Json& point : *result.find("intersections")->array()) {
        text += fmt::format("  {}{}\n", *point.find("kind")->text() == "closed" ? "closed: " : "",
                            meeting_text(point, answered.style));
    }
    for (const Json& cusp : *result.find("cusps")->array())
        text += fmt::format("  cusp at {}\n", real_equation(cusp, "t", {}));
    text += overlaps_text(result, "passed twice");
    return curve_answer_text(answered, std::move(text), "self-intersection");
}

}  // namespace

Operation self_intersections_operation() {
    FieldList fields = meeting_fields();
    fields.insert(fields.begin(), required("kind", Shape::words({"double", "closed"}),
                                           "`closed` where the ends of the curve are one point"));
    return {
        .summary = "Find where a plane curve meets itself, and its cusps",
        .documentation = "All pairs of parameters of one point are found exactly, the lesser one first.",
        .request = {{map_field(), range_field("curve"), width_field("parameters")}},
        .result = {{range_member("curve"),
                    required("intersections", Shape::list(Shape::object({std::move(fields)})),
                             "the pairs of parameters in increasing order"),
                    required("cusps", Shape::list(real_shape()),
                             "the parameters at which the velocity is zero and the direction is reversed"),
                    overlaps_member("the parts that are passed more than once")}},
        .example = {"self-intersections", "t^2 - 1; t^3 - t"},
        .options = with_range_options({}, "curve"),
        .answer = answer_self_intersections,
        .render = render_self_intersections,
    };
}

}  // namespace blossom::protocol
