// {"degree", "dimension", "control_points": all coordinates in one list, "knots"}

#include "foreign_formats.hpp"

namespace blossom::protocol {

namespace {

std::vector<ForeignSpline> read_tinyspline(const Json& document, Floats, const Limits& limits) {
    Fields fields(document);
    const std::size_t degree =
        fields.required("degree", [&](const Json& value) { return read_count(value, limits); });
    const std::size_t dimension =
        fields.required("dimension", [&](const Json& value) { return read_count(value, limits); });
    std::vector<Rational> knots = fields.required("knots", read_doubles);
    std::vector<Coordinates> points = fields.required("control_points", [&](const Json& value) {
        const std::vector<Rational> all = read_doubles(value);
        if (dimension == 0 || all.empty() || all.size() % dimension != 0) {
            throw Error(ErrorCode::mismatched_dimensions,
                        std::to_string(all.size()) + " coordinates do not make points of dimension " +
                            std::to_string(dimension));
        }
        std::vector<Coordinates> rows;
        for (auto begin = all.begin(); begin != all.end(); begin += static_cast<std::ptrdiff_t>(dimension))
            rows.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(dimension));
        return rows;
    });
    return {foreign_spline({{degree}, {std::move(knots)}, {}, std::move(points), std::nullopt},
                           {.degrees = {Part::degree},
                            .knots = {Part::knots},
                            .points = Part::control_points,
                            .flat_dimension = dimension})};
}

Json write_tinyspline(const std::vector<Map>& splines) {
    if (splines.size() != 1) {
        throw Error(ErrorCode::wrong_arity,
                    "a file of tinyspline holds one spline, not " + std::to_string(splines.size()));
    }
    const WrittenSpline written = written_spline(splines.front(), first_fastest(1));
    if (!written.weights.empty()) {
        throw Error(ErrorCode::wrong_kind,
                    "a file of tinyspline has no place for weights; with \"homogeneous\": true they are "
                    "coordinates");
    }
    Json::Array all;
    for (const Json& point : written.points)
        all.insert(all.end(), point.array()->begin(), point.array()->end());
    return Json::Object{{"degree", written.degrees.front()},
                        {"dimension", written.dimension},
                        {"control_points", std::move(all)},
                        {"knots", written.knots.front()}};
}

}  // namespace

constinit const ForeignFormat tinyspline_format{
    .name = "tinyspline", .read = read_tinyspline, .write = write_tinyspline, .curves_only = true};

}  // namespace blossom::protocol
