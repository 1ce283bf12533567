#include <blossom/core/blossom/polar.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

template <class Map>
Map map_of_polar(std::pair<NetShape, PointArray> values) {
    auto& [shape, points] = values;
    if constexpr (std::same_as<Map, PolynomialPatch>) points = form_of(shape, points);
    return {std::move(shape), std::move(points)};
}

/// The same points on the product of the factors but one, of degree 0.
template <class Map>
Map without_factor(const Map& patch, std::size_t factor) {
    std::vector<SimplexFactor> factors = patch.shape().list();
    factors.erase(factors.begin() + static_cast<std::ptrdiff_t>(factor));
    return {
        NetShape(std::move(factors), {.degree = patch.shape().size(), .numbers = points_of(patch).size()}),
        points_of(patch)};
}

/// Coordinate j of the values as constants of the ring.
std::vector<SparsePolynomial> constants(const PointArray& polar, std::size_t j) {
    std::vector<SparsePolynomial> net;
    net.reserve(polar.size());
    for (const Integer& entry : polar.coordinate(j)) net.emplace_back(Rational(entry, polar.denominator()));
    return net;
}

std::size_t total_degree(const NetShape& shape) {
    std::size_t degree = 0;
    for (const SimplexFactor& factor : shape.list()) degree += factor.degree;
    return degree;
}

}  // namespace

template <PatchRepresentation Map>
Map polar(const Map& patch, const PatchArguments& arguments, const Limits& limits) {
    require_some_arguments(patch.shape(), arguments);
    return map_of_polar<Map>(partial_polar(patch.shape(), polar_of(patch), arguments, 1, limits));
}

template <PatchRepresentation Map>
Map isoparametric(const Map& patch, std::size_t factor, const Coordinates& argument, const Limits& limits) {
    if (patch.shape().factors() == 1) {
        throw Error(ErrorCode::wrong_arity, "a map on one factor has a value, and no map, at its argument");
    }
    PatchArguments arguments(patch.shape().factors());
    arguments[factor].assign(patch.shape()[factor].degree, argument);
    return without_factor(polar(patch, arguments, limits), factor);
}

template <PatchRepresentation Outer, PatchRepresentation Inner>
Inner composed(const Outer& outer, const Inner& arguments, const Limits& limits) {
    const NetShape& shape = outer.shape();
    if (arguments.dimension() != shape.dimension() + shape.factors()) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "the arguments of the outer map have " +
                        std::to_string(shape.dimension() + shape.factors()) + " coordinates, not " +
                        std::to_string(arguments.dimension()),
                    Part::arguments);
    }
    const std::size_t degree = total_degree(shape);
    std::vector<SimplexFactor> factors = arguments.shape().list();
    for (SimplexFactor& factor : factors) {
        require_product_within({factor.degree, degree}, limits.degree, "degree",
                               "the degree of the composition");
        factor.degree *= degree;
    }
    const NetShape result(std::move(factors), limits);
    require_product_within({result.size(), outer.dimension()}, limits.numbers, "numbers",
                           "the number of coordinates of the composition");
    require_product_within({result.size(), std::max(shape.size(), arguments.shape().size())},
                           limits.expansion_work, "expansion_work",
                           "the number of products in the composition");
    require_result_bits(
        bits_of(points_of(outer)) +
            degree * (bits_of(points_of(arguments)) + points_of(arguments).denominator().bit_length() + 2),
        limits, result.size() * outer.dimension());

    // The coefficients of a homogeneous polynomial are those with 1 for its first coordinate.
    const PolynomialPatch forms(arguments.shape(), PointArray(form_of(arguments)));
    TupleLists<SparsePolynomial> tuples;
    std::size_t coordinate = 0;
    for (const SimplexFactor& factor : shape.list()) {
        Tuple<SparsePolynomial> tuple;
        for (std::size_t k = 0; k <= factor.dimension; ++k) tuple.push_back(forms.coordinate(coordinate++));
        tuples.emplace_back(factor.degree, std::move(tuple));
    }
    const PointArray values(polar_of(outer));
    std::vector<SparsePolynomial> coordinates;
    coordinates.reserve(outer.dimension());
    for (std::size_t j = 0; j < outer.dimension(); ++j) {
        coordinates.push_back(constructions::folded_to_value(shape, constants(values, j), tuples));
    }
    PolynomialPatch form(result, coordinates, limits);
    if constexpr (std::same_as<Inner, PolynomialPatch>)
        return form;
    else
        return {result, polar_of(result, form.coefficients())};
}

template <PatchRepresentation Map>
BezierPatch restricted(const Map& patch, std::span<const PatchPoint> vertices, const Limits& limits) {
    if (vertices.empty())
        throw Error(ErrorCode::wrong_arity, "a simplex has at least one vertex", Part::vertices);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        within(Part::vertices, [&] { within(i, [&] { require_point(patch.shape().list(), vertices[i]); }); });
    // A factor in which the vertices agree does not add to the degree.
    PatchArguments fixed(patch.shape().factors());
    for (std::size_t f = 0; f < fixed.size(); ++f) {
        const bool agree = std::ranges::all_of(
            vertices, [&](const PatchPoint& vertex) { return vertex[f] == vertices.front()[f]; });
        if (agree) fixed[f].assign(patch.shape()[f].degree, vertices.front()[f]);
    }
    std::vector<Coordinates> points;
    for (const PatchPoint& vertex : vertices) {
        Coordinates& point = points.emplace_back();
        for (const Coordinates& argument : vertex)
            point.insert(point.end(), argument.begin(), argument.end());
    }
    const BezierPatch arguments(NetShape::simplex(vertices.size() - 1, 1, limits), points);
    return composed(polar(patch, fixed, limits), arguments, limits);
}

template BezierPatch polar(const BezierPatch&, const PatchArguments&, const Limits&);
template PolynomialPatch polar(const PolynomialPatch&, const PatchArguments&, const Limits&);
template BezierPatch isoparametric(const BezierPatch&, std::size_t, const Coordinates&, const Limits&);
template PolynomialPatch isoparametric(const PolynomialPatch&, std::size_t, const Coordinates&,
                                       const Limits&);
template BezierPatch composed(const BezierPatch&, const BezierPatch&, const Limits&);
template BezierPatch composed(const PolynomialPatch&, const BezierPatch&, const Limits&);
template PolynomialPatch composed(const BezierPatch&, const PolynomialPatch&, const Limits&);
template PolynomialPatch composed(const PolynomialPatch&, const PolynomialPatch&, const Limits&);
template BezierPatch restricted(const BezierPatch&, std::span<const PatchPoint>, const Limits&);
template BezierPatch restricted(const PolynomialPatch&, std::span<const PatchPoint>, const Limits&);

}  // namespace blossom
