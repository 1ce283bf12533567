#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/rational/number_text.hpp>

#include "kind.hpp"

namespace blossom::protocol {

namespace {

/// {"kind": "bspline", "degree", "knots", "control_points", "weights"?, "homogeneous"?}
Map read_bspline(Fields& fields, const Limits& limits) {
    const std::size_t degree =
        fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    const auto read_knots = [&](const Json& list) { return read_numbers(list, limits); };
    std::vector<Rational> knots =
        fields.required("knots", [&](const Json& value) { return read_written_list(value, read_knots); });
    const WeightedPoints read = read_control_points(fields, limits);
    return {BSplineCurve(degree, std::move(knots), read.points.list()), read.form};
}

Json write(const BSplineCurve& curve, const PointForm& form) {
    const auto& knots = curve.knots().knots();
    Json map = Json::Object{
        {"kind", "bspline"}, {"degree", curve.degree()}, {"knots", Json::Array(knots.begin(), knots.end())}};
    write_control_points(map, curve.control_points(), form);
    return map;
}

std::string formula(const BSplineCurve& curve, const Map& map, std::string_view name) {
    const Json written = write(curve, map.form);
    const Interval domain = curve.knots().domain();
    return fmt::format("{}: B-spline of degree {} over [{}, {}], knots {}, control points {}", name,
                       curve.degree(), to_string(domain.a()), to_string(domain.b()),
                       numbers_text(*written.find("knots")), control_points_text(written));
}

/// "to": "bspline", "interval"?
Target::Convert read_bspline_target(Fields& request, const Limits& limits) {
    return [wanted = read_wanted_interval(request, limits)](const PolynomialMap& map, const Interval& own,
                                                            const Limits& allowed) -> AnyMap {
        const BezierCurve curve = control_points(map, wanted.value_or(own), allowed);
        return join(std::span(&curve, 1), allowed);
    };
}

Members bspline_members() {
    return control_point_members({required("degree", ValueKind::count, "the degree n"),
                                  required("knots", written_list(ValueKind::number),
                                           "a non-decreasing list of numbers, each at most n + 1 times")});
}

}  // namespace

constinit const Kind bspline_kind{
    .name = "bspline",
    .words = {{{"bspline", read_bspline, bspline_members,
                "A B-spline curve; with weights, a rational one (NURBS)."}}},
    .write = write_value<BSplineCurve, write>,
    .formula = formula_of_value<BSplineCurve, formula>,
    .target = {"bspline", read_bspline_target, true},
};

}  // namespace blossom::protocol
