#pragma once

// Each construction on a patch, over the integers or a symbolic ring, from its own data.

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/constructions/net_constructions.hpp>

#include "maps/patch_kernel.hpp"

namespace blossom {

/// The values of a blossom at the elements of a frame, and arguments with coordinates in this frame.
template <class R>
struct Source {
    PointArray points;
    TupleLists<R> arguments;
};

/// The values over the frame in which the first element is added to, or subtracted from, all others: this
/// converts between the vertices of a simplex and its first vertex with the edges from there.
PointArray sheared(const NetShape& shape, const PointArray& polar, int sign, const Limits& limits);

/// The first coordinate plus or minus the sum of the others.
template <class R>
TupleLists<R> sheared(TupleLists<R> arguments, int sign) {
    for (auto& list : arguments) {
        for (Tuple<R>& tuple : list) {
            for (std::size_t k = 1; k < tuple.size(); ++k) tuple[0] += R(sign) * tuple[k];
        }
    }
    return arguments;
}

/// Coordinates with respect to the vertices, or to one of them and the edges from there: an origin and unit
/// vectors.
template <class R>
Source<R> source(const PatchMap& map, bool vertices, const TupleLists<R>& arguments, const Limits& limits) {
    PointArray polar = std::visit([](const auto& one) -> PointArray { return polar_of(one); }, map);
    if (std::holds_alternative<BezierPatch>(map) == vertices) return {std::move(polar), arguments};
    const int sign = vertices ? 1 : -1;
    return {sheared(shape_of(map), polar, sign, limits), sheared(arguments, -sign)};
}

/// The sum of the points, each multiplied by the weight of its index in every factor.
template <class R>
std::vector<R> weighted_sum(const PointArray& points, const std::vector<std::vector<R>>& weights) {
    std::vector<R> sums;
    for (const auto row : points.rows())
        sums.push_back(constructions::contracted(std::vector<R>(row.begin(), row.end()), std::span(weights)));
    return sums;
}

template <class R>
Quotients<R> by_symmetric_functions(const PatchMap& map, const TupleLists<R>& arguments,
                                    const Limits& limits) {
    const NetShape& shape = shape_of(map);
    const auto [points, tuples] = source(map, false, arguments, limits);
    std::vector<std::vector<R>> functions;
    functions.reserve(shape.factors());
    for (std::size_t f = 0; f < shape.factors(); ++f)
        functions.push_back(constructions::times_linear_forms<R>(shape[f].dimension, 0, {R(1)}, tuples[f]));
    return {weighted_sum(points, functions), points.denominator()};
}

template <class R>
Quotients<R> by_polarization(const PatchMap& map, const TupleLists<R>& arguments, const Limits& limits) {
    const NetShape& shape = shape_of(map);
    const auto [points, given] = source(map, false, arguments, limits);
    const PointArray form = form_of(shape, points);
    const bool segment = shape.factors() == 1 && shape[0].dimension == 1;
    std::vector<std::vector<R>> rows;
    for (const auto row : form.rows()) rows.emplace_back(row.begin(), row.end());
    const auto value_at = [&](const std::vector<Tuple<R>>& tuples, const std::vector<std::size_t>&) {
        if (segment) return constructions::form_values(rows, tuples[0][1], tuples[0][0]);
        std::vector<std::vector<R>> monomials;
        monomials.reserve(shape.factors());
        for (std::size_t f = 0; f < shape.factors(); ++f)
            monomials.push_back(constructions::monomials(tuples[f], shape[f].degree));
        return weighted_sum(form, monomials);
    };
    std::vector<constructions::Groups<Tuple<R>>> groups;
    Integer denominator = form.denominator();
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        groups.push_back(constructions::grouped(std::span<const Tuple<R>>(given[f])));
        denominator *= factorial(shape[f].degree);
    }
    return {constructions::polarized<R>(shape, groups, value_at), std::move(denominator)};
}

template <class R>
Quotients<R> by_casteljau(const PatchMap& map, const TupleLists<R>& arguments, const Limits& limits) {
    const auto [points, tuples] = source(map, true, arguments, limits);
    Quotients<R> value{{}, points.denominator()};
    for (const auto row : points.rows()) {
        value.numerators.push_back(
            constructions::folded_to_value<R>(shape_of(map), std::vector<R>(row.begin(), row.end()), tuples));
    }
    return value;
}

template <class R>
Quotients<R> run_construction(const PatchMap& map, Construction construction, const TupleLists<R>& arguments,
                              const Limits& limits) {
    if (construction == Construction::symmetric) return by_symmetric_functions(map, arguments, limits);
    if (construction == Construction::polarization) return by_polarization(map, arguments, limits);
    return by_casteljau(map, arguments, limits);
}

}  // namespace blossom
