#include "pyramid.hpp"

#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/patch/curve_along.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include "control_nets.hpp"
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

/// The levels of a net over a simplex, each by one step of de Casteljau's algorithm.
Levels levels_over_simplex(const BezierPatch& patch, const Coordinates& at, const Limits& limits) {
    const SimplexFactor simplex = patch.shape()[0];
    require_numbers(multi_index_count(simplex.dimension + 1, simplex.degree, limits), patch.dimension(),
                    limits);
    Levels levels{patch.control_net().to_points()};
    for (std::size_t degree = simplex.degree; degree-- > 0;) {
        const std::vector<std::size_t> above = raised_positions(simplex.dimension, degree);
        std::vector<Coordinates> level;
        for (std::size_t i = 0; i < above.size(); i += at.size()) {
            Coordinates& point = level.emplace_back(patch.dimension());
            for (std::size_t k = 0; k < at.size(); ++k) {
                const Coordinates& old = levels.back()[above[i + k]];
                for (std::size_t j = 0; j < point.size(); ++j) point[j] += at[k] * old[j];
            }
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

/// The levels of a net in several directions, the last direction first; levels_of(d, rows) are those of the
/// curve along a direction.
template <class LevelsOf>
Levels levels_over_box(PlacedPatch net, const Limits& limits, const LevelsOf& levels_of) {
    std::size_t points = net.patch.shape().size();
    Levels levels{net.patch.control_net().to_points()};
    for (std::size_t d = net.frames.size(); d-- > 0;) {
        const std::size_t degree = net.patch.shape()[d].degree;
        points += net.patch.shape().size() / (degree + 1) * (degree * (degree + 1) / 2);
        require_numbers(points, net.patch.dimension(), limits);
        const BezierCurve rows = curve_along(net, d);
        const Levels of_rows = levels_of(d, rows);
        for (std::size_t r = 1; r < of_rows.size(); ++r) {
            net = with_curve_along(net, d, BezierCurve(of_rows[r], rows.interval()));
            levels.push_back(net.patch.control_net().to_points());
        }
    }
    return levels;
}

/// The pyramid at one parameter of a map.
struct PyramidAtPoint {
    std::span<const Rational> at;
    const Limits& limits;

    template <class Curve>
        requires std::is_invocable_v<const PyramidAt&, const Curve&>
    Levels operator()(const Curve& curve) const {
        return PyramidAt{at.front(), limits}(curve);
    }
    Levels operator()(const Patch& patch) const {
        const Patch net = as_net(patch, limits);
        const auto& points = std::get<BezierPatch>(net.map);
        if (!net.tensor) return levels_over_simplex(points, engine_arguments(net, at, 1).front(), limits);
        return levels_over_box({points, net.frames}, limits, [&](std::size_t d, const BezierCurve& rows) {
            return PyramidAt{at[d], limits}(rows);
        });
    }
    /// On the box of spans that `evaluate` uses.
    Levels operator()(const TensorBSpline& spline) const {
        const std::vector<std::size_t> spans = as_parameter(Part::at, [&] { return spans_at(spline, at); });
        std::vector<std::size_t> degrees;
        for (const KnotVector& knots : spline.knots()) degrees.push_back(knots.degree());
        const std::vector<Coordinates> points = points_of_box(spline, spans);
        return levels_over_box({BezierPatch(NetShape::tensor(degrees, limits), points),
                                std::vector(spans.size(), BarycentricFrame::standard(1))},
                               limits, [&](std::size_t d, const BezierCurve& rows) {
                                   const auto around = spline.knots(d).around(spans[d]);
                                   const ProgressiveCurve row({around.begin(), around.end()},
                                                              rows.control_points().to_points());
                                   return PyramidAt{at[d], limits}(row);
                               });
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

void add_pyramids(Json& result, const Map& map, const Parameters& parameters, const Limits& limits) {
    Json::Array pyramids;
    Json::Array weights;
    std::size_t nodes = 0;
    within("at", [&] {
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            within(i, [&] {
                const auto levels = dispatch_on_kind<Levels>(map, PyramidAtPoint{parameters[i], limits});
                for (const auto& level : levels) nodes += level.size();
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
