#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>

#include "kinds.hpp"

namespace blossom::protocol {

Map read_bspline(Fields& fields, const Limits& limits) {
    if (fields.has("degrees")) return read_tensor_bspline(fields, limits);
    const std::size_t degree =
        fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    std::vector<Rational> knots =
        fields.required("knots", [&](const Json& value) { return read_numbers(value, limits); });
    WeightedPoints read = read_control_points(fields, limits);
    return {BSplineCurve(degree, std::move(knots), std::move(read.points)), read.form};
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

}  // namespace blossom::protocol
