#pragma once

#include <blossom/core/queries/curve_pieces.hpp>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "maps/dispatch_on_kind.hpp"
#include "operation.hpp"

/// The curve of a request as a set of points, for questions about where it lies.

namespace blossom::protocol {

/// The range that is asked for, or else that of the curve; all numbers for a curve without an interval.
ParameterRange asked_range(const OnePolynomial auto& curve, const std::optional<ParameterRange>& asked) {
    if (asked) return *asked;
    const auto own = own_interval(curve);
    return own ? ParameterRange(*own) : ParameterRange();
}
/// The part in the domain; where there is none, what was asked for.
inline ParameterRange asked_range(const BSplineCurve& curve, const std::optional<ParameterRange>& asked) {
    const Interval domain = curve.knots().domain();
    if (!asked) return domain;
    const Rational lower = asked->lower ? std::max(*asked->lower, domain.a()) : domain.a();
    const Rational upper = asked->upper ? std::min(*asked->upper, domain.b()) : domain.b();
    return lower <= upper ? ParameterRange(lower, upper) : *asked;
}

struct GeometricCurve {
    ParameterRange range;
    std::vector<CurvePiece> pieces;
    std::size_t dimension = 0;  ///< of its points, without weights
};

/// A curve of a request over a range. Errors: `wrong_kind` for a map that is no curve; those of
/// `curve_pieces`.
GeometricCurve geometric_curve(const Map& map, const std::optional<ParameterRange>& asked,
                               const Limits& limits, const Place& place = Part::map);

/// What most questions about a curve ask for.
struct CurveQuestion {
    const Map& map;
    GeometricCurve curve;
    Rational width;
};
/// Fields "map", "interval" and "width".
CurveQuestion read_curve_question(Request& request, const Limits& limits);
/// Field "width", or 0. Errors: `wrong_kind` unless it is positive.
Rational read_width(Request& request, const Limits& limits);

/// An interval that may be unbounded.
Shape range_shape();
/// The description of the fields "interval" and "width".
Field range_field(std::string_view what);
Field width_field(std::string_view what);
Field range_member(std::string_view what);
Field ranges_member(std::string_view name, std::string documentation);
Json ranges_json(const std::vector<ParameterRange>& ranges);

/// --interval, --over and --width for them.
std::vector<Option> with_range_options(std::vector<Option> others, std::string_view what);

/// "[0, inf)", or "the reals"
std::string range_text(const Json& range);
/// The curve of the answer, and "There is no ... in [0, 1]." if the text is empty.
std::string curve_answer_text(const Answered& answered, std::string text, std::string_view nothing);

}  // namespace blossom::protocol
