#include <blossom/core/queries/cuts.hpp>

#include <fmt/format.h>

#include "curve_meetings.hpp"
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

void add_cuts(Json& result, const CurveQuestion& question, std::span<const Rational> line,
              const Limits& limits) {
    const std::vector<CurvePiece>& pieces = question.curve.pieces;
    const SplineRoots found = within("line", [&] { return cuts(pieces, line, question.width, limits); });
    std::vector<std::pair<const CurvePiece*, PointsOnCurve>> known;
    Json::Array points;
    for (const Root& root : found.roots) {
        points.push_back(Json::Object{{"parameters", Json::Array{real_json(root, limits)}},
                                      {"point", real_json(point_at(known, pieces, root, limits), limits)},
                                      {"multiplicity", root.multiplicity}});
    }
    result["intersections"] = std::move(points);
    if (found.zeros.empty()) return;
    Json::Array overlaps;
    for (const ParameterRange& range : found.zeros) {
        AlgebraicRange ends;
        if (range.lower) ends.lower = rational_root(*range.lower);
        if (range.upper) ends.upper = rational_root(*range.upper);
        overlaps.push_back(Json::Object{{"intervals", Json::Array{algebraic_range_json(ends, limits)}}});
    }
    result["overlaps"] = std::move(overlaps);
}

void add_meetings(Json& result, const CurveQuestion& question, const GeometricCurve& other,
                  const Limits& limits) {
    require_plane(question.curve, Place{"map"});
    require_plane(other, Place{"with"});
    const CurveIntersections found =
        intersections(question.curve.pieces, other.pieces, question.width, limits);
    result["with_interval"] = to_json(other.range);
    result["intersections"] = meetings_json(found.points, question.curve.pieces, limits);
    if (!found.overlaps.empty()) result["overlaps"] = overlaps_json(found.overlaps, limits);
}

Answer answer_intersections(Request& request, const Limits& limits) {
    const CurveQuestion question = read_curve_question(request, limits);
    const auto line =
        request.optional("line", [&](const Json& value) { return read_numbers(value, limits); });
    const auto other_range =
        request.optional("with_interval", [&](const Json& value) { return read_range(value, limits); });
    const auto other = request.optional("with", [&](const Json& value) {
        return geometric_curve(read_map(value, limits), other_range, limits, Place());
    });
    request.finish();
    if (line && other) {
        throw Error(ErrorCode::wrong_kind, "either another curve or a line is given, not both",
                    Place{"line"});
    }
    if (other_range && !other) request.missing("with");
    Json result = Json::Object{{"interval", to_json(question.curve.range)}};
    if (line) {
        add_cuts(result, question, *line, limits);
    } else if (other) {
        add_meetings(result, question, *other, limits);
    } else {
        request.missing("with");
    }
    return result;
}

std::string render_intersections(const Answered& answered) {
    std::string text;
    for (const Json& point : *answered.result().find("intersections")->array())
        text += "  " + meeting_text(point, answered.style) + "\n";
    text += overlaps_text(answered.result(), "common part");
    return curve_answer_text(answered, std::move(text), "intersection");
}

}  // namespace

Operation intersections_operation() {
    return {
        .summary = "Find where a curve meets another curve, a line or a plane",
        .documentation =
            "All intersections are found exactly, each once, with their multiplicities, and "
            "common parts as intervals.",
        .request = {{map_field(),
                     optional("with_interval", range_shape(),
                              "the closed interval of the other curve, like `interval`"),
                     range_field("intersections"), width_field("parameters")},
                    {{{required("with", ValueKind::map, "the other plane curve")},
                      {required("line", numbers_shape(),
                                "the numbers a, b, c of a line a x + b y + c = 0; in d dimensions the d + 1 "
                                "numbers of a plane")}}}},
        .result = {{range_member("intersections"),
                    optional("with_interval", range_shape(), "the interval of the other curve"),
                    required("intersections", Shape::list(Shape::object({meeting_fields()})),
                             "the intersections in increasing order of the parameters"),
                    overlaps_member("the common parts; their ends are no intersections")}},
        .example = {"intersections", "t; t^2", "--with", "t^2; t"},
        .options = with_range_options({other_map_option("--with", "with"),
                                       field_option("--with-over", "with_interval", "A,B", number_list),
                                       field_option("--line", "line", "A,B,C", number_list)},
                                      "intersections"),
        .answer = answer_intersections,
        .render = render_intersections,
    };
}

}  // namespace blossom::protocol
