#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace blossom::worked {

/// Small numbers for problems, the same for a seed, level and topic on every platform: the standard fixes the
/// engine.
class ProblemNumbers {
public:
    ProblemNumbers(std::uint64_t seed, std::size_t level, std::string_view topic) : level_(level) {
        std::vector<std::uint64_t> words{seed & 0xFFFFFFFF, seed >> 32, level};
        words.insert(words.end(), topic.begin(), topic.end());
        std::seed_seq sequence(words.begin(), words.end());
        engine_.seed(sequence);
    }

    std::size_t level() const { return level_; }
    std::size_t degree() const { return level_ == 1 ? 2 : 3; }
    /// A polynomial of this degree without zero coefficients.
    PolynomialCurve polynomial() {
        std::vector<Rational> coefficients;
        for (std::size_t k = 0; k <= degree(); ++k) {
            const Rational coefficient(not_zero(level_ == 1 ? 4 : 6));
            coefficients.push_back(level_ == 3 ? coefficient / Rational(between(1, 3)) : coefficient);
        }
        return PolynomialCurve(Polynomial(coefficients));
    }

    /// A curve in the plane over [0, 1]; no three neighbouring control points lie on a line.
    BezierCurve polygon() { return BezierCurve(plane_points(degree() + 1)); }

    /// A curve in the plane; uniform knots up to level 2.
    BSplineCurve spline() {
        const std::size_t n = degree();
        const std::size_t count = n + 2;
        std::vector<Rational> knots;
        std::int64_t knot = 0;
        for (std::size_t i = 0; i < count + n - 1; ++i) {
            knots.emplace_back(knot);
            knot += level_ == 3 ? between(1, 2) : 1;
        }
        return {n, std::move(knots), plane_points(count)};
    }

    /// Two segments in the plane that meet at the knot 1, of any possible multiplicity.
    BSplineCurve joint() {
        const std::size_t n = degree();
        const auto multiplicity = static_cast<std::size_t>(between(1, static_cast<std::int64_t>(n)));
        std::vector<Rational> knots(n, 0);
        knots.insert(knots.end(), multiplicity, 1);
        knots.insert(knots.end(), n, 2);
        return {n, std::move(knots), plane_points(n + 1 + multiplicity)};
    }

    /// A polygon with positive weights as homogeneous coordinates; not all weights are equal.
    BezierCurve weighted_polygon() {
        std::vector<Coordinates> points = plane_points(degree() + 1);
        const Rational first(between(1, 3));
        bool differ = false;
        for (std::size_t k = 0; k < points.size(); ++k) {
            Rational weight = k == 0 ? first : Rational(between(1, 3));
            if (k + 1 == points.size() && !differ && weight == first) weight += Rational(1);
            differ = differ || weight != first;
            for (Rational& coordinate : points[k]) coordinate *= weight;
            points[k].push_back(weight);
        }
        return BezierCurve(points);
    }

    /// A net in the plane whose corners are not collinear.
    BezierPatch triangle() {
        const std::size_t n = level_ == 3 ? 3 : 2;
        const NetShape shape = NetShape::simplex(2, n);
        std::vector<Coordinates> net;
        do {
            net.clear();
            for (const MultiIndex& index : multi_indices(2, n)) {
                // The net is a perturbation of the regular one.
                const auto x = static_cast<std::int64_t>(2 * index[1]) + between(-1, 1);
                const auto y = static_cast<std::int64_t>(2 * index[2]) + between(-1, 1);
                net.push_back({Rational(x), Rational(y)});
            }
        } while (area(net.front(), net[net.size() - n - 1], net.back()).is_zero());
        return {shape, net};
    }

    /// Barycentric coordinates, all positive.
    Coordinates inside_triangle() {
        const std::int64_t parts = level_ == 1 ? 4 : between(3, 6);
        const std::int64_t a = between(1, parts - 2);
        const std::int64_t b = between(1, parts - a - 1);
        const Rational whole(parts);
        return {Rational(a) / whole, Rational(b) / whole, Rational(parts - a - b) / whole};
    }

    /// Distinct parameters.
    std::vector<Argument> arguments(std::size_t n) {
        std::vector<Rational> numbers;
        while (numbers.size() < n) {
            const Rational value =
                level_ == 3 ? Rational(between(-5, 5)) / Rational(2) : Rational(between(-3, 5));
            if (std::ranges::find(numbers, value) == numbers.end()) numbers.push_back(value);
        }
        return mapped(numbers, [&](const Rational& value) { return Argument(Parameter(value)); });
    }

    /// A parameter that is not an integer, inside an interval with integer ends.
    Rational inside(const Interval& interval) {
        const std::int64_t parts = level_ == 1 ? 2 : between(2, 4);
        const std::int64_t begin = *(interval.a() * Rational(parts)).numerator().to_int64();
        const std::int64_t end = *(interval.b() * Rational(parts)).numerator().to_int64();
        Rational value;
        while (value.is_integer()) value = Rational(between(begin + 1, end - 1)) / Rational(parts);
        return value;
    }

    /// An increasing interval other than [0, 1].
    Interval interval() {
        const std::int64_t a = between(-2, 2);
        const std::int64_t b = a + between(1, 3);
        if (a == 0 && b == 1) return interval();
        return {Rational(a), Rational(b)};
    }

private:
    std::int64_t between(std::int64_t least, std::int64_t greatest) {
        const auto width = static_cast<std::uint64_t>(greatest - least + 1);
        return least + static_cast<std::int64_t>(engine_() % width);
    }

    std::int64_t not_zero(std::int64_t size) {
        const std::int64_t value = between(1, size);
        return between(0, 1) == 0 ? value : -value;
    }

    std::vector<Coordinates> plane_points(std::size_t count) {
        std::vector<Coordinates> points;
        do {
            points.clear();
            for (std::size_t k = 0; k < count; ++k) {
                const auto step = static_cast<std::int64_t>(k);
                const Rational x(2 * step + between(0, 1));
                points.push_back(
                    {x, level_ == 3 ? Rational(between(-7, 7)) / Rational(2) : Rational(between(-4, 4))});
            }
        } while (!bends_everywhere(points));
        return points;
    }

    /// Twice the area of the triangle: zero when the points lie on a line.
    static Rational area(const Coordinates& p, const Coordinates& q, const Coordinates& r) {
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    }

    /// Whether no three neighbours lie on a line.
    static bool bends_everywhere(const std::vector<Coordinates>& points) {
        for (std::size_t i = 0; i + 2 < points.size(); ++i) {
            if (area(points[i], points[i + 1], points[i + 2]).is_zero()) return false;
        }
        return true;
    }

    std::mt19937_64 engine_;
    std::size_t level_;
};

}  // namespace blossom::worked
