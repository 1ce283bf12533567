#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/core/spline/progressive.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <utility>

#include "tensor_rows.hpp"

namespace blossom {

namespace {

void require_directions(const TensorBSpline& spline, std::size_t given, Part part) {
    if (given == spline.directions()) return;
    throw Error(ErrorCode::wrong_arity,
                std::to_string(given) + " entries for " + std::to_string(spline.directions()) + " directions",
                part);
}

/// The control points of the box of spans only.
PointGrid cropped(const TensorBSpline& spline, std::span<const std::size_t> spans) {
    require_directions(spline, spans.size(), Part::segment);
    std::vector<std::size_t> places{0};
    PointGrid grid;
    for (std::size_t d = 0; d < spans.size(); ++d) {
        const KnotVector& knots = spline.knots(d);
        knots.require_span(spans[d]);
        grid.counts.push_back(knots.degree() + 1);
        std::vector<std::size_t> finer;
        for (const std::size_t place : places) {
            for (std::size_t i = 0; i <= knots.degree(); ++i)
                finer.push_back(place * knots.points() + knots.first_point(spans[d]) + i);
        }
        places = std::move(finer);
    }
    for (const std::size_t place : places) grid.points.push_back(spline.control_points()[place]);
    return grid;
}

ProgressiveCurve progressive(const KnotVector& knots, std::size_t span, std::span<const Coordinates> points) {
    const auto around = knots.around(span);
    return {{around.begin(), around.end()}, points};
}

}  // namespace

TensorBSpline::TensorBSpline(std::vector<KnotVector> knots, std::vector<Coordinates> control_points)
    : knots_(std::move(knots)), control_points_(std::move(control_points)) {
    if (knots_.empty())
        throw Error(ErrorCode::wrong_arity, "a tensor product has at least one direction", Part::knots);
    std::size_t count = 1;
    for (const KnotVector& own : knots_) {
        if (__builtin_mul_overflow(count, own.points(), &count)) count = 0;
    }
    if (count != control_points_.size()) {
        throw Error(ErrorCode::wrong_arity,
                    "the knots are for " + std::to_string(count) + " control points, not " +
                        std::to_string(control_points_.size()),
                    Part::control_points);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (control_points_[i].size() == dimension() && dimension() > 0) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "control point " + std::to_string(i) + " has " +
                        std::to_string(control_points_[i].size()) +
                        " coordinates; every point needs the same number, at least 1",
                    Part::control_points / i);
    }
}

std::vector<std::size_t> spans_at(const TensorBSpline& spline, std::span<const Rational> parameters) {
    require_directions(spline, parameters.size(), Part::at);
    std::vector<std::size_t> spans;
    for (std::size_t d = 0; d < parameters.size(); ++d) {
        try {
            spans.push_back(spline.knots(d).span_at(parameters[d]));
        } catch (const Error& error) {
            throw error.at(Part::at / d);
        }
    }
    return spans;
}

Coordinates segment_blossom(const TensorBSpline& spline, std::span<const std::size_t> spans,
                            std::span<const std::vector<Argument>> arguments, const Limits& limits) {
    require_directions(spline, arguments.size(), Part::arguments);
    PointGrid grid = cropped(spline, spans);
    for (std::size_t d = spans.size(); d-- > 0;) {
        grid = along_rows(grid, d, [&](const std::vector<Coordinates>& points) {
            const ProgressiveCurve row = progressive(spline.knots(d), spans[d], points);
            return std::vector<Coordinates>(1, blossom_value(row, arguments[d], limits));
        });
    }
    return std::move(grid.points.front());
}

Coordinates evaluate(const TensorBSpline& spline, std::span<const Rational> parameters,
                     const Limits& limits) {
    const std::vector<std::size_t> orders(spline.directions());
    return derivative(spline, orders, parameters, limits);
}

Coordinates derivative(const TensorBSpline& spline, std::span<const std::size_t> orders,
                       std::span<const Rational> parameters, const Limits& limits) {
    require_directions(spline, orders.size(), Part::order);
    const std::vector<std::size_t> spans = spans_at(spline, parameters);
    std::vector<std::vector<Argument>> arguments;
    Integer factor = 1;
    for (std::size_t d = 0; d < orders.size(); ++d) {
        const std::size_t n = spline.knots(d).degree();
        if (orders[d] > n) return Coordinates(spline.dimension());
        factor *= falling_factorial(n, orders[d]);
        arguments.push_back(
            with_copies(with_copies({}, n - orders[d], Parameter(parameters[d])), orders[d], delta));
    }
    Coordinates value = segment_blossom(spline, spans, arguments, limits);
    for (Rational& coordinate : value) coordinate *= factor;
    return value;
}

TensorBSpline insert_knots(const TensorBSpline& spline, std::size_t direction,
                           std::span<const Rational> knots, const Limits& limits) {
    const std::size_t rows = spline.control_points().size() / spline.knots(direction).points();
    require_product_within({spline.knots(direction).points() + knots.size(), rows, spline.dimension()},
                           limits.numbers, "numbers", "the number of coordinates of the result", Part::knots);
    return with_rows(spline, direction,
                     [&](const BSplineCurve& row) { return insert_knots(row, knots, limits); });
}

BezierPatch bezier_segment(const TensorBSpline& spline, std::span<const std::size_t> spans,
                           const Limits& limits) {
    PointGrid grid = cropped(spline, spans);
    const std::vector<Interval> box = box_of(spline, spans);
    std::vector<std::size_t> degrees;
    for (std::size_t d = 0; d < spans.size(); ++d) {
        degrees.push_back(spline.knots(d).degree());
        grid = along_rows(grid, d, [&](const std::vector<Coordinates>& points) {
            return control_points(progressive(spline.knots(d), spans[d], points), box[d], limits)
                .control_points()
                .to_points();
        });
    }
    return {NetShape::tensor(degrees, limits), grid.points};
}

std::vector<Interval> box_of(const TensorBSpline& spline, std::span<const std::size_t> spans) {
    std::vector<Interval> box;
    box.reserve(spans.size());
    for (std::size_t d = 0; d < spans.size(); ++d) {
        box.emplace_back(spline.knots(d)[spans[d]], spline.knots(d)[spans[d] + 1]);
    }
    return box;
}

std::string to_string(const TensorBSpline& spline) {
    const auto knots_text = [](const KnotVector& knots) { return to_string(knots); };
    const auto point_text = [](const Coordinates& point) { return to_string(RationalVector(point)); };
    return joined(spline.knots(), knots_text, "; ") + "; control points " +
           joined(spline.control_points(), point_text);
}

}  // namespace blossom
