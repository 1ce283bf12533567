#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/curve/reparametrisation.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <optional>
#include <string>

#include "joined_pieces.hpp"
#include "spline_pieces.hpp"

namespace blossom {

namespace {

std::string text(const Interval& interval) {
    return "[" + to_string(interval.a()) + ", " + to_string(interval.b()) + "]";
}

std::size_t greatest_degree(std::span<const JoinedPiece> pieces) {
    std::size_t greatest = 0;
    for (const JoinedPiece& piece : pieces) greatest = std::max(greatest, piece.curve.degree());
    return greatest;
}

void raise(std::vector<JoinedPiece>& pieces, std::size_t n, const Limits& limits) {
    for (auto& [curve, map] : pieces) curve = elevate(curve, n - curve.degree(), limits);
}

std::vector<BezierCurve> curves_of(std::vector<JoinedPiece> pieces) {
    std::vector<BezierCurve> curves;
    curves.reserve(pieces.size());
    for (auto& [curve, map] : pieces) curves.push_back(std::move(curve));
    return curves;
}

/// Each curve as one piece.
std::vector<std::vector<BezierCurve>> one_piece_each(std::span<const BezierCurve> curves) {
    std::vector<std::vector<BezierCurve>> maps;
    maps.reserve(curves.size());
    for (const BezierCurve& curve : curves) maps.push_back({curve});
    return maps;
}

std::string maps_text(const JoinedPiece& left, const JoinedPiece& right) {
    if (left.map == right.map) return "the segments of map " + std::to_string(left.map);
    return "maps " + std::to_string(left.map) + " and " + std::to_string(right.map);
}

void require_continuous(std::span<const JoinedPiece> pieces, const KnotVector& knots, const Reason& reason,
                        const Limits& limits) {
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const BezierCurve& left = pieces[i - 1].curve;
        const BezierCurve& right = pieces[i].curve;
        const Rational& joint = right.interval().a();
        const std::size_t multiplicity = knots.multiplicity(joint);
        if (multiplicity > knots.degree()) continue;
        const Contact joined = contact(left, right, joint, limits);
        const std::size_t needed = knots.degree() - multiplicity;
        if (joined.is_infinite() || *joined.order >= static_cast<std::ptrdiff_t>(needed)) continue;
        throw Error(ErrorCode::not_continuous,
                    "multiplicity " + std::to_string(multiplicity) + " of the knot " + to_string(joint) +
                        " in degree " + std::to_string(knots.degree()) + " needs order " +
                        std::to_string(needed) + " of " + maps_text(pieces[i - 1], pieces[i]) + ". " +
                        reason(left, right, joint, joined),
                    Part::maps / pieces[i].map);
    }
}

/// The curve in some of its coordinates.
BezierCurve coordinates_from(const BezierCurve& curve, std::size_t first, std::size_t count) {
    const auto begin = static_cast<std::ptrdiff_t>(first);
    std::vector<Coordinates> points = curve.control_points().to_points();
    for (Coordinates& point : points)
        point = {point.begin() + begin, point.begin() + begin + static_cast<std::ptrdiff_t>(count)};
    return BezierCurve(points, curve.interval());
}

std::string reason_of_polynomials(const BezierCurve& /*left*/, const BezierCurve& /*right*/,
                                  const Rational& s, const Contact& contact) {
    return to_string(contact, s);
}

}  // namespace

std::vector<JoinedPiece> adjacent_pieces(std::span<const std::vector<BezierCurve>> maps) {
    if (maps.empty()) throw Error(ErrorCode::wrong_arity, "at least one curve is needed", Part::maps);
    std::vector<JoinedPiece> pieces;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        for (const BezierCurve& piece : maps[i]) {
            if (piece.dimension() != maps.front().front().dimension()) {
                throw Error(ErrorCode::mismatched_dimensions,
                            "map " + std::to_string(i) + " has " + std::to_string(piece.dimension()) +
                                " coordinates, map 0 has " + std::to_string(maps.front().front().dimension()),
                            Part::maps / i / Part::control_points);
            }
            BezierCurve next = increasing(piece);
            if (!pieces.empty() && next.interval().a() != pieces.back().curve.interval().b()) {
                throw Error(ErrorCode::not_adjacent,
                            "the interval " + text(covered(maps[i])) + " of map " + std::to_string(i) +
                                " does not begin where " + text(covered(maps[pieces.back().map])) +
                                " of map " + std::to_string(pieces.back().map) + " ends",
                            Part::maps / i / Part::interval);
            }
            pieces.push_back({std::move(next), i});
        }
    }
    return pieces;
}

BSplineCurve joined(std::vector<JoinedPiece> pieces, const Limits& limits) {
    const std::size_t n = greatest_degree(pieces);
    raise(pieces, n, limits);
    const std::vector<BezierCurve> curves = curves_of(std::move(pieces));
    std::vector<Rational> knots(n + 1, curves.front().interval().a());
    for (std::size_t i = 1; i < curves.size(); ++i) {
        const Rational& joint = curves[i].interval().a();
        const Contact met = contact(curves[i - 1], curves[i], joint, limits);
        if (met.is_infinite()) continue;
        const auto multiplicity = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(n) - *met.order);
        knots.insert(knots.end(), multiplicity, joint);
    }
    knots.insert(knots.end(), n + 1, curves.back().interval().b());
    const std::size_t points = knots.size() - n - 1;
    require_within(points * curves.front().dimension(), limits.numbers, "numbers",
                   "the number of coordinates", Part::maps);
    return spline_of_pieces({n, std::move(knots), points}, curves, limits);
}

BSplineCurve joined(std::vector<JoinedPiece> pieces, const KnotVector& knots, const Reason& reason,
                    const Limits& limits) {
    const std::size_t greatest = greatest_degree(pieces);
    if (knots.degree() < greatest) {
        throw Error(ErrorCode::degree_too_low,
                    "knots of degree " + std::to_string(knots.degree()) + " cannot carry a curve of degree " +
                        std::to_string(greatest),
                    Part::knots);
    }
    const Interval whole(pieces.front().curve.interval().a(), pieces.back().curve.interval().b());
    if (knots.domain() != whole) {
        throw Error(ErrorCode::bad_knots,
                    "the domain " + text(knots.domain()) + " of the knots is not " + text(whole) +
                        ", which the maps make up",
                    Part::knots);
    }
    raise(pieces, knots.degree(), limits);
    require_continuous(pieces, knots, reason, limits);
    return spline_of_pieces(knots, curves_of(std::move(pieces)), limits);
}

Interval covered(std::span<const BezierCurve> pieces) {
    const Interval& first = pieces.front().interval();
    const Interval& last = pieces.back().interval();
    return {std::min(first.a(), first.b()), std::max(last.a(), last.b())};
}

std::vector<std::vector<BezierCurve>> chained(std::vector<std::vector<BezierCurve>> maps) {
    for (std::size_t i = 1; i < maps.size(); ++i) {
        const Interval own = covered(maps[i]);
        const Rational begin = covered(maps[i - 1]).b();
        const ParameterChange change(own, {begin, begin + own.b() - own.a()});
        for (BezierCurve& piece : maps[i]) piece = reparametrised(piece, change);
    }
    return maps;
}

BSplineCurve join(std::span<const std::vector<BezierCurve>> maps, const Limits& limits) {
    return joined(adjacent_pieces(maps), limits);
}

BSplineCurve join(std::span<const std::vector<BezierCurve>> maps, const KnotVector& knots,
                  const Limits& limits) {
    return joined(adjacent_pieces(maps), knots, reason_of_polynomials, limits);
}

Reason reason_of_rows(std::size_t rows) {
    return
        [rows](const BezierCurve& left, const BezierCurve& right, const Rational& s, const Contact& contact) {
            const std::size_t dimension = left.dimension() / rows;
            for (std::size_t row = 0; row < rows; ++row) {
                const Contact own = blossom::contact(coordinates_from(left, row * dimension, dimension),
                                                     coordinates_from(right, row * dimension, dimension), s);
                if (own.order == contact.order)
                    return "In row " + std::to_string(row) + ": " + to_string(own, s);
            }
            return to_string(contact, s);
        };
}

BSplineCurve join_rows(std::span<const std::vector<BezierCurve>> maps, std::size_t rows,
                       const KnotVector& knots, const Limits& limits) {
    return joined(adjacent_pieces(maps), knots, reason_of_rows(rows), limits);
}

BSplineCurve join(std::span<const BezierCurve> curves, const Limits& limits) {
    return join(one_piece_each(curves), limits);
}

BSplineCurve join(std::span<const BezierCurve> curves, const KnotVector& knots, const Limits& limits) {
    return join(one_piece_each(curves), knots, limits);
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
