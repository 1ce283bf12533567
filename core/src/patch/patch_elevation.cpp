#include <blossom/core/patch/patch_elevation.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

/// For every pair of an index of degree n and one of degree r the place of their sum among those of degree n
/// + r, row by row.
std::vector<std::size_t> places_of_sums(std::span<const MultiIndex> first,
                                        std::span<const MultiIndex> second) {
    std::vector<std::size_t> places;
    places.reserve(first.size() * second.size());
    for (const MultiIndex& a : first) {
        for (const MultiIndex& b : second) {
            MultiIndex sum = a;
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += b[k];
            places.push_back(position(sum));
        }
    }
    return places;
}

}  // namespace

BezierPatch elevate(const BezierPatch& patch, std::size_t factor, std::size_t r, const Limits& limits) {
    const NetShape& shape = patch.shape();
    const auto [dimension, degree] = shape[factor];
    require_within(r, limits.degree, "degree", "the number of degrees to raise by", Part::by);
    require_within(degree + r, limits.degree, "degree", "the raised degree", Part::by);
    const NetShape raised = shape.with_degree(factor, degree + r, limits);
    require_within(raised.size(), limits.numbers / patch.dimension(), "numbers",
                   "the number of points of the raised net", Part::by);
    if (r == 0) return patch;
    const std::size_t steps = multi_index_count(dimension, r, limits);
    require_within(
        shape.size(), limits.expansion_work / steps, "expansion_work",
        "the number of points, each of which enters " + std::to_string(steps) + " points of the raised net,",
        Part::by);

    const std::vector<std::size_t> places =
        places_of_sums(multi_indices(dimension, degree), multi_indices(dimension, r));
    const std::vector<Integer> powers = multinomials(NetShape::simplex(dimension, r, limits));
    const PointArray form = form_of(shape, patch.control_net());
    const std::size_t behind = shape.behind(factor);
    const auto rows = each_row(form, [&](std::span<const Integer> row) {
        std::vector<Integer> product(raised.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::size_t index = i / behind % shape.count(factor);
            const std::size_t block = i / behind / shape.count(factor) * raised.count(factor);
            for (std::size_t j = 0; j < powers.size(); ++j) {
                const std::size_t place = places[index * powers.size() + j];
                product[(block + place) * behind + i % behind].add_product(row[i], powers[j]);
            }
        }
        return product;
    });
    return {raised, polar_of(raised, canonical_points(rows, form.denominator()))};
}

BezierPatch elevated_to(const BezierPatch& patch, std::span<const std::size_t> degrees,
                        const Limits& limits) {
    BezierPatch result = patch;
    for (std::size_t f = 0; f < patch.shape().factors(); ++f) {
        const std::size_t degree = patch.shape()[f].degree;
        if (degrees[f] < degree) {
            throw Error(ErrorCode::degree_too_low,
                        "the degree of factor " + std::to_string(f) + " is " + std::to_string(degree) +
                            ", more than " + std::to_string(degrees[f]),
                        Part::degree);
        }
        result = elevate(result, f, degrees[f] - degree, limits);
    }
    return result;
}

}  // namespace blossom
