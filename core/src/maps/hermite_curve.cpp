#include <blossom/core/maps/hermite_curve.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "integer_frame.hpp"
#include "stated_points.hpp"

namespace blossom {

namespace {

PointArray at_both_ends(std::span<const Coordinates> left, std::span<const Coordinates> right) {
    std::vector<Coordinates> all(left.begin(), left.end());
    all.insert(all.end(), right.begin(), right.end());
    if (all.empty()) throw Error(ErrorCode::wrong_arity, "at least one value or derivative is needed");
    const std::size_t dimension = all.front().size();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].size() == dimension && dimension > 0) continue;
        const bool at_left = i < left.size();
        const std::size_t k = at_left ? i : i - left.size();
        throw Error(ErrorCode::mismatched_dimensions,
                    "derivative " + std::to_string(k) + " at the " + (at_left ? "left" : "right") +
                        " end has " + std::to_string(all[i].size()) +
                        " coordinates; each needs the same number, at least 1, and the first has " +
                        std::to_string(dimension),
                    (at_left ? Part::left : Part::right) / k);
    }
    return PointArray(all);
}

/// The relation between the derivatives at one end and the control points that begin there, for both ends
/// over one denominator. `step` is the vector from this end to the other, and there are at most m
/// derivatives.
struct End {
    std::size_t n = 0;
    std::size_t m = 0;
    Rational step;

    /// The numerators of the control points over n!/(n-m+1)! q^(m-1), where q is the denominator of the step.
    std::vector<Integer> points(std::span<const Integer> derivatives) const {
        const Integer factor = falling_factorial(n, m - 1);
        std::vector<Integer> row;
        row.reserve(derivatives.size());
        for (std::size_t k = 0; k < derivatives.size(); ++k) {
            row.push_back(derivatives[k] * divide_exactly(factor, falling_factorial(n, k)) *
                          pow(step.numerator(), k) * pow(step.denominator(), m - 1 - k));
        }
        for (std::size_t level = 1; level < row.size(); ++level) {
            for (std::size_t k = row.size() - 1; k >= level; --k) row[k] += row[k - 1];
        }
        return row;
    }

    /// The numerators of the derivatives over |p|^(m-1), where p is the numerator of the step.
    std::vector<Integer> derivatives(std::vector<Integer> points) const {
        for (std::size_t level = 1; level < points.size(); ++level) {
            for (std::size_t k = points.size() - 1; k >= level; --k) points[k] -= points[k - 1];
        }
        const Integer sign = step.sign() < 0 && m % 2 == 0 ? -1 : 1;
        for (std::size_t k = 0; k < points.size(); ++k) {
            points[k] *= sign * falling_factorial(n, k) * pow(step.denominator(), k) *
                         pow(step.numerator(), m - 1 - k);
        }
        return points;
    }
};

/// Checks a bound on the bits of all numbers at the ends.
void require_size(const PointArray& points, std::size_t m, const Rational& length, const Limits& limits) {
    const std::size_t bits = length.numerator().bit_length() + length.denominator().bit_length() +
                             Integer(points.size()).bit_length() + 1;
    require_result_bits(greatest_bit_length(points.numbers().numerators()) + m * bits, limits,
                        points.numbers().size());
}

}  // namespace

HermiteCurve::HermiteCurve(std::span<const Coordinates> left, std::span<const Coordinates> right,
                           Interval interval)
    : interval_(std::move(interval)), left_count_(left.size()), derivatives_(at_both_ends(left, right)) {}

BezierCurve bezier_form(const HermiteCurve& curve, const Limits& limits) {
    const Rational length = curve.interval().b() - curve.interval().a();
    const std::size_t n = curve.degree();
    const std::size_t m = std::max(curve.left_count(), curve.right_count());
    require_size(curve.derivatives(), m, length, limits);
    const Integer denominator = falling_factorial(n, m - 1) * pow(length.denominator(), m - 1);
    std::vector<Quotients<Integer>> rows;
    for (const auto row : curve.derivatives().rows()) {
        std::vector<Integer> points = End{n, m, length}.points(row.first(curve.left_count()));
        const std::vector<Integer> right = End{n, m, -length}.points(row.subspan(curve.left_count()));
        points.insert(points.end(), right.rbegin(), right.rend());
        rows.push_back({std::move(points), denominator});
    }
    return {point_array(std::move(rows), curve.derivatives().denominator()), curve.interval()};
}

HermiteCurve hermite_form(const BezierCurve& curve, std::size_t left_count, const Limits& limits) {
    const std::size_t n = curve.degree();
    if (left_count > n + 1) {
        throw Error(ErrorCode::wrong_arity, "a curve of degree " + std::to_string(n) + " is given by " +
                                                std::to_string(n + 1) + " values and derivatives, not by " +
                                                std::to_string(left_count));
    }
    const Rational length = curve.interval().b() - curve.interval().a();
    const std::size_t m = std::max(left_count, n + 1 - left_count);
    require_size(curve.control_points(), m, length, limits);
    const Integer denominator = pow(abs(length.numerator()), m - 1);
    std::vector<Quotients<Integer>> rows;
    for (const auto row : curve.control_points().rows()) {
        const auto left = row.first(left_count);
        const auto right = row.subspan(left_count);
        std::vector<Integer> all = End{n, m, length}.derivatives({left.begin(), left.end()});
        const std::vector<Integer> behind = End{n, m, -length}.derivatives({right.rbegin(), right.rend()});
        all.insert(all.end(), behind.begin(), behind.end());
        rows.push_back({std::move(all), denominator});
    }
    return {point_array(std::move(rows), curve.control_points().denominator()), left_count, curve.interval()};
}

std::vector<StatedValue> stated_values(const HermiteCurve& curve) {
    const std::size_t n = curve.degree();
    const std::vector<Coordinates> points = curve.derivatives().to_points();
    const auto at = [&](std::string_view name, std::span<const Coordinates> derivatives,
                        const Rational& end) {
        return stated_points(
            name, derivatives, [&](std::size_t k) { return two_arguments(n, k, Parameter(end), delta); },
            [n](std::size_t k) { return falling_factorial(n, k); });
    };
    const std::span all(points);
    auto stated = at("left derivative", all.first(curve.left_count()), curve.interval().a());
    std::ranges::move(at("right derivative", all.subspan(curve.left_count()), curve.interval().b()),
                      std::back_inserter(stated));
    return stated;
}

}  // namespace blossom
