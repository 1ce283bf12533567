#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/row_recurrences.hpp>

#include <algorithm>
#include <iterator>
#include <string>

#include "maps/integer_frame.hpp"
#include "maps/integer_tuple.hpp"

namespace blossom {

namespace {

/// One level in integers: point i becomes left * point i + right * point i + 1, in each coordinate.
std::vector<std::vector<Integer>> next_level(const std::vector<std::vector<Integer>>& rows,
                                             const Integer& left, const Integer& right) {
    std::vector<std::vector<Integer>> next;
    next.reserve(rows.size());
    for (const auto& row : rows) {
        std::vector<Integer>& combined = next.emplace_back();
        combined.reserve(row.size() - 1);
        for (std::size_t i = 0; i + 1 < row.size(); ++i)
            combined.push_back(left * row[i] + right * row[i + 1]);
    }
    return next;
}

}  // namespace

Pyramid casteljau_pyramid(const BezierCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits) {
    const std::size_t n = curve.degree();
    if (arguments.size() != n) {
        throw Error(ErrorCode::wrong_arity,
                    "the pyramid of a curve of degree " + std::to_string(n) + " takes " + std::to_string(n) +
                        " arguments, not " + std::to_string(arguments.size()),
                    Part::arguments);
    }
    const ClearedArguments cleared_arguments = cleared_one_by_one(arguments);
    const auto interval = cleared(curve.interval());
    const auto& [a, b, q] = interval;
    require_result_bits(greatest_bit_length(curve.control_points().numbers().numerators()) +
                            cleared_arguments.bits + n * interval.bits(),
                        limits, (n + 1) * (n + 2) / 2 * curve.dimension());

    Pyramid pyramid{{curve.control_points()}};
    std::vector<std::vector<Integer>> rows;
    for (const auto row : curve.control_points().rows()) rows.emplace_back(row.begin(), row.end());
    Integer denominator = curve.control_points().denominator();
    for (std::size_t r = 0; r < n; ++r) {
        const auto& [u, mass] = cleared_arguments.pairs[r];
        rows = next_level(rows, b * mass - q * u, q * u - a * mass);
        denominator *= (b - a) * lcm(arguments[r].u.denominator(), arguments[r].mass.denominator());
        pyramid.levels.push_back(canonical_points(rows, denominator));
    }
    return pyramid;
}

namespace {

/// From this degree on, two changes of the interval are faster than a triangle (by measurement).
constexpr std::size_t least_degree_of_changes = 1000;

}  // namespace

std::pair<BezierCurve, BezierCurve> subdivide(const BezierCurve& curve, const Parameter& t,
                                              const Limits& limits) {
    const Interval before(curve.interval().a(), t.value);
    const Interval behind(t.value, curve.interval().b());
    const std::size_t n = curve.degree();
    if (n >= least_degree_of_changes)
        return {control_points(curve, before, limits), control_points(curve, behind, limits)};

    // In the local coordinate, t is p / q.
    const Rational local = (t.value - before.a()) / (behind.b() - before.a());
    const Integer& p = local.numerator();
    const Integer& q = local.denominator();
    const PointArray& points = curve.control_points();
    require_result_bits(greatest_bit_length(points.numbers().numerators()) +
                            n * (std::max(p.bit_length(), q.bit_length()) + 1),
                        limits, 2 * points.numbers().size());
    std::vector<Integer> left;
    std::vector<Integer> right;
    left.reserve(points.numbers().size());
    right.reserve(points.numbers().size());
    for (std::size_t j = 0; j < points.dimension(); ++j) {
        TriangleEdges edges = triangle_edges(points.coordinate(j), q - p, p);
        std::ranges::move(edges.left, std::back_inserter(left));
        std::ranges::move(edges.right, std::back_inserter(right));
    }
    // Level i of the triangle has the denominator q^i.
    std::vector<Integer> rising(n + 1, Integer(1));
    for (std::size_t i = 1; i <= n; ++i) rising[i] = rising[i - 1] * q;
    const std::vector<Integer> falling(rising.rbegin(), rising.rend());
    const auto half = [&](std::vector<Integer> edge, std::span<const Integer> powers, const Interval& over) {
        PointArray polygon(
            points.dimension(),
            points.numbers().over_same_denominator(std::move(edge)).weighted(powers, rising.back()));
        polygon.make_canonical();
        return BezierCurve(std::move(polygon), over);
    };
    return {half(std::move(left), falling, before), half(std::move(right), rising, behind)};
}

}  // namespace blossom
