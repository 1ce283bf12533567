#include <blossom/core/patch/coordinate_sums.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

namespace blossom {

namespace {

/// det of the coordinates `rows` of the maps `maps`, by the permutations of the rows.
CoordinateSum minor_of(std::vector<std::size_t> rows, std::span<const std::size_t> maps) {
    CoordinateSum sum;
    do {
        CoordinateProduct product;
        std::size_t inversions = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            product.coordinates.push_back({maps[i], rows[i]});
            for (std::size_t j = 0; j < i; ++j) inversions += std::size_t{rows[j] > rows[i]};
        }
        product.factor = inversions % 2 == 0 ? 1 : -1;
        sum.push_back(std::move(product));
    } while (std::ranges::next_permutation(rows).found);
    return sum;
}

std::vector<std::size_t> counted(std::size_t count) {
    std::vector<std::size_t> indices(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    return indices;
}

void require_products(std::size_t dimension, const Limits& limits) {
    constexpr std::size_t most = 20;  // 20! is the last in a word
    std::size_t products = 1;
    for (std::size_t k = 2; k <= std::min(dimension, most); ++k) products *= k;
    require_within(products, limits.expansion_terms, "expansion_terms",
                   "the number of products of a determinant, at least", Part::maps);
}

}  // namespace

CoordinateSums linear_combination(std::span<const Rational> factors, std::size_t dimension) {
    CoordinateSums sums(dimension);
    for (std::size_t j = 0; j < dimension; ++j) {
        for (std::size_t i = 0; i < factors.size(); ++i) sums[j].push_back({{{i, j}}, factors[i]});
    }
    return sums;
}

CoordinateSums scalar_multiple(std::span<const std::size_t> dimensions) {
    std::optional<std::size_t> vector;
    CoordinateProduct scalars;
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        if (dimensions[i] == 1) {
            scalars.coordinates.push_back({i, 0});
            continue;
        }
        if (vector) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "map " + std::to_string(i) + " has " + std::to_string(dimensions[i]) +
                            " coordinates, and map " + std::to_string(*vector) +
                            " has more than one too; one factor at most is no scalar map",
                        Part::maps / i);
        }
        vector = i;
    }
    if (!vector) return {{std::move(scalars)}};
    CoordinateSums sums;
    for (std::size_t j = 0; j < dimensions[*vector]; ++j) {
        sums.push_back({scalars});
        sums.back().front().coordinates.push_back({*vector, j});
    }
    return sums;
}

CoordinateSums dot_product(std::size_t dimension) {
    CoordinateSum sum;
    for (std::size_t j = 0; j < dimension; ++j) sum.push_back({{{0, j}, {1, j}}});
    return {std::move(sum)};
}

CoordinateSums determinant(std::size_t dimension, const Limits& limits) {
    require_products(dimension, limits);
    return {minor_of(counted(dimension), counted(dimension))};
}

CoordinateSums cross_product(std::size_t dimension, const Limits& limits) {
    require_products(dimension, limits);
    CoordinateSums sums;
    for (std::size_t j = 0; j < dimension; ++j) {
        std::vector<std::size_t> rows = counted(dimension);
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(j));
        sums.push_back(minor_of(std::move(rows), counted(dimension - 1)));
        if (j % 2 == 0) continue;
        for (CoordinateProduct& product : sums.back()) product.factor = -product.factor;
    }
    return sums;
}

CoordinateSums affine_image(std::span<const Coordinates> matrix, std::span<const Rational> translation) {
    CoordinateSums sums;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        CoordinateSum& sum = sums.emplace_back();
        for (std::size_t j = 0; j < matrix[i].size(); ++j) sum.push_back({{{0, j}}, matrix[i][j]});
        sum.push_back({{}, translation[i]});
    }
    return sums;
}

CoordinateSums projective(CoordinateSums sums, std::span<const std::optional<CoordinateOf>> weights) {
    using Counts = std::map<CoordinateOf, std::size_t>;  // of each weight
    const auto counts_of = [&](const CoordinateProduct& product) {
        Counts counts;
        for (const CoordinateOf& one : product.coordinates) {
            if (weights[one.map]) ++counts[*weights[one.map]];
        }
        return counts;
    };
    Counts greatest;
    for (const CoordinateSum& sum : sums) {
        for (const CoordinateProduct& product : sum) {
            for (const auto& [weight, count] : counts_of(product))
                greatest[weight] = std::max(greatest[weight], count);
        }
    }
    const auto append = [](CoordinateProduct& product, const CoordinateOf& weight, std::size_t times) {
        product.coordinates.insert(product.coordinates.end(), times, weight);
    };
    CoordinateProduct denominator;
    for (const auto& [weight, count] : greatest) append(denominator, weight, count);
    for (CoordinateSum& sum : sums) {
        for (CoordinateProduct& product : sum) {
            Counts counts = counts_of(product);
            for (const auto& [weight, count] : greatest) append(product, weight, count - counts[weight]);
        }
    }
    sums.push_back({std::move(denominator)});
    return sums;
}

}  // namespace blossom
