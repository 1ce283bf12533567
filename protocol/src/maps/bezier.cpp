#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>

#include "kinds.hpp"

namespace blossom::protocol {

Map read_bezier(Fields& fields, const Limits& limits) {
    WeightedPoints read = read_control_points(fields, limits);
    const auto interval =
        fields.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    check_degree(fields, read.points.size(), limits);
    within("control_points", [&] { require_degree(read.points.size(), limits); });
    return {BezierCurve(read.points, interval.value_or(Interval())), read.form};
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

}  // namespace blossom::protocol
