#include "curve_meetings.hpp"

#include <fmt/format.h>

#include <map>

#include "real_numbers.hpp"

namespace blossom::protocol {

namespace {

Shape end_shape() { return Shape::one_of({real_shape(), Shape::words({"-inf", "inf"})}); }

/// "s" and "t" of two parameters, "t" of one.
std::string_view parameter_name(std::size_t index, std::size_t count) {
    return count == 2 && index == 0 ? "s" : "t";
}

std::string end_text(const Json& end) {
    const std::string* infinity = end.text();
    return infinity ? *infinity : real_text(end);
}

}  // namespace

void require_plane(const GeometricCurve& curve, const Place& place) {
    if (curve.dimension == 2) return;
    throw Error(ErrorCode::mismatched_dimensions,
                fmt::format("the curve must be plane; its points have {} coordinate{}", curve.dimension,
                            curve.dimension == 1 ? "" : "s"),
                place);
}

Json meetings_json(const std::vector<CurveIntersection>& points, std::span<const CurvePiece> first,
                   const Limits& limits,
                   const std::function<void(const CurveIntersection& point, Json::Object& entry)>& add) {
    std::map<std::size_t, PointsOnCurve> pieces;
    Json::Array list;
    for (const CurveIntersection& point : points) {
        PointsOnCurve& piece =
            pieces.try_emplace(point.first_piece, first[point.first_piece], limits).first->second;
        Json::Object entry{
            {"parameters", Json::Array{real_json(point.first, limits), real_json(point.second, limits)}},
            {"point", real_json(piece.at(point.first), limits)}};
        if (point.multiplicity > 0) entry.emplace_back("multiplicity", point.multiplicity);
        if (add) add(point, entry);
        list.emplace_back(std::move(entry));
    }
    return list;
}

Json algebraic_range_json(const AlgebraicRange& range, const Limits& limits) {
    return Json::Array{range.lower ? real_json(*range.lower, limits) : Json("-inf"),
                       range.upper ? real_json(*range.upper, limits) : Json("inf")};
}

Json overlaps_json(const std::vector<CurveOverlap>& overlaps, const Limits& limits) {
    Json::Array list;
    for (const CurveOverlap& overlap : overlaps) {
        Json entry = Json::Object{{"intervals", Json::Array{algebraic_range_json(overlap.first, limits),
                                                            algebraic_range_json(overlap.second, limits)}}};
        if (overlap.is_reversed) entry["reversed"] = true;
        list.push_back(std::move(entry));
    }
    return list;
}

FieldList meeting_fields() {
    return {
        required("parameters", Shape::list(real_shape()), "the parameter of each curve"), real_point_member(),
        optional("multiplicity", ValueKind::count,
                 "the order of contact plus 1: 1 where the tangents differ, at least 2 where the curves "
                 "touch; not there where the velocity of a curve is zero, or where one curve goes on as the "
                 "continuation of the other")};
}

Field overlaps_member(std::string documentation) {
    return optional(
        "overlaps",
        Shape::list(Shape::object(
            {{required("intervals", Shape::list(Shape::pair(end_shape(), end_shape())),
                       "the interval of each parameter"),
              optional("reversed", ValueKind::flag, "the parameters run in opposite directions")}})),
        std::move(documentation));
}

std::string meeting_text(const Json& point, const Style& style) {
    const Json::Array& parameters = *point.find("parameters")->array();
    std::string text = style.bold(real_point_text(*point.find("point"))) + " at ";
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        text += fmt::format("{}{}", i == 0 ? "" : "; ",
                            real_equation(parameters[i], parameter_name(i, parameters.size()), {}));
    }
    const Json* multiplicity = point.find("multiplicity");
    if (!multiplicity) return text + ", no multiplicity";
    const std::string times = point_text(*multiplicity);
    return times == "1" ? text : text + ", multiplicity " + times;
}

std::string overlap_text(const Json& overlap) {
    const Json::Array& intervals = *overlap.find("intervals")->array();
    std::string text;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const Json::Array& ends = *intervals[i].array();
        text += fmt::format("{}{} from {} to {}", i == 0 ? "" : ", ", parameter_name(i, intervals.size()),
                            end_text(ends[0]), end_text(ends[1]));
    }
    return overlap.find("reversed") ? text + ", reversed" : text;
}

std::string overlaps_text(const Json& result, std::string_view what) {
    std::string text;
    if (const Json* overlaps = result.find("overlaps")) {
        for (const Json& overlap : *overlaps->array())
            text += fmt::format("  {}: {}\n", what, overlap_text(overlap));
    }
    return text;
}

}  // namespace blossom::protocol
