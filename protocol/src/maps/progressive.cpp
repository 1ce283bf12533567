#include <fmt/format.h>

#include "kind.hpp"

namespace blossom::protocol {

namespace {

/// {"kind": "progressive", "knots", "control_points", "weights"?, "degree"?, "homogeneous"?}
Map read_progressive(Fields& fields, const Limits& limits) {
    std::vector<Rational> knots =
        fields.required("knots", [&](const Json& value) { return read_numbers(value, limits); });
    const WeightedPoints read = read_control_points(fields, limits);
    check_degree(fields, read.points.size(), limits);
    within("control_points", [&] { require_degree(read.points.size(), limits); });
    return {ProgressiveCurve(std::move(knots), read.points.list()), read.form};
}

Json write(const ProgressiveCurve& curve, const PointForm& form) {
    Json map = Json::Object{{"kind", "progressive"},
                            {"degree", curve.degree()},
                            {"knots", Json::Array(curve.knots().begin(), curve.knots().end())}};
    write_control_points(map, curve.control_points().to_points(), form);
    return map;
}

std::string formula(const ProgressiveCurve& curve, const Map& map, std::string_view name) {
    const Json written = write(curve, map.form);
    return fmt::format("{}: progressive curve of degree {}, knots {}, control points {}", name,
                       curve.degree(), numbers_text(*written.find("knots")), control_points_text(written));
}

Members progressive_members() {
    return control_point_members(
        {required("knots", Shape::list(ValueKind::number),
                  "2n numbers in any order; control point j is the value of the blossom at the knots j, ..., "
                  "j + n - 1"),
         defaulted("degree", ValueKind::count, "the degree n, one less than the number of control points")});
}

}  // namespace

constinit const Kind progressive_kind{
    .name = "progressive",
    .words = {{{"progressive", read_progressive, progressive_members,
                "One polynomial by control points that are blossom values at consecutive knots."}}},
    .write = write_value<ProgressiveCurve, write>,
    .formula = formula_of_value<ProgressiveCurve, formula>,
};

}  // namespace blossom::protocol
