#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/rational/error.hpp>

#include <bit>
#include <string>

#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

void require_degree(std::size_t n, std::size_t r, const Limits& limits) {
    require_within(r, limits.degree, "degree", "the number of degrees to raise by", Part::by);
    require_within(n + r, limits.degree, "degree", "the raised degree", Part::by);
}

}  // namespace

BezierCurve elevate(const BezierCurve& curve, std::size_t r, const Limits& limits) {
    if (r == 0) return curve;
    return {elevate(as_patch(curve), 0, r, limits).control_net(), curve.interval()};
}

PolynomialCurve elevate(const PolynomialCurve& curve, std::size_t r, const Limits& limits) {
    require_degree(curve.degree(), r, limits);
    return PolynomialCurve(curve.coefficients().to_points(), curve.degree() + r);
}

BezierPatch elevate(const BezierPatch& patch, std::size_t factor, std::size_t r, const Limits& limits) {
    const NetShape& shape = patch.shape();
    const auto [dimension, degree] = shape[factor];
    require_degree(degree, r, limits);
    const NetShape raised = shape.with_degree(factor, degree + r, limits);
    require_within(raised.size(), limits.numbers / patch.dimension(), "numbers",
                   "the number of points of the raised net", Part::by);
    if (r == 0) return patch;
    // A binomial coefficient of a multi-index of sum n is below (s + 1)^n, above and below the line.
    const auto bits_per_degree = static_cast<std::size_t>(std::bit_width(dimension + 1));
    require_result_bits(bits_of(patch.control_net()) + 2 * (degree + r) * bits_per_degree, limits,
                        raised.size() * patch.dimension());
    const std::size_t steps = multi_index_count(dimension, r, limits);
    require_within(
        shape.size(), limits.expansion_work / steps, "expansion_work",
        "the number of points, each of which enters " + std::to_string(steps) + " points of the raised net,",
        Part::by);

    const std::vector<MultiIndex> indices = multi_indices(dimension, degree);
    const std::vector<MultiIndex> added = multi_indices(dimension, r);
    const std::vector<Integer> powers = multinomials(NetShape::simplex(dimension, r, limits));
    const PointArray form = form_of(patch);
    const std::size_t before = shape.before(factor);
    const std::size_t behind = shape.behind(factor);
    std::vector<std::vector<Integer>> rows(patch.dimension(), std::vector<Integer>(raised.size()));
    MultiIndex sum;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        for (std::size_t j = 0; j < added.size(); ++j) {
            sum = indices[i];
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += added[j][k];
            const std::size_t place = position(sum);
            for (std::size_t c = 0; c < rows.size(); ++c) {
                const std::span<const Integer> row = form.coordinate(c);
                for (std::size_t block = 0; block < before; ++block) {
                    const std::size_t from = (block * indices.size() + i) * behind;
                    const std::size_t to = (block * raised.count(factor) + place) * behind;
                    for (std::size_t k = 0; k < behind; ++k)
                        rows[c][to + k].add_product(row[from + k], powers[j]);
                }
            }
        }
    }
    return {raised, polar_of(raised, canonical_points(rows, form.denominator()))};
}

PolynomialPatch elevate(const PolynomialPatch& patch, std::size_t factor, std::size_t r,
                        const Limits& limits) {
    const std::size_t degree = patch.shape()[factor].degree;
    require_degree(degree, r, limits);
    return regrouped(patch, patch.shape().with_degree(factor, degree + r, limits), limits);
}

template <PatchRepresentation Map>
Map elevated_to(const Map& patch, std::span<const std::size_t> degrees, const Limits& limits) {
    Map result = patch;
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

template BezierPatch elevated_to(const BezierPatch&, std::span<const std::size_t>, const Limits&);
template PolynomialPatch elevated_to(const PolynomialPatch&, std::span<const std::size_t>, const Limits&);

}  // namespace blossom
