#include <fmt/format.h>
#include <blossom/core/conversion.hpp>

#include "operations/map_options.hpp"
#include "operations/table.hpp"

namespace blossom::cli {

namespace {

/// The same map with a greater formal degree.
PolynomialCurve raised(const PolynomialCurve& curve, std::size_t degree) {
    std::vector<Polynomial> coordinates;
    coordinates.reserve(curve.dimension());
    for (std::size_t j = 0; j < curve.dimension(); ++j) coordinates.push_back(curve.coordinate(j));
    return PolynomialCurve(coordinates, degree);
}

struct ControlPoints {
    std::optional<std::size_t> degree;
    Interval interval;
    const Limits& limits;

    BezierCurve operator()(const PolynomialCurve& curve) const {
        return control_points(degree ? raised(curve, *degree) : curve, interval, limits);
    }
    BezierCurve operator()(const BezierCurve& curve) const {
        if (degree && *degree != curve.degree()) return (*this)(monomial_form(curve, limits));
        return curve.interval() == interval ? curve : control_points(curve, interval, limits);
    }
};

Interval own_interval(const Map& map) {
    const auto* curve = std::get_if<BezierCurve>(&map.curve);
    return curve ? curve->interval() : Interval();
}

Json answer(Fields& request, const Limits& limits) {
    const Map map = read_map_field(request, limits);
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    const auto degree =
        request.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    request.finish();
    require_numbers(degree.value_or(0) + 1, dimension_of(map), limits);

    const BezierCurve curve =
        std::visit(ControlPoints{degree, interval.value_or(own_interval(map)), limits}, map.curve);
    return Json::Object{{"map", within("map", [&] { return to_json({curve, map.form, map.variable}); })}};
}

/// The arguments a, ..., a, b, ..., b of control point k, with k copies of b.
std::string label(std::size_t degree, std::size_t k, const std::vector<std::string>& ends) {
    constexpr std::size_t readable = 6;
    if (degree > readable) return "";
    std::string arguments;
    for (std::size_t i = 0; i < degree; ++i) arguments += (i == 0 ? "" : ", ") + ends[i < degree - k ? 0 : 1];
    return " = p(" + arguments + ")";
}

std::string render(const Answered& answered) {
    const Json& map = *answered.result.find("map");
    const std::vector<std::string> ends = member_texts(map, "interval");
    const std::vector<std::string> points = member_texts(map, "control_points");
    const bool weighted = map.find("weights");
    const std::vector<std::string> weights =
        weighted ? member_texts(map, "weights") : std::vector<std::string>{};
    const Json::Array& exact_ends = *map.find("interval")->array();
    std::string text = description(read_map(*answered.request.find("map"), answered.limits)) + "\n\n";
    text += fmt::format("Control points over [{}, {}]:\n", ends[0], ends[1]);
    for (std::size_t k = 0; k < points.size(); ++k) {
        text +=
            fmt::format("  P{}{} = {}", k,
                        label(points.size() - 1, k, {point_text(exact_ends[0]), point_text(exact_ends[1])}),
                        answered.style.bold(points[k]));
        text += weighted ? fmt::format(", weight {}\n", weights[k]) : "\n";
    }
    return text;
}

/// For control points --interval says where those that are given live, otherwise where they are wanted.
void apply_interval(Json& request, const std::vector<std::string>& values, const Limits&) {
    Json& owner = has_control_points(request) ? request["map"] : request;
    owner["interval"] = number_list(values.front());
}

}  // namespace

Operation control_points_operation() {
    return {
        .name = "control-points",
        .summary = "The Bezier control points of a map over any interval",
        .example = {"control-points", "1 + 2t + 4t^2 - t^3", "--interval", "2,-1"},
        .options = with_map_options({
            {"--interval", "/interval", "A,B",
             "the interval of the control points: of those given, or else of those wanted; by default 0,1",
             apply_interval},
            field_option("--over", "interval", "A,B", "the interval of the control points wanted",
                         number_list),
            field_option("--degree", "degree", "N", "the formal degree wanted; by default that of the map",
                         count),
        }),
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::cli
