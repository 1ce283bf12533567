#include <blossom/core/queries/intersections.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <string>

#include "curve_pair.hpp"

namespace blossom {

namespace {

/// A rectangle around a piece; nullopt if it may be unbounded.
using Box = std::optional<std::vector<std::pair<Rational, Rational>>>;

Box box_of(const CurvePiece& piece, const Limits& limits) {
    const auto& [lower, upper] = piece.range;
    if (!lower || !upper || lower == upper || piece.weight().degree() > 0) return std::nullopt;
    std::vector<std::pair<Rational, Rational>> sides;
    const Rational weight = piece.weight()(0);
    for (std::size_t j = 0; j < piece.dimension(); ++j) {
        auto [least, greatest] = bounds(piece.coordinates[j], *lower, *upper, limits);
        sides.emplace_back(std::minmax(least / weight, greatest / weight));
    }
    return sides;
}

std::vector<Box> boxes_of(std::span<const CurvePiece> pieces, const Limits& limits) {
    std::vector<Box> boxes;
    for (const CurvePiece& piece : pieces) boxes.push_back(box_of(piece, limits));
    return boxes;
}

constexpr std::size_t words_of_box = 16;  ///< of a comparison of two boxes

bool are_apart(const Box& one, const Box& other) {
    if (!one || !other) return false;
    for (std::size_t j = 0; j < one->size(); ++j) {
        if ((*one)[j].second < (*other)[j].first || (*other)[j].second < (*one)[j].first) return true;
    }
    return false;
}

AlgebraicRange algebraic(const ParameterRange& range) {
    AlgebraicRange result;
    if (range.lower) result.lower = rational_root(*range.lower);
    if (range.upper) result.upper = rational_root(*range.upper);
    return result;
}

/// Collects the common points and parts of pairs of pieces.
class IntersectionSearch {
public:
    IntersectionSearch(const Rational& width, const Limits& limits) : width_(width), limits_(limits) {}

    void add(const CurvePiece& first, std::size_t i, const CurvePiece& second, std::size_t k) {
        if (is_point(first) || is_point(second)) {
            add_of_point(first, second);
            return;
        }
        const PairEquations equations = equations_of_common_points(first, second);
        const Polynomial of_first = equation_of_first(equations, first, limits_);
        if (of_first.is_zero()) {
            CommonParts parts = common_parts(first, second, equations, false, width_, limits_);
            std::ranges::move(parts.overlaps, std::back_inserter(found_.overlaps));
            add_meeting(first, i, parts.first, second, k, parts.second, most_in_common_parts);
            return;
        }
        const std::vector<Root> s = roots_in(first, of_first, width_, limits_);
        if (s.empty()) return;
        const Polynomial of_second = equation_of_second(equations, second, limits_);
        add_meeting(first, i, s, second, k, roots_in(second, of_second, width_, limits_));
    }

    /// A piece with itself.
    void add(const CurvePiece& piece, std::size_t i) {
        if (is_point(piece)) {
            found_.overlaps.push_back({algebraic(piece.range), algebraic(piece.range), false});
            return;
        }
        const PairEquations equations = equations_of_double_points(piece);
        const Polynomial places = equation_of_first(equations, piece, limits_);
        std::vector<Root> candidates;
        std::optional<std::size_t> most;
        if (places.is_zero()) {
            most = most_in_common_parts;
            CommonParts parts = common_parts(piece, piece, equations, true, width_, limits_);
            std::ranges::move(parts.overlaps, std::back_inserter(found_.overlaps));
            candidates = std::move(parts.first);
        } else {
            candidates = roots_in(piece, places, width_, limits_);
        }
        add_meeting(piece, i, candidates, piece, i, candidates, most);
    }

    CurveIntersections finish() && {
        drop_ends_of_overlaps();
        join_overlaps();
        std::ranges::sort(found_.points, [&](const CurveIntersection& a, const CurveIntersection& b) {
            const auto order = compare(a.first, b.first, limits_);
            return order < 0 || (order == 0 && compare(a.second, b.second, limits_) < 0);
        });
        return std::move(found_);
    }

private:
    /// Two parts of one curve that meet at their ends have no finite order of contact.
    static constexpr std::size_t most_in_common_parts = 3;

    /// One of the pieces is a point, which the other may pass.
    void add_of_point(const CurvePiece& first, const CurvePiece& second) {
        const bool first_is_point = is_point(first);
        const CurvePiece& point = first_is_point ? first : second;
        const CurvePiece& curve = first_is_point ? second : first;
        Polynomial common;
        for (std::size_t j = 0; j < 2; ++j)
            common =
                gcd(common, curve.coordinates[j] * point.weight() - point.coordinates[j] * curve.weight());
        if (common.is_zero()) {
            found_.overlaps.push_back({algebraic(first.range), algebraic(second.range), false});
            return;
        }
        if (common.degree() == 0) return;
        for (const Root& root : roots_in(curve, common, width_, limits_)) {
            const AlgebraicRange there{root, root};
            const AlgebraicRange everywhere = algebraic(point.range);
            found_.overlaps.push_back(first_is_point ? CurveOverlap{everywhere, there, false}
                                                     : CurveOverlap{there, everywhere, false});
        }
    }

    /// Adds the pairs of parameters that have one point; of one piece those with the less parameter first.
    void add_meeting(const CurvePiece& first, std::size_t i, std::span<const Root> s,
                     const CurvePiece& second, std::size_t k, std::span<const Root> t,
                     std::optional<std::size_t> most = {}) {
        PointComparison comparison(first, second, limits_);
        const bool is_self = &first == &second;
        for (std::size_t a = 0; a < s.size(); ++a) {
            for (std::size_t b = is_self ? a + 1 : 0; b < t.size(); ++b) {
                if (!comparison.meet(s[a], t[b])) continue;
                CurveIntersection point{s[a], t[b], i, k, 0};
                if (is_end_of_overlap(point)) continue;
                point.multiplicity = comparison.multiplicity(s[a], t[b], most);
                found_.points.push_back(std::move(point));
            }
        }
    }

    bool is_same_end(const std::optional<Root>& one, const std::optional<Root>& other) const {
        return one && other && is_same(*one, *other, limits_);
    }

    bool is_end_of_overlap(const CurveIntersection& point) const {
        return std::ranges::any_of(found_.overlaps, [&](const CurveOverlap& overlap) {
            const auto& [lower, upper] = overlap.second;
            return (is_same_end(point.first, overlap.first.lower) &&
                    is_same_end(point.second, overlap.is_reversed ? upper : lower)) ||
                   (is_same_end(point.first, overlap.first.upper) &&
                    is_same_end(point.second, overlap.is_reversed ? lower : upper));
        });
    }

    /// Points that other pieces have found before the overlap.
    void drop_ends_of_overlaps() {
        if (found_.overlaps.empty()) return;
        std::erase_if(found_.points,
                      [&](const CurveIntersection& point) { return is_end_of_overlap(point); });
    }

    bool is_one_point(const AlgebraicRange& range) const { return is_same_end(range.lower, range.upper); }

    /// Whether `next` goes on where `former` ends.
    bool goes_on(const CurveOverlap& former, const CurveOverlap& next) const {
        if (former.is_reversed != next.is_reversed || is_one_point(former.first) ||
            is_one_point(former.second) || !is_same_end(former.first.upper, next.first.lower))
            return false;
        return former.is_reversed ? is_same_end(former.second.lower, next.second.upper)
                                  : is_same_end(former.second.upper, next.second.lower);
    }

    void join_overlaps() {
        std::ranges::stable_sort(found_.overlaps, [&](const CurveOverlap& a, const CurveOverlap& b) {
            if (!a.first.lower || !b.first.lower) return !a.first.lower && b.first.lower.has_value();
            return compare(*a.first.lower, *b.first.lower, limits_) < 0;
        });
        std::vector<CurveOverlap> joined;
        for (CurveOverlap& overlap : found_.overlaps) {
            const auto before = std::ranges::find_if(
                joined, [&](const CurveOverlap& former) { return goes_on(former, overlap); });
            if (before == joined.end()) {
                joined.push_back(std::move(overlap));
                continue;
            }
            before->first.upper = overlap.first.upper;
            (overlap.is_reversed ? before->second.lower : before->second.upper) =
                overlap.is_reversed ? overlap.second.lower : overlap.second.upper;
        }
        found_.overlaps = std::move(joined);
    }

    const Rational& width_;
    const Limits& limits_;
    CurveIntersections found_;
};

void require_plane_curve(std::span<const CurvePiece> pieces, Part part) {
    for (const CurvePiece& piece : pieces) {
        if (piece.dimension() == 2) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "the curves must be plane; the points of this one have " +
                        std::to_string(piece.dimension()) +
                        (piece.dimension() == 1 ? " coordinate" : " coordinates"),
                    part);
    }
}

}  // namespace

CurveIntersections intersections(std::span<const CurvePiece> first, std::span<const CurvePiece> second,
                                 const Rational& width, const Limits& limits) {
    require_plane_curve(first, Part::left);
    require_plane_curve(second, Part::right);
    const std::vector<Box> first_boxes = boxes_of(first, limits);
    const std::vector<Box> second_boxes = boxes_of(second, limits);
    IntersectionSearch search(width, limits);
    for (std::size_t i = 0; i < first.size(); ++i) {
        spend_work(words_of_box * second.size());
        for (std::size_t k = 0; k < second.size(); ++k) {
            if (!are_apart(first_boxes[i], second_boxes[k])) search.add(first[i], i, second[k], k);
        }
    }
    return std::move(search).finish();
}

CurveIntersections self_intersections(std::span<const CurvePiece> curve, const Rational& width,
                                      const Limits& limits) {
    require_plane_curve(curve, Part::map);
    const std::vector<Box> boxes = boxes_of(curve, limits);
    IntersectionSearch search(width, limits);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        spend_work(words_of_box * (curve.size() - i));
        search.add(curve[i], i);
        for (std::size_t k = i + 1; k < curve.size(); ++k) {
            if (!are_apart(boxes[i], boxes[k])) search.add(curve[i], i, curve[k], k);
        }
    }
    return std::move(search).finish();
}

std::vector<Root> cusps(std::span<const CurvePiece> curve, const Rational& width, const Limits& limits) {
    require_plane_curve(curve, Part::map);
    std::vector<Root> found;
    for (const CurvePiece& piece : curve) {
        const std::vector<Polynomial> speed = velocity(piece);
        const Polynomial stops = without_factors_of(gcd(speed[0], speed[1]), piece.weight());
        if (stops.degree() == 0) continue;
        for (const Root& root : roots_in(piece, stops, width, limits)) {
            if (root.multiplicity % 2 == 1) found.push_back(root);
        }
    }
    return found;
}

}  // namespace blossom
