#include "drawn_curve.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>

#include <algorithm>

#include "maps/dispatch_on_kind.hpp"
#include "maps/graph.hpp"

namespace blossom::protocol {

namespace {

using worked::Role;

constexpr std::size_t most_dots = 400;

struct CurvePainter {
    worked::Picture& picture;
    bool rational = false;
    std::optional<Interval> interval;
    Role role = Role::control;
    const std::string& name;
    const Limits& limits;

    void operator()(const PolynomialCurve& curve) const {
        segments({control_points(curve, interval.value_or(Interval()), limits)});
    }
    void operator()(const OnePolynomial auto& curve) const {
        std::visit(*this, polynomial_map(curve, limits));
    }
    void operator()(const BezierCurve& curve) const {
        polygon(curve.control_points().to_points());
        segments({curve});
    }
    void operator()(const ProgressiveCurve& curve) const {
        polygon(curve.control_points().to_points());
        segments({control_points(curve, interval_of(curve), limits)});
    }
    void operator()(const BSplineCurve& curve) const {
        polygon(curve.control_points());
        segments(bezier_segments(curve, limits));
    }

private:
    void polygon(const std::vector<Coordinates>& points) const {
        const Role own = role == Role::before ? role : Role::control;
        std::size_t dots = 0;
        for (auto& places : worked::lines_through(points, rational)) {
            for (const worked::PlanePoint& place : places) {
                if (dots++ < most_dots) picture.points.push_back({place, worked::words(""), own});
            }
            picture.lines.push_back({std::move(places), own});
        }
    }
    void segments(const std::vector<BezierCurve>& segments) const {
        constexpr std::size_t most_values = 1000;
        const std::size_t steps = std::clamp<std::size_t>(most_values / segments.size(), 8, 256);
        const std::size_t first = picture.curves.size();
        for (const BezierCurve& segment : segments) {
            std::ranges::move(worked::curves_over(segment, segment.interval(), role, limits, rational, steps),
                              std::back_inserter(picture.curves));
        }
        if (first < picture.curves.size()) picture.curves[first].name = name;
        if (role == Role::before || segments.size() >= most_dots) return;
        const bool named = segments.size() < most_names;
        for (const BezierCurve& segment : segments) knot(segment, segment.interval().a(), named);
        knot(segments.back(), segments.back().interval().b(), named);
    }
    void knot(const BezierCurve& segment, const Rational& t, bool named) const {
        const auto label =
            named ? worked::equation({worked::symbol("t"), worked::number(t)}) : worked::words("");
        const Coordinates point = evaluate(segment, t, limits);
        for (const auto& places : worked::lines_through({&point, 1}, rational))
            picture.points.push_back({places.front(), label});
    }
};

}  // namespace

void draw_curve(worked::Picture& picture, const Map& map, const std::optional<Interval>& interval, Role role,
                const std::string& name, const Limits& limits) {
    const bool graph = dimension_of(map) - (map.form.rational ? 1 : 0) == 1;
    const Map plane = graph ? within("map", [&] { return graph_of(map, limits); }) : map;
    picture.graph = picture.graph || (graph && role != Role::before);
    dispatch_on_kind<void>(plane, CurvePainter{picture, plane.form.rational, interval, role, name, limits});
}

}  // namespace blossom::protocol
