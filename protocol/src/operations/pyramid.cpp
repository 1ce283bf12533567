#include "pyramid.hpp"

#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include "maps/dispatch_on_kind.hpp"

namespace blossom::protocol {

namespace {

using Levels = std::vector<std::vector<Coordinates>>;

struct PyramidAt {
    const Rational& t;
    const Limits& limits;

    Levels operator()(const BezierCurve& curve) const {
        const auto arguments = with_copies({}, curve.degree(), Parameter(t));
        Levels levels;
        for (const PointArray& level : casteljau_pyramid(curve, arguments, limits).levels)
            levels.push_back(level.to_points());
        return levels;
    }
    Levels operator()(const PolynomialCurve& curve) const {
        return (*this)(control_points(curve, interval_of(curve), limits));
    }
    Levels operator()(const OnePolynomial auto& curve) const {
        return std::visit(*this, polynomial_map(curve, limits));
    }
    Levels operator()(const ProgressiveCurve& curve) const {
        return de_boor_pyramid(curve, with_copies({}, curve.degree(), Parameter(t)), limits);
    }
    Levels operator()(const BSplineCurve& curve) const {
        return (*this)(segment(curve, curve.knots().span_at(t)));
    }
};

void append_pyramid(const Levels& levels, const PointForm& form, Json::Array& pyramids,
                    Json::Array& weights) {
    Json::Array written;
    Json::Array written_weights;
    for (const auto& level : levels) {
        Json::Array points;
        Json::Array level_weights;
        for (const Coordinates& point : level) {
            points.push_back(to_json(point, form));
            level_weights.emplace_back(point.back());
        }
        written.emplace_back(std::move(points));
        written_weights.emplace_back(std::move(level_weights));
    }
    pyramids.emplace_back(std::move(written));
    weights.emplace_back(std::move(written_weights));
}

}  // namespace

void add_pyramids(Json& result, const Map& map, const std::vector<Rational>& parameters,
                  const Limits& limits) {
    Json::Array pyramids;
    Json::Array weights;
    std::size_t nodes = 0;
    within("at", [&] {
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            within(i, [&] {
                const auto levels = dispatch_on_kind<Levels>(map, PyramidAt{parameters[i], limits});
                nodes += levels.size() * (levels.size() + 1) / 2;
                require_numbers(nodes, dimension_of(map), limits);
                append_pyramid(levels, map.form, pyramids, weights);
            });
        }
    });
    result["pyramids"] = std::move(pyramids);
    if (map.form.separate_weights()) result["pyramid_weights"] = std::move(weights);
}

std::string pyramids_text(const Answered& answered) {
    const Json* pyramids = answered.result().find("pyramids");
    if (!pyramids) return "";
    const Json::Array& parameters = *answered.request.find("at")->array();
    std::string text;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        text += fmt::format("\nPyramid at {}, one level per line:\n", point_text(parameters[i]));
        for (const Json& level : *(*pyramids->array())[i].array()) {
            text += " ";
            for (const Json& point : *level.array()) text += " " + point_text(point);
            text += "\n";
        }
    }
    return text;
}

}  // namespace blossom::protocol
