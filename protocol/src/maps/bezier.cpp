#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/rational/number_text.hpp>

#include "kind.hpp"

namespace blossom::protocol {

namespace {

/// {"kind": "bezier", "control_points", "interval"?, "weights"?, "degree"?, "homogeneous"?}
Map read_bezier(Fields& fields, const Limits& limits) {
    WeightedPoints read = read_control_points(fields, limits);
    const auto interval =
        fields.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    check_degree(fields, read.points.size(), limits);
    within("control_points", [&] { require_degree(read.points.size(), limits); });
    return {BezierCurve(read.points.array(), interval.value_or(Interval())), read.form};
}

Json write(const BezierCurve& curve, const PointForm& form) {
    Json map =
        Json::Object{{"kind", "bezier"}, {"degree", curve.degree()}, {"interval", to_json(curve.interval())}};
    write_control_points(map, curve.control_points().to_points(), form);
    return map;
}

std::string formula(const BezierCurve& curve, const Map& map, std::string_view name) {
    return fmt::format("{}: control points over [{}, {}]: {}", name, to_string(curve.interval().a()),
                       to_string(curve.interval().b()), control_points_text(write(curve, map.form)));
}

/// "to": "bernstein", "interval"?
Target::Convert read_bernstein_target(Fields& request, const Limits& limits) {
    return [wanted = read_wanted_interval(request, limits)](const PolynomialMap& map, const Interval& own,
                                                            const Limits& allowed) -> AnyMap {
        return control_points(map, wanted.value_or(own), allowed);
    };
}

std::string bezier_degree(const Map& map) {
    return ", degree " + std::to_string(std::get<BezierCurve>(map.value).degree());
}

Members bezier_members() {
    return control_point_members(
        {defaulted(
             "interval", ValueKind::interval,
             "the interval `[a, b]` of the parameter, by default `[0, 1]`; a > b is allowed, a = b is not"),
         defaulted("degree", ValueKind::count, "one less than the number of control points")});
}

}  // namespace

constinit const Kind bezier_kind{
    .name = "bezier",
    .words = {{{"bezier", read_bezier, bezier_members, "A polynomial curve, given by its control points."}}},
    .write = write_value<BezierCurve, write>,
    .formula = formula_of_value<BezierCurve, formula>,
    .target = {"bernstein", read_bernstein_target, true},
    .degree_text = bezier_degree,
};

}  // namespace blossom::protocol
