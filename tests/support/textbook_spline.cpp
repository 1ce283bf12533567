#include "textbook_spline.hpp"

#include <algorithm>
#include <bit>
#include <set>

namespace blossom::textbook {

namespace {

Coordinates combination(std::span<const Coordinates> points, std::span<const Rational> weights) {
    Coordinates sum(points.front().size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += weights[i] * points[i][j];
    }
    return sum;
}

Rational power(const Rational& base, std::size_t exponent) {
    Rational result = 1;
    for (std::size_t i = 0; i < exponent; ++i) result *= base;
    return result;
}

/// (1/n!) times the sum over the non-empty subsets S of (-1)^(n - |S|) |S|^n F(mean of S).
Coordinates blossom_at_points(const Spline& spline, std::size_t span, std::span<const Rational> points) {
    const std::size_t n = spline.degree;
    if (n == 0) return segment_value(spline, span, spline.knots[span]);
    Coordinates sum(spline.points.front().size());
    for (std::size_t subset = 1; subset < std::size_t{1} << n; ++subset) {
        Rational total;
        for (std::size_t i = 0; i < n; ++i) {
            if ((subset >> i & 1) != 0) total += points[i];
        }
        const auto size = static_cast<std::size_t>(std::popcount(subset));
        Rational weight = power(Rational(size), n);
        if ((n - size) % 2 != 0) weight = -weight;
        const Coordinates value = segment_value(spline, span, total / Rational(size));
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += weight * value[j];
    }
    Rational factorial = 1;
    for (std::size_t i = 2; i <= n; ++i) factorial *= Rational(i);
    for (Rational& coordinate : sum) coordinate /= factorial;
    return sum;
}

/// The blossom at `points`, followed by the remaining arguments, which may be pairs.
Coordinates blossom_from(const Spline& spline, std::size_t span, std::span<const Argument> arguments,
                         std::vector<Rational>& points) {
    if (points.size() == arguments.size()) return blossom_at_points(spline, span, points);
    const Argument& argument = arguments[points.size()];
    const auto with = [&](const Rational& point) {
        points.push_back(point);
        Coordinates value = blossom_from(spline, span, arguments, points);
        points.pop_back();
        return value;
    };
    if (!argument.mass.is_zero()) {
        Coordinates value = with(argument.u / argument.mass);
        for (Rational& coordinate : value) coordinate *= argument.mass;
        return value;
    }
    Coordinates value = with(1);
    const Coordinates origin = with(0);
    for (std::size_t j = 0; j < value.size(); ++j) value[j] = argument.u * (value[j] - origin[j]);
    return value;
}

}  // namespace

Spline with_end_knots(std::size_t degree, std::vector<Rational> knots, std::vector<Coordinates> points) {
    if (knots.size() == points.size() + degree - 1) {
        knots.insert(knots.begin(), knots.front() - Rational(1, 3));
        knots.push_back(knots.back() + 5);
    }
    return {degree, std::move(knots), std::move(points)};
}

std::vector<Rational> basis_polynomials(const Spline& spline, std::size_t span, const Rational& t) {
    const auto& knots = spline.knots;
    std::vector<Rational> basis(knots.size() - 1);
    basis[span] = 1;
    const auto ratio = [](const Rational& part, const Rational& whole) {
        return whole.is_zero() ? Rational() : part / whole;
    };
    for (std::size_t degree = 1; degree <= spline.degree; ++degree) {
        for (std::size_t i = 0; i + degree + 1 < knots.size(); ++i) {
            basis[i] = ratio(t - knots[i], knots[i + degree] - knots[i]) * basis[i] +
                       ratio(knots[i + degree + 1] - t, knots[i + degree + 1] - knots[i + 1]) * basis[i + 1];
        }
        basis.pop_back();
    }
    return basis;
}

Coordinates segment_value(const Spline& spline, std::size_t span, const Rational& t) {
    return combination(spline.points, basis_polynomials(spline, span, t));
}

std::size_t span_of(const Spline& spline, const Rational& t) {
    std::size_t span = spline.degree;
    for (std::size_t i = spline.degree; i < spline.points.size(); ++i) {
        if (spline.knots[i] < spline.knots[i + 1] && spline.knots[i] <= t) span = i;
    }
    return span;
}

Coordinates value(const Spline& spline, const Rational& t) {
    return segment_value(spline, span_of(spline, t), t);
}

Coordinates segment_blossom(const Spline& spline, std::size_t span, std::span<const Argument> arguments) {
    std::vector<Rational> points;
    return blossom_from(spline, span, arguments, points);
}

bool same_map(const Spline& a, const Spline& b) {
    const auto begin = [](const Spline& spline) { return spline.knots[spline.degree]; };
    const auto end = [](const Spline& spline) { return spline.knots[spline.points.size()]; };
    if (begin(a) != begin(b) || end(a) != end(b)) return false;
    std::set<Rational> joints(a.knots.begin(), a.knots.end());
    joints.insert(b.knots.begin(), b.knots.end());
    const Rational degrees = static_cast<int>(std::max(a.degree, b.degree));
    for (auto joint = joints.find(begin(a)); *joint != end(a); ++joint) {
        const Rational length = *std::next(joint) - *joint;
        for (Rational step = 0; step <= degrees; step += 1) {
            const Rational t = *joint + length * step / (degrees + 1);
            if (value(a, t) != value(b, t)) return false;
        }
    }
    return value(a, end(a)) == value(b, end(b));
}

}  // namespace blossom::textbook
