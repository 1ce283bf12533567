#include <blossom/core/queries/cuts.hpp>

#include <fmt/format.h>

#include "geometric_curve.hpp"
#include "map_options.hpp"
#include "real_numbers.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The point at a root, which lies in one of the pieces.
std::vector<Root> point_at(std::vector<std::pair<const CurvePiece*, PointsOnCurve>>& known,
                           std::span<const CurvePiece> pieces, const Root& root, const Limits& limits) {
    const CurvePiece* piece = &pieces.front();
    for (const CurvePiece& candidate : pieces) {
        if (!candidate.range.lower || *candidate.range.lower <= root.lower) piece = &candidate;
    }
    if (known.empty() || known.back().first != piece)
        known.emplace_back(piece, PointsOnCurve(*piece, limits));
    return known.back().second.at(root);
}

Json cuts_json(const CurveQuestion& question, std::span<const Rational> line, const Limits& limits) {
    const std::vector<CurvePiece>& pieces = question.curve.pieces;
    const SplineRoots found = within("line", [&] { return cuts(pieces, line, question.width, limits); });
    std::vector<std::pair<const CurvePiece*, PointsOnCurve>> known;
    Json::Array points;
    for (const Root& root : found.roots) {
        points.push_back(Json::Object{{"parameters", Json::Array{real_json(root, limits)}},
                                      {"point", real_json(point_at(known, pieces, root, limits), limits)},
                                      {"multiplicity", root.multiplicity}});
    }
    Json result =
        Json::Object{{"interval", to_json(question.curve.range)}, {"intersections", std::move(points)}};
    if (!found.zeros.empty()) {
        Json::Array overlaps;
        for (const ParameterRange& range : found.zeros)
            overlaps.push_back(Json::Object{{"intervals", Json::Array{to_json(range)}}});
        result["overlaps"] = std::move(overlaps);
    }
    return result;
}

Answer answer_intersections(Request& request, const Limits& limits) {
    const CurveQuestion question = read_curve_question(request, limits);
    const auto line =
        request.required("line", [&](const Json& value) { return read_numbers(value, limits); });
    request.finish();
    return cuts_json(question, line, limits);
}

std::string render_intersections(const Answered& answered) {
    std::string text;
    for (const Json& point : *answered.result().find("intersections")->array()) {
        const std::string multiplicity = point_text(*point.find("multiplicity"));
        text += fmt::format("  {} at {}{}\n", answered.style.bold(real_point_text(*point.find("point"))),
                            real_equation(point.find("parameters")->array()->front(), "t", {}),
                            multiplicity == "1" ? "" : ", multiplicity " + multiplicity);
    }
    if (const Json* overlaps = answered.result().find("overlaps")) {
        for (const Json& overlap : *overlaps->array())
            text +=
                fmt::format("  on the line in {}\n", range_text(overlap.find("intervals")->array()->front()));
    }
    return curve_answer_text(answered, std::move(text), "intersection");
}

}  // namespace

Operation intersections_operation() {
    return {
        .summary = "Find where a curve meets a line or a plane",
        .documentation = "All intersections are found exactly, each once, with their multiplicities.",
        .request = {{map_field(),
                     required("line", numbers_shape(),
                              "the numbers a, b, c of a line a x + b y + c = 0; in d dimensions the d + 1 "
                              "numbers of a plane"),
                     range_field("intersections"), width_field("parameters")}},
        .result = {{range_member("intersections"),
                    required(
                        "intersections",
                        Shape::list(Shape::object(
                            {{required("parameters", Shape::list(real_shape()), "the parameter"),
                              real_point_member(),
                              required("multiplicity", ValueKind::count,
                                       "the multiplicity: 1 where the curve crosses without contact")}})),
                        "the intersections in increasing order of the parameters"),
                    optional("overlaps",
                             Shape::list(Shape::object({{required("intervals", Shape::list(range_shape()),
                                                                  "the interval of the parameter")}})),
                             "where the curve lies on the line")}},
        .example = {"intersections", "t; t^2", "--line", "1,-1,2"},
        .options =
            with_range_options({field_option("--line", "line", "A,B,C", number_list)}, "intersections"),
        .answer = answer_intersections,
        .render = render_intersections,
    };
}

}  // namespace blossom::protocol
