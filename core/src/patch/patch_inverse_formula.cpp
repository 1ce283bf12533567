#include <blossom/core/patch/patch_inverse_formula.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "blossom/polarization.hpp"
#include "blossom/run_construction.hpp"
#include "maps/patch_kernel.hpp"

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

/// `values` with one point a node of one factor taken to one point a control point of it.
std::vector<Coordinates> applied(const SimplexInverseFormula& formula, const std::vector<Coordinates>& values,
                                 std::size_t behind) {
    const std::size_t nodes = formula.nodes.size();
    std::vector<Coordinates> result;
    for (std::size_t block = 0; block < values.size(); block += nodes * behind) {
        for (const auto& row : formula.weights) {
            for (std::size_t k = 0; k < behind; ++k) {
                Coordinates& point = result.emplace_back(values.front().size());
                for (std::size_t j = 0; j < nodes; ++j) {
                    if (row[j].is_zero()) continue;
                    const Coordinates& value = values[block + j * behind + k];
                    for (std::size_t i = 0; i < point.size(); ++i) point[i] += row[j] * value[i];
                }
            }
        }
    }
    return result;
}

}  // namespace

SimplexInverseFormula inverse_formula(std::size_t dimension, std::size_t degree, const Limits& limits) {
    const NetShape shape = NetShape::simplex(dimension, degree, limits);
    const std::size_t means = multi_index_count(dimension + 1, degree, limits);
    require_within(means, limits.expansion_work / shape.size(), "expansion_work",
                   "the number of means, each with a weight for every control point,", Part::degree);
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

BezierPatch control_net_from_values(const NetShape& shape, const PatchValues& map, const Limits& limits) {
    std::vector<SimplexInverseFormula> formulas;
    std::vector<PatchPoint> points{{}};
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        formulas.push_back(inverse_formula(shape[f].dimension, shape[f].degree, limits));
        const auto& nodes = formulas.back().nodes;
        require_within(nodes.size(), limits.numbers / points.size(), "numbers",
                       "the number of nodes of one factor");
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
    const PointArray of_one_dimension(values);
    for (std::size_t f = shape.factors(); f-- > 0;) values = applied(formulas[f], values, shape.behind(f));
    return {shape, values};
}

Coordinates blossom_from_values(const NetShape& shape, const PatchValues& map,
                                const PatchArguments& arguments, const Limits& limits) {
    require_arguments(shape, arguments);
    within(Part::arguments, [&] { require_masses(arguments, 1, "an argument"); });
    std::vector<constructions::Groups<Tuple<Rational>>> groups;
    std::vector<std::size_t> multiplicities;
    Integer divisor = 1;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        groups.push_back(constructions::grouped(std::span<const Coordinates>(arguments[f])));
        for (const auto& group : groups.back()) multiplicities.push_back(group.second);
        divisor *= factorial(shape[f].degree);
    }
    require_within(polarization_terms(multiplicities, limits.polarization_terms), limits.polarization_terms,
                   "polarization_terms", "the number of terms of polarization, at least", Part::arguments);

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

}  // namespace blossom
