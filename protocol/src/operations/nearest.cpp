#include <blossom/core/queries/extrema.hpp>

#include <fmt/format.h>

#include "geometric_curve.hpp"
#include "map_options.hpp"
#include "real_numbers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The piece to which a parameter belongs; of the ends of pieces, which jump in no direction, either.
const CurvePiece& piece_at(std::span<const CurvePiece> pieces, const Root& parameter) {
    for (const CurvePiece& piece : pieces) {
        if (!piece.range.upper || parameter.upper <= *piece.range.upper) return piece;
    }
    return pieces.back();
}

Answer answer_nearest(Request& request, const Limits& limits) {
    const CurveQuestion question = read_curve_question(request, limits);
    const bool scalar = question.map.form.scalar;
    const auto point = request.required("point", [&](const Json& value) {
        return scalar && !value.array() ? std::vector{read_number(value, limits)}
                                        : read_numbers(value, limits);
    });
    request.finish();
    const std::vector<CurvePiece>& pieces = question.curve.pieces;
    const auto distances = within("point", [&] { return squared_distance(pieces, point); });
    const Extrema found = extrema(distances, question.width, limits);
    Json result = Json::Object{{"interval", to_json(question.curve.range)}};
    if (!found.least) return result;
    result["squared_distance"] = real_json(found.least->value, limits);
    Json::Array nearest;
    for (const Root& parameter : found.least->parameters) {
        PointsOnCurve points(piece_at(pieces, parameter), limits);
        nearest.push_back(Json::Object{{"parameter", real_json(parameter, limits)},
                                       {"point", real_json(points.at(parameter), limits)}});
    }
    result["nearest"] = std::move(nearest);
    if (!found.least->ranges.empty()) result["constant"] = ranges_json(found.least->ranges);
    return result;
}

std::string render_nearest(const Answered& answered) {
    std::string text;
    if (const Json* nearest = answered.result().find("nearest")) {
        for (const Json& entry : *nearest->array()) {
            text += fmt::format("  {} at {}\n", answered.style.bold(real_point_text(*entry.find("point"))),
                                real_equation(*entry.find("parameter"), "t", {}));
        }
        if (const Json* constant = answered.result().find("constant")) {
            for (const Json& range : *constant->array())
                text += fmt::format("  all points in {}\n", range_text(range));
        }
        text += fmt::format("The square of the distance is {}.\n",
                            real_text(*answered.result().find("squared_distance")));
    }
    return curve_answer_text(answered, std::move(text), "nearest point");
}

}  // namespace

Operation nearest_operation() {
    return {
        .summary = "Find the points of a curve that are nearest to a point",
        .documentation = "All nearest points are returned: distances are compared exactly.",
        .request = {{map_field(),
                     required("point", Shape::one_of({ValueKind::number, numbers_shape()}), "the point"),
                     range_field("curve"), width_field("parameters")}},
        .result = {{range_member("curve"),
                    optional("squared_distance", real_shape(), "the square of the least distance"),
                    optional("nearest",
                             Shape::list(Shape::object({{required("parameter", real_shape(), "its parameter"),
                                                         real_point_member()}})),
                             "the nearest points in increasing order of their parameters, besides "
                             "`constant`; not there if the curve comes nearer and nearer to the point "
                             "towards infinite parameters"),
                    ranges_member("constant", "the intervals in which all points are nearest")}},
        .example = {"nearest", "t; t^2", "--to", "0,1"},
        .options = with_range_options({field_option("--to", "point", "X,Y,...", number_list)}, "curve"),
        .answer = answer_nearest,
        .render = render_nearest,
    };
}

}  // namespace blossom::protocol
