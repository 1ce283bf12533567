#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "maps/patch_kernel.hpp"
#include "polarization.hpp"

namespace blossom {

namespace {

/// J / N.
Coordinates mean(const MultiIndex& copies, std::size_t count) {
    Coordinates node;
    for (const std::size_t copy : copies) node.emplace_back(copy, count);
    return node;
}

/// prod_k C(i_k, J_k).
Integer choices(const MultiIndex& index, const MultiIndex& copies) {
    Integer product = 1;
    for (std::size_t k = 0; k < index.size(); ++k) product *= binomial(index[k], copies[k]);
    return product;
}

Integer signed_power(std::size_t count, std::size_t degree) {
    const Integer power = pow(Integer(count), degree);
    return (degree - count) % 2 == 0 ? power : -power;
}

/// Applies the formula in one factor: `values` has one point per node, the result one point per control
/// point.
PointArray applied(const SimplexInverseFormula& formula, const PointArray& values, std::size_t behind) {
    const std::size_t nodes = formula.nodes.size();
    std::vector<Rational> all;
    for (const auto& row : formula.weights) all.insert(all.end(), row.begin(), row.end());
    const RationalVector weights(all);
    const std::span<const Integer> numerators = weights.numerators();
    const auto rows = each_row(values, [&](std::span<const Integer> row) {
        std::vector<Integer> points;
        for (std::size_t block = 0; block < row.size(); block += nodes * behind) {
            for (std::size_t i = 0; i < numerators.size(); i += nodes) {
                for (std::size_t k = 0; k < behind; ++k) {
                    Integer& point = points.emplace_back();
                    for (std::size_t j = 0; j < nodes; ++j)
                        point.add_product(numerators[i + j], row[block + j * behind + k]);
                }
            }
        }
        return points;
    });
    return canonical_points(rows, values.denominator() * weights.denominator());
}

/// The point of an interval with these barycentric coordinates.
Rational on_line(const Interval& interval, const Coordinates& barycentric) {
    return interval.a() + barycentric[1] * (interval.b() - interval.a());
}

}  // namespace

SimplexInverseFormula inverse_formula(const SimplexFactor& factor, const Limits& limits) {
    const auto [dimension, degree] = factor;
    const NetShape shape = NetShape::simplex(dimension, degree, limits);
    const std::size_t means = multi_index_count(dimension + 1, degree, limits);
    require_product_within({means, shape.size()}, limits.expansion_work, "expansion_work",
                           "the number of weights, of every control point in every mean,", Part::degree);
    const std::vector<MultiIndex> indices = multi_indices(dimension, degree);
    std::map<Coordinates, std::vector<Integer>, std::greater<>> columns;
    for (std::size_t count = 1; count <= degree; ++count) {
        const Integer power = signed_power(count, degree);
        for (const MultiIndex& copies : multi_indices(dimension, count)) {
            auto& column = columns[mean(copies, count)];
            column.resize(indices.size());
            for (std::size_t i = 0; i < indices.size(); ++i)
                column[i].add_product(power, choices(indices[i], copies));
        }
    }
    if (degree == 0) columns.emplace(mean(multi_indices(dimension, 1).front(), 1), std::vector<Integer>{1});
    SimplexInverseFormula formula;
    formula.weights.resize(indices.size());
    const Integer divisor = factorial(degree);
    for (const auto& [node, column] : columns) {
        formula.nodes.push_back(node);
        for (std::size_t i = 0; i < indices.size(); ++i) formula.weights[i].emplace_back(column[i], divisor);
    }
    return formula;
}

BezierPatch control_net_from_values(const NetShape& shape, const PatchFunction& map, const Limits& limits) {
    std::vector<SimplexInverseFormula> formulas;
    std::vector<PatchPoint> points{{}};
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        formulas.push_back(inverse_formula(shape[f], limits));
        const auto& nodes = formulas.back().nodes;
        require_product_within({nodes.size(), points.size()}, limits.numbers, "numbers",
                               "the number of nodes");
        std::vector<PatchPoint> longer;
        for (const PatchPoint& point : points) {
            for (const Coordinates& node : nodes) {
                longer.push_back(point);
                longer.back().push_back(node);
            }
        }
        points = std::move(longer);
    }
    std::vector<Coordinates> values;
    values.reserve(points.size());
    for (const PatchPoint& point : points) values.push_back(map(point));
    PointArray net(values);
    for (std::size_t f = shape.factors(); f-- > 0;) net = applied(formulas[f], net, shape.behind(f));
    return {shape, std::move(net)};
}

Coordinates blossom_from_values(const NetShape& shape, const PatchFunction& map,
                                const PatchArguments& arguments, const Limits& limits) {
    require_arguments(shape, arguments);
    within(Part::arguments, [&] { require_masses(arguments, 1, "an argument", require_mass); });
    std::vector<constructions::Groups<Tuple<Rational>>> groups;
    Integer divisor = 1;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        groups.push_back(constructions::grouped(std::span<const Coordinates>(arguments[f])));
        divisor *= factorial(shape[f].degree);
    }
    require_terms_of_polarization(multiplicities(arguments), limits);

    const auto scaled_value_at_mean = [&](const std::vector<Coordinates>& sums,
                                          const std::vector<std::size_t>& sizes) -> Coordinates {
        PatchPoint means = sums;
        Rational weight = 1;
        for (std::size_t f = 0; f < shape.factors(); ++f) {
            if (shape[f].degree == 0) {
                means[f][0] = 1;
                continue;
            }
            if (sizes[f] == 0) return {};
            for (Rational& coordinate : means[f]) coordinate /= Rational(sizes[f]);
            weight *= pow(Integer(sizes[f]), shape[f].degree);
        }
        Coordinates value = map(means);
        for (Rational& coordinate : value) coordinate *= weight;
        return value;
    };
    Coordinates value = constructions::polarized<Rational>(shape, groups, scaled_value_at_mean);
    for (Rational& coordinate : value) coordinate /= divisor;
    return value;
}

InverseFormula inverse_formula(std::size_t n, const Interval& interval, const Limits& limits) {
    SimplexInverseFormula of_segment = inverse_formula({1, n}, limits);
    InverseFormula formula{{}, std::move(of_segment.weights)};
    for (const Coordinates& node : of_segment.nodes) formula.nodes.push_back(on_line(interval, node));
    return formula;
}

BezierCurve control_points_from_values(std::size_t n, const Interval& interval,
                                       const std::function<Coordinates(const Rational&)>& map,
                                       const Limits& limits) {
    const auto on_segment = [&](const PatchPoint& point) { return map(on_line(interval, point.front())); };
    return {control_net_from_values(NetShape::simplex(1, n, limits), on_segment, limits).control_net(),
            interval};
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
