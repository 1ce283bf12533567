#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/graph.hpp>
#include <blossom/core/spline/greville.hpp>
#include <blossom/core/spline/spline_elevation.hpp>

#include <algorithm>
#include <vector>

#include "spline_pieces.hpp"

namespace blossom {

namespace {

std::vector<Coordinates> with_first(const std::vector<Rational>& first,
                                    const std::vector<Coordinates>& points) {
    std::vector<Coordinates> result;
    result.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        Coordinates point{first[k]};
        point.insert(point.end(), points[k].begin(), points[k].end());
        result.push_back(std::move(point));
    }
    return result;
}

/// (t, P) whose first coordinate is t times the weight w.
PolynomialCurve weighted_graph(const PolynomialCurve& curve) {
    std::vector<Polynomial> coordinates{Polynomial::monomial(1) * curve.coordinate(curve.dimension() - 1)};
    for (std::size_t j = 0; j < curve.dimension(); ++j) coordinates.push_back(curve.coordinate(j));
    return PolynomialCurve(coordinates, curve.degree() + 1);
}

}  // namespace

PolynomialCurve graph(const PolynomialCurve& curve, GraphForm form, const Limits& limits) {
    require_within(curve.degree() + 1, limits.degree, "degree", "the degree of the graph");
    if (form == GraphForm::homogeneous) return weighted_graph(curve);
    std::vector<Polynomial> coordinates{Polynomial::monomial(1)};
    for (std::size_t j = 0; j < curve.dimension(); ++j) coordinates.push_back(curve.coordinate(j));
    return PolynomialCurve(coordinates, std::max<std::size_t>(curve.degree(), 1));
}

BezierCurve graph(const BezierCurve& curve, GraphForm form, const Limits& limits) {
    const Interval& interval = curve.interval();
    if (form == GraphForm::homogeneous) {
        return control_points(graph(monomial_form(curve, limits), form, limits), interval, limits);
    }
    const std::size_t n = std::max<std::size_t>(curve.degree(), 1);
    const BezierCurve raised = elevate(curve, n - curve.degree(), limits);
    std::vector<Rational> abscissae;
    for (std::size_t k = 0; k <= n; ++k) {
        abscissae.push_back((Rational(n - k) * interval.a() + Rational(k) * interval.b()) / Rational(n));
    }
    return BezierCurve(with_first(abscissae, raised.control_points().to_points()), interval);
}

BSplineCurve graph(const BSplineCurve& curve, GraphForm form, const Limits& limits) {
    if (form == GraphForm::homogeneous || curve.degree() == 0) {
        const BSplineCurve raised = elevate(curve, 1, limits);
        if (form == GraphForm::points) return graph(raised, form, limits);
        std::vector<BezierCurve> pieces = bezier_segments(curve, limits);
        for (BezierCurve& piece : pieces) piece = graph(piece, form, limits);
        return spline_of_pieces(raised.knots(), pieces, limits);
    }
    return {curve.knots(), with_first(greville_abscissae(curve.knots()), curve.control_points())};
}

}  // namespace blossom
