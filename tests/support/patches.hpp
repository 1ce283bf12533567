#pragma once

// Patches over products of simplices as the numbers from which they were made, and their definitions.

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/maps/bezier_patch.hpp>

#include <functional>
#include <map>
#include <vector>

#include "map_generators.hpp"

namespace blossom::testing {

/// The dimensions of the factors of every product of simplices of total dimension 1 to 4.
std::vector<std::vector<std::size_t>> products_of_simplices();

/// A control net by its multi-indices, one per factor.
struct PatchRecipe {
    std::vector<SimplexFactor> factors;
    std::map<std::vector<MultiIndex>, Coordinates, std::greater<>> points;

    BezierPatch patch() const;
    std::size_t dimension() const { return points.begin()->second.size(); }
};

/// Degrees 0 to 4, lower if the net would have more than `most_points`.
PatchRecipe patch(Random& random, const std::vector<std::size_t>& dimensions, Size size,
                  std::size_t most_points = 100);

/// Calls check(random, recipe) for `rounds` patches over every product of simplices.
template <class Check>
void for_random_patches(std::uint64_t seed, std::size_t rounds, std::size_t most_points, const Check& check) {
    Random random(seed);
    for (const auto& dimensions : products_of_simplices()) {
        for (std::size_t round = 0; round < rounds; ++round) {
            const Size size = round % 4 == 0 ? Size::any : Size::small;
            check(random, patch(random, dimensions, size, most_points));
        }
    }
}

/// s + 1 numbers with the sum `mass`; in a quarter of the cases a vertex, or the difference of two.
Coordinates tuple_of_mass(Random& random, std::size_t dimension, const Rational& mass, Size size);
/// In half of the cases a point, otherwise a vector or a tuple of any mass.
Coordinates tuple(Random& random, std::size_t dimension, Size size);
/// One list per factor; each argument repeats an earlier one in a third of the cases.
PatchArguments patch_arguments(Random& random, const std::vector<SimplexFactor>& factors, Size size);
PatchPoint patch_point(Random& random, const std::vector<SimplexFactor>& factors, Size size);

/// The sum over all ways to assign to every argument a vertex of its factor: the product of the corresponding
/// coordinates times the control point with these vertices.
Coordinates textbook_value(const PatchRecipe& recipe, const PatchArguments& arguments);

/// One coordinate as a polynomial in the barycentric coordinates of all factors, by Bernstein polynomials.
SparsePolynomial expanded(const BezierPatch& patch, std::size_t coordinate);
/// Variables for the barycentric coordinates, one list per factor.
std::vector<std::vector<SparsePolynomial>> barycentric_variables(const NetShape& shape);

}  // namespace blossom::testing
