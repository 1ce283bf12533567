#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "maps/integer_frame.hpp"
#include "maps/integer_tuple.hpp"

namespace blossom {

namespace {

/// One level on integers: point i becomes left * point i + right * point i + 1, coordinate by coordinate.
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

std::pair<BezierCurve, BezierCurve> subdivide(const BezierCurve& curve, const Parameter& t,
                                              const Limits& limits) {
    const Interval before(curve.interval().a(), t.value);
    const Interval behind(t.value, curve.interval().b());
    return {control_points(curve, before, limits), control_points(curve, behind, limits)};
}

}  // namespace blossom
