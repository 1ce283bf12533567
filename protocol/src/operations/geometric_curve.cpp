#include "geometric_curve.hpp"

#include <fmt/format.h>

#include "map_options.hpp"
#include "shared_fields.hpp"

namespace blossom::protocol {

namespace {

struct GeometricCurveOf {
    const std::optional<ParameterRange>& asked;
    bool rational;
    const Limits& limits;

    GeometricCurve operator()(const OnePolynomial auto& curve) const {
        const ParameterRange range = asked_range(curve, asked);
        return {range, curve_pieces(polynomial_map(curve, limits), rational, range, limits),
                dimension(curve)};
    }
    GeometricCurve operator()(const BSplineCurve& curve) const {
        const ParameterRange range = asked_range(curve, asked);
        return {range, curve_pieces(curve, rational, range, limits), dimension(curve)};
    }

private:
    std::size_t dimension(const auto& curve) const { return curve.dimension() - (rational ? 1 : 0); }
};

}  // namespace

GeometricCurve geometric_curve(const Map& map, const std::optional<ParameterRange>& asked,
                               const Limits& limits, const Place& place) {
    return dispatch_on_kind<GeometricCurve>(map, GeometricCurveOf{asked, map.form.rational, limits}, place);
}

Rational read_width(Request& request, const Limits& limits) {
    const auto width =
        request.optional("width", [&](const Json& value) { return read_number(value, limits); });
    if (width && width->sign() <= 0) {
        throw Error(ErrorCode::wrong_kind, "the width of an interval is greater than 0", Place{"width"});
    }
    return width.value_or(0);
}

CurveQuestion read_curve_question(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_range(value, limits); });
    Rational width = read_width(request, limits);
    return {map, within("map", [&] { return geometric_curve(map, interval, limits, Place()); }),
            std::move(width)};
}

Shape range_shape() {
    const Shape end = Shape::one_of({ValueKind::number, Shape::words({"-inf", "inf"})});
    return Shape::pair(end, end);
}

Field range_field(std::string_view what) {
    return optional("interval", range_shape(),
                    fmt::format("the closed interval of the {}; by default that of the map, and all numbers "
                                "for a polynomial or taylor map",
                                what));
}

Field width_field(std::string_view what) {
    return optional("width", ValueKind::number,
                    fmt::format("the maximal width of the intervals around irrational {}", what));
}

Field range_member(std::string_view what) {
    return required("interval", range_shape(),
                    fmt::format("the interval of the {}, in increasing direction", what));
}

Field ranges_member(std::string_view name, std::string documentation) {
    return optional(name, Shape::list(range_shape()), std::move(documentation));
}

Json ranges_json(const std::vector<ParameterRange>& ranges) {
    Json::Array list;
    for (const ParameterRange& range : ranges) list.push_back(to_json(range));
    return list;
}

std::vector<Option> with_range_options(std::vector<Option> others, std::string_view what) {
    others.push_back(own_interval_option(fmt::format(
        "the interval of the given control points, by default 0,1, or else that of the {}", what)));
    others.push_back(field_option(
        "--over", "interval", "A,B", number_list,
        fmt::format("the interval of the {}, where -inf and inf are no ends; by default that of the map, "
                    "-inf,inf for a polynomial",
                    what)));
    others.push_back(field_option("--width", "width", "W", plain_text));
    return with_map_options(std::move(others));
}

std::string range_text(const Json& range) {
    const Json::Array& ends = *range.array();
    const std::string from = point_text(ends[0]);
    const std::string to = point_text(ends[1]);
    return fmt::format("{}{}, {}{}", from == "-inf" ? "(" : "[", from, to, to == "inf" ? ")" : "]");
}

std::string curve_answer_text(const Answered& answered, std::string text, std::string_view nothing) {
    if (text.empty()) {
        const std::string range = range_text(*answered.result().find("interval"));
        text = range == "(-inf, inf)" ? fmt::format("There is no {}.\n", nothing)
                                      : fmt::format("There is no {} in {}.\n", nothing, range);
    }
    return description(answered.given()) + "\n\n" + text;
}

}  // namespace blossom::protocol
