#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "progressive_frame.hpp"

namespace blossom {

namespace {

Coordinates value_on_span(const BSplineCurve& curve, std::size_t span, std::span<const Argument> arguments,
                          const Limits& limits) {
    return ProgressiveFrame(curve.knots().around(span), curve.points_of(span), limits).value(arguments);
}

Coordinates scaled_difference(const Coordinates& end, const Coordinates& begin, const Rational& scale) {
    Coordinates difference;
    difference.reserve(end.size());
    for (std::size_t i = 0; i < end.size(); ++i) difference.push_back((end[i] - begin[i]) * scale);
    return difference;
}

BSplineCurve zero_of_degree_zero(const BSplineCurve& curve) {
    return {curve.knots(),
            std::vector<Coordinates>(curve.control_points().size(), Coordinates(curve.dimension()))};
}

// In the polar convention of degree 1, all knots lie in the domain, and they are the textbook knots of degree
// 0.
BSplineCurve first_derivative(const BSplineCurve& curve) {
    const std::size_t n = curve.degree();
    const KnotVector& knots = curve.knots();
    const auto& points = curve.control_points();
    const bool keep_ends = n == 1 && knots.convention() == KnotConvention::polar;
    std::vector<Rational> remaining;
    std::vector<Coordinates> differences;
    remaining.reserve(knots.size());
    differences.reserve(points.size());
    if (keep_ends) remaining.push_back(knots[0]);
    for (std::size_t i = 1; i < knots.window_index(1); ++i) remaining.push_back(knots[i]);
    for (std::size_t j = 0; j + 1 < points.size(); ++j) {
        const std::size_t begin = knots.window_index(j);
        const Rational length = knots[begin + n] - knots[begin];
        if (length.is_zero()) continue;
        differences.push_back(scaled_difference(points[j + 1], points[j], Rational(n) / length));
        remaining.push_back(knots[begin + 1]);
    }
    for (std::size_t i = knots.window_index(points.size()); i + 1 < knots.size(); ++i)
        remaining.push_back(knots[i]);
    return {n - 1, std::move(remaining), std::move(differences)};
}

}  // namespace

ProgressiveCurve segment(const BSplineCurve& curve, std::size_t span) {
    curve.knots().require_span(span);
    const auto knots = curve.knots().around(span);
    return {{knots.begin(), knots.end()}, curve.points_of(span)};
}

std::size_t only_span(const KnotVector& knots) {
    const std::vector<std::size_t> spans = knots.spans();
    if (spans.size() == 1) return spans.front();
    throw Error(ErrorCode::outside_domain,
                "the curve has " + std::to_string(spans.size()) + " segments, on spans " +
                    std::to_string(spans.front()) + " to " + std::to_string(spans.back()) +
                    "; one must be named",
                Part::segment);
}

Coordinates segment_blossom(const BSplineCurve& curve, std::size_t span, std::span<const Argument> arguments,
                            const Limits& limits) {
    curve.knots().require_span(span);
    if (arguments.size() != curve.degree()) {
        throw Error(ErrorCode::wrong_arity,
                    "the blossom of a curve of degree " + std::to_string(curve.degree()) + " takes " +
                        std::to_string(curve.degree()) + " arguments, not " +
                        std::to_string(arguments.size()),
                    Part::arguments);
    }
    return value_on_span(curve, span, arguments, limits);
}

Coordinates de_boor(const BSplineCurve& curve, const Parameter& t, const Limits& limits) {
    const std::size_t span = curve.knots().span_at(t.value);
    return value_on_span(curve, span, with_copies({}, curve.degree(), t), limits);
}

Coordinates derivative(const BSplineCurve& curve, std::size_t order, const Parameter& t,
                       const Limits& limits) {
    const std::size_t n = curve.degree();
    const std::size_t span = curve.knots().span_at(t.value);
    if (order > n) return Coordinates(curve.dimension());
    Coordinates value =
        value_on_span(curve, span, with_copies(with_copies({}, n - order, t), order, delta), limits);
    const Integer factor = falling_factorial(n, order);
    for (Rational& coordinate : value) coordinate *= factor;
    return value;
}

BSplineCurve derivative_curve(const BSplineCurve& curve, std::size_t order, const Limits& limits) {
    require_within(curve.degree(), limits.degree, "degree", "the formal degree", Part::degree);
    BSplineCurve result = curve;
    for (std::size_t k = 0; k < order; ++k) {
        if (result.degree() == 0) return zero_of_degree_zero(result);
        result = first_derivative(result);
    }
    return result;
}

}  // namespace blossom
