#pragma once

#include <blossom/core/queries/intersections.hpp>

#include <string>

#include "geometric_curve.hpp"

/// Common points and parts of curves in results.

namespace blossom::protocol {

/// Errors: `mismatched_dimensions`, at `place`.
void require_plane(const GeometricCurve& curve, const Place& place);

/// The common points; kind(point) adds members. The points are those of the first curve.
Json meetings_json(const std::vector<CurveIntersection>& points, std::span<const CurvePiece> first,
                   const Limits& limits,
                   const std::function<void(const CurveIntersection& point, Json::Object& entry)>& add = {});
Json overlaps_json(const std::vector<CurveOverlap>& overlaps, const Limits& limits);
/// An interval of a parameter that is given exactly.
Json algebraic_range_json(const AlgebraicRange& range, const Limits& limits);

/// The members of a common point besides its kind.
FieldList meeting_fields();
/// The member "overlaps".
Field overlaps_member(std::string documentation);

/// "(1, 2) at s = 1/2, t = 3, multiplicity 2".
std::string meeting_text(const Json& point, const Style& style);
/// "0 <= s <= 1/2 and 1/2 <= t <= 1, reversed".
std::string overlap_text(const Json& overlap);
std::string overlaps_text(const Json& result, std::string_view what);

}  // namespace blossom::protocol
