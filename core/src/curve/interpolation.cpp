#include <blossom/core/curve/interpolation.hpp>
#include <blossom/core/curve/newton_form.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

namespace blossom {

std::vector<NodeDatum> data_in_order(std::span<const Rational> nodes, std::span<const Coordinates> values) {
    if (nodes.empty()) throw Error(ErrorCode::wrong_arity, "at least one node is needed", Part::nodes);
    if (nodes.size() != values.size()) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(values.size()) + " values at " + std::to_string(nodes.size()) + " nodes",
                    Part::values);
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i].size() == values.front().size() && !values[i].empty()) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "value " + std::to_string(i) + " has " + std::to_string(values[i].size()) +
                        " coordinates; every value needs the same number, at least 1, and value 0 has " +
                        std::to_string(values.front().size()),
                    Part::values / i);
    }
    std::vector<NodeDatum> data;
    data.reserve(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) data.push_back({i, 0});
    std::ranges::stable_sort(data, {}, [&](const NodeDatum& datum) { return nodes[datum.index]; });
    for (std::size_t i = 1; i < data.size(); ++i) {
        if (nodes[data[i].index] == nodes[data[i - 1].index]) data[i].order = data[i - 1].order + 1;
    }
    return data;
}

PolynomialCurve interpolate(std::span<const Rational> nodes, std::span<const Coordinates> values,
                            const Limits& limits) {
    const std::vector<NodeDatum> data = data_in_order(nodes, values);
    const std::size_t n = data.size() - 1;
    require_within(n, limits.degree, "degree", "the formal degree", Part::nodes);
    std::vector<Rational> ordered;
    std::vector<Coordinates> differences;
    for (const NodeDatum& datum : data) {
        ordered.push_back(nodes[datum.index]);
        differences.push_back(values[data[differences.size() - datum.order].index]);
    }
    for (std::size_t level = 1; level <= n; ++level) {
        for (std::size_t i = n; i >= level; --i) {
            if (ordered[i] == ordered[i - level]) {
                differences[i] = values[data[i - data[i].order + level].index];
                for (Rational& coordinate : differences[i]) coordinate /= factorial(level);
                continue;
            }
            const Rational step = ordered[i] - ordered[i - level];
            for (std::size_t j = 0; j < differences[i].size(); ++j) {
                differences[i][j] = combination(step.denominator(), differences[i][j], -step.denominator(),
                                                differences[i - 1][j], step.numerator());
            }
        }
    }
    return monomial_form_of_newton(PointArray(differences), ordered, limits);
}

std::vector<Rational> uniform_nodes(const Interval& interval, std::size_t n) {
    std::vector<Rational> nodes{interval.a()};
    for (std::size_t i = 1; i <= n; ++i)
        nodes.push_back(interval.a() + Rational(i, n) * (interval.b() - interval.a()));
    return nodes;
}

}  // namespace blossom
