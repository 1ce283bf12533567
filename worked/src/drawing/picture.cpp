#include <blossom/worked/picture.hpp>

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/curve/degree_elevation.hpp>

#include <array>

#include "drawing.hpp"

namespace blossom::worked {

std::string role_name(Role role) {
    constexpr std::array<const char*, 5> names{"before", "control", "construction", "result", "second"};
    return names[static_cast<std::size_t>(role)];
}

std::vector<std::vector<PlanePoint>> lines_through(std::span<const Coordinates> points, bool rational) {
    std::vector<std::vector<PlanePoint>> lines;
    bool broken = true;
    for (const Coordinates& point : points) {
        const Rational weight = rational ? point.back() : 1;
        if (!weight.is_zero()) {
            if (broken) lines.emplace_back();
            lines.back().push_back({point[0] / weight, point[1] / weight});
        }
        broken = weight.is_zero();
    }
    return lines;
}

std::vector<PictureCurve> curves_over(const PolynomialMap& map, const Interval& interval, Role role,
                                      const Limits& limits, bool rational, std::size_t steps) {
    const auto of_curve = [&](const auto& curve) {
        std::vector<Coordinates> points;
        const bool cubic = curve.degree() <= 3 && !rational;
        if (cubic) {
            const BezierCurve bezier = control_points(curve, interval, limits);
            points = elevate(bezier, 3 - curve.degree(), limits).control_points().to_points();
        } else {
            const Rational step = (interval.b() - interval.a()) / Rational(steps);
            for (std::size_t k = 0; k <= steps; ++k) {
                points.push_back(evaluate(curve, Parameter(interval.a() + Rational(k) * step), limits));
            }
        }
        std::vector<PictureCurve> curves;
        for (auto& line : lines_through(points, rational)) curves.push_back({std::move(line), cubic, role});
        return curves;
    };
    return std::visit(of_curve, map);
}

std::string short_text(const Rational& value, std::int64_t digits) {
    constexpr std::size_t longest = 8;
    std::string fraction = to_string(value);
    if (fraction.size() <= longest) return fraction;
    const auto length = [](const Integer& integer) {
        return static_cast<std::int64_t>(to_string(integer).size());
    };
    const auto power_of_ten = [](std::int64_t k) {
        const Rational power = pow(Rational(10), static_cast<std::size_t>(k < 0 ? -k : k));
        return k < 0 ? Rational(1) / power : power;
    };
    const Rational size = abs(value);
    std::int64_t exponent = length(size.numerator()) - length(size.denominator());
    if (size < power_of_ten(exponent)) --exponent;
    const Rational scaled = size * power_of_ten(digits - 1 - exponent);
    std::string text = to_string(rounded(scaled));
    if (static_cast<std::int64_t>(text.size()) > digits) ++exponent;
    text.erase(text.find_last_not_of('0') + 1);
    const bool scientific = exponent < -digits || exponent >= digits;
    if (!scientific && exponent < 0) text.insert(0, static_cast<std::size_t>(-exponent), '0');
    const std::size_t whole = scientific || exponent < 0 ? 1 : static_cast<std::size_t>(exponent) + 1;
    if (text.size() < whole) text.append(whole - text.size(), '0');
    if (text.size() > whole) text.insert(whole, ".");
    return (scaled.is_integer() ? "" : "≈ ") + std::string(value.sign() < 0 ? "-" : "") + text +
           (scientific ? "e" + std::to_string(exponent) : "");
}

}  // namespace blossom::worked
