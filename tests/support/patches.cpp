#include "patches.hpp"

#include "number_generators.hpp"

namespace blossom::testing {

namespace {

/// All (i_0, ..., i_s) of sum n.
std::vector<MultiIndex> indices_of_sum(std::size_t entries, std::size_t n) {
    if (entries == 1) return {{n}};
    std::vector<MultiIndex> all;
    for (std::size_t first = 0; first <= n; ++first) {
        for (MultiIndex rest : indices_of_sum(entries - 1, n - first)) {
            rest.insert(rest.begin(), first);
            all.push_back(std::move(rest));
        }
    }
    return all;
}

std::vector<std::vector<MultiIndex>> net_indices(const std::vector<SimplexFactor>& factors) {
    std::vector<std::vector<MultiIndex>> all{{}};
    for (const auto& [dimension, degree] : factors) {
        std::vector<std::vector<MultiIndex>> longer;
        for (const auto& indices : all) {
            for (const MultiIndex& index : indices_of_sum(dimension + 1, degree)) {
                longer.push_back(indices);
                longer.back().push_back(index);
            }
        }
        all = std::move(longer);
    }
    return all;
}

Integer ways(const MultiIndex& index) {
    Integer total = 0, product = 1;
    for (const std::size_t entry : index) {
        for (std::size_t i = 1; i <= entry; ++i) {
            total += 1;
            product = product * total / Integer(i);
        }
    }
    return product;
}

std::vector<SimplexFactor> factors_of(const NetShape& shape) {
    std::vector<SimplexFactor> factors;
    for (std::size_t f = 0; f < shape.factors(); ++f) factors.push_back(shape[f]);
    return factors;
}

}  // namespace

std::vector<std::vector<std::size_t>> products_of_simplices() {
    std::vector<std::vector<std::size_t>> all{{}};
    std::vector<std::vector<std::size_t>> result;
    while (!all.empty()) {
        std::vector<std::vector<std::size_t>> longer;
        for (const auto& dimensions : all) {
            std::size_t total = 0;
            for (const std::size_t s : dimensions) total += s;
            for (std::size_t s = 1; total + s <= 4; ++s) {
                longer.push_back(dimensions);
                longer.back().push_back(s);
            }
        }
        result.insert(result.end(), longer.begin(), longer.end());
        all = std::move(longer);
    }
    return result;
}

BezierPatch PatchRecipe::patch() const {
    std::vector<Coordinates> net;
    for (const auto& [indices, point] : points) net.push_back(point);
    return {NetShape(factors), net};
}

PatchRecipe patch(Random& random, const std::vector<std::size_t>& dimensions, Size size,
                  std::size_t most_points) {
    PatchRecipe recipe;
    std::vector<std::vector<MultiIndex>> indices;
    do {
        recipe.factors.clear();
        for (const std::size_t s : dimensions) recipe.factors.push_back({s, random.below(5)});
        indices = net_indices(recipe.factors);
    } while (indices.size() > most_points);
    const std::size_t d = 1 + random.below(3);
    for (auto& index : indices) {
        Coordinates point;
        for (std::size_t j = 0; j < d; ++j)
            point.push_back(random.one_in(4) ? Rational() : number(random, size));
        recipe.points.emplace(std::move(index), std::move(point));
    }
    return recipe;
}

Coordinates tuple_of_mass(Random& random, std::size_t dimension, const Rational& mass, Size size) {
    Coordinates result(dimension + 1);
    if (random.one_in(4)) {
        result[random.below(dimension + 1)] += 1;
        if (mass == 0) result[random.below(dimension + 1)] -= 1;
        if (mass == 0 || mass == 1) return result;
        result.assign(dimension + 1, 0);
    }
    Rational rest = mass;
    for (std::size_t k = 1; k <= dimension; ++k) {
        result[k] = number(random, size);
        rest -= result[k];
    }
    result[0] = rest;
    return result;
}

Coordinates tuple(Random& random, std::size_t dimension, Size size) {
    const std::uint64_t share = random.below(8);
    return tuple_of_mass(random, dimension, share < 4 ? 1 : share < 6 ? 0 : number(random, size), size);
}

PatchArguments patch_arguments(Random& random, const std::vector<SimplexFactor>& factors, Size size) {
    PatchArguments arguments;
    for (const auto& [dimension, degree] : factors) {
        auto& list = arguments.emplace_back();
        while (list.size() < degree) {
            const bool repeat = !list.empty() && random.one_in(3);
            Coordinates argument = repeat ? list[random.below(list.size())] : tuple(random, dimension, size);
            list.push_back(std::move(argument));
        }
    }
    return arguments;
}

PatchPoint patch_point(Random& random, const std::vector<SimplexFactor>& factors, Size size) {
    PatchPoint point;
    for (const auto& factor : factors) point.push_back(tuple_of_mass(random, factor.dimension, 1, size));
    return point;
}

Coordinates textbook_value(const PatchRecipe& recipe, const PatchArguments& arguments) {
    std::vector<MultiIndex> counts;
    for (const auto& factor : recipe.factors) counts.emplace_back(factor.dimension + 1);
    Coordinates sum(recipe.dimension());
    const auto assign = [&](const auto& self, std::size_t f, std::size_t i, const Rational& product) -> void {
        if (product.is_zero()) return;
        if (f == recipe.factors.size()) {
            const Coordinates& point = recipe.points.at(counts);
            for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += product * point[j];
            return;
        }
        if (i == arguments[f].size()) {
            self(self, f + 1, 0, product);
            return;
        }
        for (std::size_t vertex = 0; vertex < counts[f].size(); ++vertex) {
            ++counts[f][vertex];
            self(self, f, i + 1, product * arguments[f][i][vertex]);
            --counts[f][vertex];
        }
    };
    assign(assign, 0, 0, 1);
    return sum;
}

std::vector<std::vector<SparsePolynomial>> barycentric_variables(const NetShape& shape) {
    std::vector<std::vector<SparsePolynomial>> variables;
    std::size_t used = 0;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        auto& own = variables.emplace_back();
        for (std::size_t k = 0; k <= shape[f].dimension; ++k)
            own.push_back(SparsePolynomial::variable(used++));
    }
    return variables;
}

SparsePolynomial expanded(const BezierPatch& patch, std::size_t coordinate) {
    std::map<std::vector<MultiIndex>, Rational, std::greater<>> values;
    const auto indices = net_indices(factors_of(patch.shape()));
    for (const auto& index : indices) values[index];
    std::size_t i = 0;
    for (auto& [index, value] : values) value = patch.control_net()[i++][coordinate];
    std::vector<SparsePolynomial> terms;
    for (const auto& [index, value] : values) {
        std::vector<std::size_t> exponents;
        Rational coefficient = value;
        for (const MultiIndex& own : index) {
            exponents.insert(exponents.end(), own.begin(), own.end());
            coefficient *= ways(own);
        }
        if (!coefficient.is_zero()) terms.push_back(SparsePolynomial::term(coefficient, exponents));
    }
    return sum(terms);
}

}  // namespace blossom::testing
