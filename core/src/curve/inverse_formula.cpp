#include <blossom/core/curve/inverse_formula.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <string>

namespace blossom {

InverseFormula inverse_formula(std::size_t n, const Interval& interval, const Limits& limits) {
    require_within(n, limits.degree, "degree", "the degree", Part::degree);
    if (n == 0) return {{interval.a()}, {{1}}};
    require_within(n * n * n, limits.expansion_work, "expansion_work",
                   "the number of weights to compute, at most", Part::degree);

    // weights by the fraction I/N of the way from a to b
    std::map<Rational, std::vector<Integer>> columns;
    for (std::size_t count = 1; count <= n; ++count) {
        const Integer power = pow(Integer(count), n);
        const Integer signed_power = (n - count) % 2 == 0 ? power : -power;
        for (std::size_t at_b = 0; at_b <= count; ++at_b) {
            auto& column = columns[Rational(at_b, count)];
            column.resize(n + 1);
            for (std::size_t i = 0; i <= n; ++i) {
                column[i].add_product(signed_power, binomial(i, at_b) * binomial(n - i, count - at_b));
            }
        }
    }
    InverseFormula formula;
    formula.weights.resize(n + 1);
    const Integer divisor = factorial(n);
    for (const auto& [fraction, column] : columns) {
        formula.nodes.push_back(interval.a() + fraction * (interval.b() - interval.a()));
        for (std::size_t i = 0; i <= n; ++i) formula.weights[i].emplace_back(column[i], divisor);
    }
    return formula;
}

BezierCurve control_points_from_values(std::size_t n, const Interval& interval,
                                       const std::function<Coordinates(const Rational&)>& map,
                                       const Limits& limits) {
    const InverseFormula formula = inverse_formula(n, interval, limits);
    std::vector<Coordinates> values;
    values.reserve(formula.nodes.size());
    for (const Rational& node : formula.nodes) values.push_back(map(node));
    const PointArray known(values);
    std::vector<Coordinates> points;
    for (const auto& row : formula.weights) {
        const RationalVector weights(row);
        Coordinates& point = points.emplace_back();
        for (const auto coordinate : known.rows()) {
            point.emplace_back(dot(weights.numerators(), coordinate),
                               weights.denominator() * known.denominator());
        }
    }
    return BezierCurve(points, interval);
}

BezierCurve control_points_from_samples(std::size_t n, const Interval& interval,
                                        const std::map<Rational, Coordinates>& values, const Limits& limits) {
    const auto look_up = [&](const Rational& node) {
        const auto known = values.find(node);
        if (known == values.end()) {
            throw Error(ErrorCode::missing_sample,
                        "the inverse formula of degree " + std::to_string(n) + " needs the value at " +
                            to_string(node) + ", and none is given",
                        Part::values);
        }
        return known->second;
    };
    return control_points_from_values(n, interval, look_up, limits);
}

}  // namespace blossom
