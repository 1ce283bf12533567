#include "maps/kinds.hpp"

namespace blossom::cli {

namespace {

/// (w_i P_i, w_i) for every control point.
void append_weights(std::vector<Coordinates>& points, const std::vector<Rational>& weights) {
    if (weights.size() != points.size()) {
        throw Error(ErrorCode::wrong_arity, std::to_string(weights.size()) + " weights for " +
                                                std::to_string(points.size()) +
                                                " control points; one each is needed");
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (weights[i].is_zero()) {
            throw Error(ErrorCode::zero_weight,
                        "weight " + std::to_string(i) +
                            " is 0; with \"homogeneous\": true, points carry their weight and "
                            "may have weight 0",
                        "/" + std::to_string(i));
        }
        for (Rational& coordinate : points[i]) coordinate *= weights[i];
        points[i].push_back(weights[i]);
    }
}

}  // namespace

Map read_bezier(Fields& fields, const Limits& limits) {
    Points points =
        fields.required("control_points", [&](const Json& value) { return read_points(value, limits); });
    const auto interval =
        fields.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    const auto weights =
        fields.optional("weights", [&](const Json& value) { return read_numbers(value, limits); });
    const auto degree =
        fields.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    PointForm form{.scalar = points.scalar};
    if (read_homogeneous(fields)) {
        if (weights) {
            throw Error(
                ErrorCode::wrong_kind,
                R"(with "homogeneous": true the control points carry their weights; leave "weights" out)",
                "/weights");
        }
        form = within("control_points", [&] { return homogeneous_form(points); });
    } else if (weights) {
        form.rational = true;
        within("weights", [&] { append_weights(points.points, *weights); });
    }
    if (degree && *degree + 1 != points.points.size()) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(points.points.size()) + " control points make the degree " +
                        std::to_string(points.points.size() - 1) + ", not " + std::to_string(*degree),
                    "/degree");
    }
    return {BezierCurve(points.points, interval.value_or(Interval())), form};
}

Json bezier_to_json(const BezierCurve& curve, const PointForm& form) {
    Json::Array points;
    Json::Array weights;
    const bool weighted = form.rational && !form.homogeneous;
    for (const Coordinates& point : curve.control_points().to_points()) {
        points.push_back(to_json(point, form));
        if (weighted) weights.emplace_back(point.back());
    }
    Json map = Json::Object{{"kind", "bezier"},
                            {"degree", curve.degree()},
                            {"interval", to_json(curve.interval())},
                            {"control_points", std::move(points)}};
    if (weighted) map["weights"] = std::move(weights);
    if (form.homogeneous) map["homogeneous"] = true;
    return map;
}

}  // namespace blossom::cli
