#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>

#include "patch_kernel.hpp"

namespace blossom {

namespace {

void require_complete(const NetShape& shape, std::size_t given) {
    if (given == shape.size()) return;
    throw Error(ErrorCode::incomplete_net,
                "the map has " + std::to_string(given) + " coefficients; its shape needs " +
                    std::to_string(shape.size()),
                Part::coefficients);
}

/// The multi-indices, one per factor, of the term with these exponents of all variables. Errors:
/// `degree_too_low`.
std::vector<MultiIndex> indices_of(const NetShape& shape, std::span<const std::size_t> exponents) {
    std::vector<MultiIndex> indices;
    std::size_t variable = 0;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        const auto [dimension, degree] = shape[f];
        MultiIndex index(dimension + 1);
        std::size_t total = 0;
        for (std::size_t k = 1; k <= dimension; ++k) total += index[k] = exponents[variable++];
        if (total > degree) {
            throw Error(ErrorCode::degree_too_low,
                        "a term has degree " + std::to_string(total) + " in the variables of factor " +
                            std::to_string(f) + ", more than its formal degree " + std::to_string(degree),
                        Part::degree);
        }
        index[0] = degree - total;
        indices.push_back(std::move(index));
    }
    return indices;
}

PointArray coefficients_of(const NetShape& shape, std::span<const SparsePolynomial> coordinates,
                           const Limits& limits) {
    if (coordinates.empty()) throw Error(ErrorCode::wrong_arity, "a map needs at least one coordinate");
    require_product_within({shape.size(), coordinates.size()}, limits.numbers, "numbers",
                           "the number of coefficients");
    const std::size_t variables = shape.dimension();
    std::vector<Rational> numbers(coordinates.size() * shape.size());
    for (std::size_t j = 0; j < coordinates.size(); ++j) {
        const SparsePolynomial& polynomial = coordinates[j];
        for (std::size_t term = 0; term < polynomial.size(); ++term) {
            std::vector<std::size_t> exponents;
            for (std::size_t i = 0; i < std::max(variables, polynomial.variables()); ++i) {
                exponents.push_back(i < polynomial.variables() ? polynomial.exponent(term, i) : 0);
                if (i >= variables && exponents.back() > 0) {
                    throw Error(ErrorCode::wrong_arity, "a map on a space of dimension " +
                                                            std::to_string(variables) + " has no variable " +
                                                            std::to_string(i));
                }
            }
            numbers[j * shape.size() + shape.position_of(indices_of(shape, exponents))] =
                polynomial.coefficient(term);
        }
    }
    return {coordinates.size(), RationalVector(numbers)};
}

/// For every coefficient, in order, the exponents of all variables.
std::vector<std::vector<std::size_t>> exponents_of(const NetShape& shape) {
    std::vector<std::vector<std::size_t>> all{{}};
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        std::vector<std::vector<std::size_t>> longer;
        for (const auto& exponents : all) {
            for (const MultiIndex& index : multi_indices(shape[f].dimension, shape[f].degree)) {
                longer.push_back(exponents);
                longer.back().insert(longer.back().end(), index.begin() + 1, index.end());
            }
        }
        all = std::move(longer);
    }
    return all;
}

Coordinates with_mass(std::span<const Rational> tuple, int mass) {
    Coordinates argument(1, Rational(mass));
    argument.insert(argument.end(), tuple.begin(), tuple.end());
    return argument;
}

}  // namespace

PolynomialPatch::PolynomialPatch(NetShape shape, PointArray coefficients)
    : shape_(std::move(shape)), coefficients_(std::move(coefficients)) {
    require_complete(shape_, coefficients_.size());
}

PolynomialPatch::PolynomialPatch(NetShape shape, std::span<const SparsePolynomial> coordinates,
                                 const Limits& limits)
    : shape_(std::move(shape)), coefficients_(coefficients_of(shape_, coordinates, limits)) {}

SparsePolynomial PolynomialPatch::coordinate(std::size_t j) const {
    const auto exponents = exponents_of(shape_);
    const std::span<const Integer> row = coefficients_.coordinate(j);
    std::vector<SparsePolynomial> terms;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i].is_zero()) continue;
        terms.push_back(SparsePolynomial::term(Rational(row[i], coefficients_.denominator()), exponents[i]));
    }
    return sum(terms);
}

Coordinates point_argument(std::span<const Rational> point) { return with_mass(point, 1); }
Coordinates vector_argument(std::span<const Rational> vector) { return with_mass(vector, 0); }

PolynomialPatch regrouped(const PolynomialPatch& patch, const NetShape& shape, const Limits& limits) {
    if (shape.dimension() != patch.shape().dimension()) {
        throw Error(ErrorCode::wrong_arity, "a map in " + std::to_string(patch.shape().dimension()) +
                                                " variables cannot be written in " +
                                                std::to_string(shape.dimension()));
    }
    require_product_within({shape.size(), patch.dimension()}, limits.numbers, "numbers",
                           "the number of coefficients");
    const auto exponents = exponents_of(patch.shape());
    const std::size_t size = patch.shape().size();
    std::vector<Integer> numerators(shape.size() * patch.dimension());
    for (std::size_t i = 0; i < size; ++i) {
        if (std::ranges::all_of(patch.coefficients().rows(),
                                [&](const auto& row) { return row[i].is_zero(); }))
            continue;
        const std::size_t place = shape.position_of(indices_of(shape, exponents[i]));
        for (std::size_t j = 0; j < patch.dimension(); ++j) {
            numerators[j * shape.size() + place] = patch.coefficients().coordinate(j)[i];
        }
    }
    return {shape, PointArray(patch.dimension(),
                              RationalVector(std::move(numerators), patch.coefficients().denominator()))};
}

}  // namespace blossom
