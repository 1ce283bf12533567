#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <optional>
#include <string>

#include "spline_pieces.hpp"

namespace blossom {

namespace {

std::string text(const Interval& interval) {
    return "[" + to_string(interval.a()) + ", " + to_string(interval.b()) + "]";
}

BezierCurve increasing(const BezierCurve& curve) {
    if (curve.interval().a() < curve.interval().b()) return curve;
    std::vector<Coordinates> points = curve.control_points().to_points();
    std::ranges::reverse(points);
    return BezierCurve(points, Interval(curve.interval().b(), curve.interval().a()));
}

std::size_t greatest_degree(std::span<const BezierCurve> curves) {
    if (curves.empty()) throw Error(ErrorCode::wrong_arity, "at least one curve is needed", Part::maps);
    return std::ranges::max_element(curves, {}, &BezierCurve::degree)->degree();
}

/// The curves raised to degree n over increasing intervals, each of which begins where the previous one ends.
std::vector<BezierCurve> raised_pieces(std::span<const BezierCurve> curves, std::size_t n,
                                       const Limits& limits) {
    std::vector<BezierCurve> pieces;
    pieces.reserve(curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].dimension() != curves.front().dimension()) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "map " + std::to_string(i) + " has " + std::to_string(curves[i].dimension()) +
                            " coordinates, map 0 has " + std::to_string(curves.front().dimension()),
                        Part::maps / i / Part::control_points);
        }
        pieces.push_back(elevate(increasing(curves[i]), n - curves[i].degree(), limits));
        if (i == 0 || pieces[i].interval().a() == pieces[i - 1].interval().b()) continue;
        throw Error(ErrorCode::not_adjacent,
                    "the interval " + text(pieces[i].interval()) + " of map " + std::to_string(i) +
                        " does not begin where " + text(pieces[i - 1].interval()) + " of map " +
                        std::to_string(i - 1) + " ends",
                    Part::maps / i / Part::interval);
    }
    return pieces;
}

void require_continuous(std::span<const BezierCurve> pieces, const KnotVector& knots, const Limits& limits) {
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const Rational& joint = pieces[i].interval().a();
        const std::size_t multiplicity = knots.multiplicity(joint);
        if (multiplicity > knots.degree()) continue;
        const Contact joined = contact(pieces[i - 1], pieces[i], joint, limits);
        const auto needed = static_cast<std::ptrdiff_t>(knots.degree() - multiplicity);
        if (joined.is_infinite() || *joined.order >= needed) continue;
        throw Error(ErrorCode::not_continuous,
                    "multiplicity " + std::to_string(multiplicity) + " of the knot " + to_string(joint) +
                        " in degree " + std::to_string(knots.degree()) + " needs order " +
                        std::to_string(needed) + " of maps " + std::to_string(i - 1) + " and " +
                        std::to_string(i) + ". " + to_string(joined, joint),
                    Part::maps / i);
    }
}

}  // namespace

BSplineCurve join(std::span<const BezierCurve> curves, const Limits& limits) {
    const std::size_t n = greatest_degree(curves);
    const std::vector<BezierCurve> pieces = raised_pieces(curves, n, limits);
    std::vector<Rational> knots(n + 1, pieces.front().interval().a());
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const Rational& joint = pieces[i].interval().a();
        const Contact joined = contact(pieces[i - 1], pieces[i], joint, limits);
        if (joined.is_infinite()) continue;
        const auto multiplicity = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(n) - *joined.order);
        knots.insert(knots.end(), multiplicity, joint);
    }
    knots.insert(knots.end(), n + 1, pieces.back().interval().b());
    const std::size_t points = knots.size() - n - 1;
    require_within(points * pieces.front().dimension(), limits.numbers, "numbers",
                   "the number of coordinates", Part::maps);
    return spline_of_pieces({n, std::move(knots), points}, pieces, limits);
}

BSplineCurve join(std::span<const BezierCurve> curves, const KnotVector& knots, const Limits& limits) {
    const std::size_t greatest = greatest_degree(curves);
    if (knots.degree() < greatest) {
        throw Error(ErrorCode::degree_too_low,
                    "knots of degree " + std::to_string(knots.degree()) + " cannot carry a curve of degree " +
                        std::to_string(greatest),
                    Part::knots);
    }
    const std::vector<BezierCurve> pieces = raised_pieces(curves, knots.degree(), limits);
    const Interval covered(pieces.front().interval().a(), pieces.back().interval().b());
    if (knots.domain() != covered) {
        throw Error(ErrorCode::bad_knots,
                    "the domain " + text(knots.domain()) + " of the knots is not " + text(covered) +
                        ", which the maps make up",
                    Part::knots);
    }
    require_continuous(pieces, knots, limits);
    return spline_of_pieces(knots, pieces, limits);
}

KnotVector knots_over(std::size_t degree, std::vector<Rational> knots, const Interval& domain) {
    std::optional<Error> refused;
    const auto over_domain = [&](std::size_t points) -> std::optional<KnotVector> {
        if (points <= degree) return std::nullopt;
        try {
            KnotVector result(degree, knots, points);
            if (result.domain() == domain) return result;
        } catch (const Error& error) {
            refused = error;
        }
        return std::nullopt;
    };
    if (knots.size() > degree && knots.size() - degree > 1) {
        if (auto textbook = over_domain(knots.size() - degree - 1)) return *textbook;
    }
    if (degree > 0 && knots.size() + 1 > degree) {
        if (auto polar = over_domain(knots.size() + 1 - degree)) return *polar;
    }
    if (refused) throw Error(*refused);
    throw Error(ErrorCode::bad_knots,
                std::to_string(knots.size()) + " knots of degree " + std::to_string(degree) +
                    " have the domain " + text(domain) + " in neither convention",
                Part::knots);
}

}  // namespace blossom
