#include "drawn_curve.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "maps/dispatch_on_kind.hpp"
#include "maps/graph.hpp"

namespace blossom::protocol {

namespace {

/// The first two coordinates; none for a point at infinity.
std::optional<PlanePoint> projected_place(const Coordinates& point, const PointForm& form) {
    if (!form.rational) return PlanePoint{point[0], point[1]};
    if (point.back().is_zero()) return std::nullopt;
    return PlanePoint{point[0] / point.back(), point[1] / point.back()};
}

/// Appends to the last line, or begins a new one.
void append(std::vector<std::vector<PlanePoint>>& lines, const std::optional<PlanePoint>& place,
            bool& broken) {
    if (!place) {
        broken = true;
        return;
    }
    if (broken || lines.empty()) lines.emplace_back();
    broken = false;
    lines.back().push_back(*place);
}

std::vector<std::vector<PlanePoint>> broken_line(std::span<const Coordinates> points, const PointForm& form) {
    std::vector<std::vector<PlanePoint>> lines;
    bool broken = true;
    for (const Coordinates& point : points) append(lines, projected_place(point, form), broken);
    return lines;
}

struct Painter {
    const PointForm& form;
    std::optional<Interval> interval;
    const Limits& limits;

    DrawnCurve operator()(const PolynomialCurve& curve) const {
        return of_segments({control_points(curve, interval.value_or(Interval()), limits)});
    }
    DrawnCurve operator()(const OnePolynomial auto& curve) const {
        return std::visit(*this, polynomial_map(curve, limits));
    }
    DrawnCurve operator()(const BezierCurve& curve) const {
        DrawnCurve result = of_segments({curve});
        result.polygon = broken_line(curve.control_points().to_points(), form);
        return result;
    }
    DrawnCurve operator()(const ProgressiveCurve& curve) const {
        DrawnCurve result = of_segments({control_points(curve, interval_of(curve), limits)});
        result.polygon = broken_line(curve.control_points().to_points(), form);
        return result;
    }
    DrawnCurve operator()(const BSplineCurve& curve) const {
        DrawnCurve result = of_segments(bezier_segments(curve, limits));
        result.polygon = broken_line(curve.control_points(), form);
        return result;
    }

private:
    DrawnCurve of_segments(const std::vector<BezierCurve>& segments) const {
        constexpr std::size_t most = 1000;
        const std::size_t steps = std::clamp<std::size_t>(most / segments.size(), 8, 256);
        DrawnCurve result;
        std::optional<Coordinates> end;
        for (const BezierCurve& segment : segments) {
            bool broken = !end || *end != evaluate(segment, segment.interval().a(), limits);
            add_mark(segment, segment.interval().a(), result);
            for (std::size_t i = 0; i <= steps; ++i) {
                const Rational part = Rational(i) / Rational(steps);
                const Rational t =
                    segment.interval().a() + part * (segment.interval().b() - segment.interval().a());
                append(result.lines, projected_place(evaluate(segment, t, limits), form), broken);
            }
            end = evaluate(segment, segment.interval().b(), limits);
        }
        add_mark(segments.back(), segments.back().interval().b(), result);
        return result;
    }
    void add_mark(const BezierCurve& segment, const Rational& t, DrawnCurve& result) const {
        if (const auto place = projected_place(evaluate(segment, t, limits), form))
            result.knots.push_back({*place, to_string(t)});
    }
};

}  // namespace

DrawnCurve drawn(const Map& map, const std::optional<Interval>& interval, const Limits& limits) {
    const std::size_t coordinates = dimension_of(map) - (map.form.rational ? 1 : 0);
    const Map plane = coordinates == 1 ? within("map", [&] { return graph_of(map, limits); }) : map;
    return dispatch_on_kind<DrawnCurve>(plane, Painter{plane.form, interval, limits});
}

std::optional<PlanePoint> place_of(const Json& value, const Rational& t, const PointForm& form) {
    Coordinates point = answered_point(value);
    if (form.homogeneous) {
        const Rational weight = point.back();
        if (weight.is_zero()) return std::nullopt;
        point.pop_back();
        for (Rational& coordinate : point) coordinate /= weight;
    }
    if (point.size() == 1) return PlanePoint{t, point[0]};
    return PlanePoint{point[0], point[1]};
}

std::optional<Interval> given_interval(const Map& map) {
    const auto own = [](const auto& value) -> std::optional<Interval> {
        if constexpr (requires { own_interval(value); }) return own_interval(value);
        return std::nullopt;
    };
    return std::visit(own, map.value);
}

}  // namespace blossom::protocol
