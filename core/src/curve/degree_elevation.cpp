#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/net_steps.hpp>

#include <algorithm>
#include <bit>
#include <iterator>
#include <string>

#include "maps/binomial_weights.hpp"
#include "maps/patch_kernel.hpp"

namespace blossom {

namespace {

void require_degree(std::size_t n, std::size_t r, const Limits& limits) {
    require_within(r, limits.degree, "degree", "the number of degrees to raise by", Part::by);
    require_within(n + r, limits.degree, "degree", "the raised degree", Part::by);
}

}  // namespace

BezierCurve elevate(const BezierCurve& curve, std::size_t r, const Limits& limits) {
    constexpr std::size_t few = 2;
    if (r == 0) return curve;
    if (r < few) return {elevate(as_patch(curve), 0, r, limits).control_net(), curve.interval()};
    const std::size_t n = curve.degree();
    const PointArray& points = curve.control_points();
    require_degree(n, r, limits);
    require_product_within({n + r + 1, points.dimension()}, limits.numbers, "numbers",
                           "the number of coordinates of the raised net", Part::by);
    const auto weights = binomial_weights(n + r);
    require_result_bits(bits_of(points) + (n + r) + weights->denominator.bit_length(), limits,
                        (n + r + 1) * points.dimension());
    const std::vector<Integer> binomials = binomial_row(n);
    const std::vector<Integer> factor = binomial_row(r);
    std::vector<Integer> numerators;
    numerators.reserve((n + r + 1) * points.dimension());
    for (std::size_t j = 0; j < points.dimension(); ++j) {
        std::vector<Integer> form(points.coordinate(j).begin(), points.coordinate(j).end());
        for (std::size_t k = 0; k <= n; ++k) form[k] *= binomials[k];
        std::ranges::move(product(form, factor), std::back_inserter(numerators));
    }
    PointArray raised(points.dimension(), points.numbers()
                                              .over_same_denominator(std::move(numerators))
                                              .weighted(weights->numerators, weights->denominator));
    raised.make_canonical();
    return {std::move(raised), curve.interval()};
}

PolynomialCurve elevate(const PolynomialCurve& curve, std::size_t r, const Limits& limits) {
    require_degree(curve.degree(), r, limits);
    return PolynomialCurve(curve.coefficients().to_points(), curve.degree() + r);
}

BezierPatch elevate(const BezierPatch& patch, std::size_t factor, std::size_t r, const Limits& limits) {
    const NetShape& shape = patch.shape();
    const auto [dimension, degree] = shape[factor];
    require_degree(degree, r, limits);
    NetShape raised = shape.with_degree(factor, degree + r, limits);
    require_product_within({raised.size(), patch.dimension()}, limits.numbers, "numbers",
                           "the number of coordinates of the raised net", Part::by);
    if (r == 0) return patch;
    // A multinomial coefficient of an index of sum n is below (s + 1)^n, in numerators and denominators.
    const auto bits_per_degree = static_cast<std::size_t>(std::bit_width(dimension + 1));
    require_result_bits(bits_of(patch.control_net()) + 2 * (degree + r) * bits_per_degree, limits,
                        raised.size() * patch.dimension());
    if (r == 1) {
        const PointArray& net = patch.control_net();
        return {
            std::move(raised),
            canonical_points(net.dimension(),
                             raised_by_one({net.numbers().numerators(), shape[factor], shape.behind(factor)}),
                             net.denominator() * Integer(degree + 1))};
    }
    const std::size_t steps = multi_index_count(dimension, r, limits);
    require_product_within({shape.size(), steps}, limits.expansion_work, "expansion_work",
                           "the number of terms of the points of the raised net", Part::by);

    // On a segment the position of a sum of indices is the sum of their positions.
    const bool segment = dimension == 1;
    const auto indices = segment ? std::vector<MultiIndex>() : multi_indices(dimension, degree);
    const auto added = segment ? std::vector<MultiIndex>() : multi_indices(dimension, r);
    const std::size_t count = shape.count(factor);
    const std::vector<Integer> powers = multinomials(NetShape::simplex(dimension, r, limits));
    const PointArray form(patch.dimension(), patch.control_net().numbers().weighted(multinomials(shape), 1));
    const std::size_t before = shape.before(factor);
    const std::size_t behind = shape.behind(factor);
    std::vector<Integer> product(patch.dimension() * raised.size());
    MultiIndex sum;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < powers.size(); ++j) {
            if (!segment) sum = indices[i];
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += added[j][k];
            const std::size_t place = segment ? i + j : position(sum);
            for (std::size_t c = 0; c < patch.dimension(); ++c) {
                const std::span<const Integer> row = form.coordinate(c);
                for (std::size_t block = 0; block < before; ++block) {
                    const std::size_t from = (block * count + i) * behind;
                    const std::size_t to =
                        c * raised.size() + (block * raised.count(factor) + place) * behind;
                    for (std::size_t k = 0; k < behind; ++k)
                        product[to + k].add_product(row[from + k], powers[j]);
                }
            }
        }
    }
    const PointArray product_form(patch.dimension(), RationalVector(std::move(product), form.denominator()));
    return {raised, polar_of(raised, product_form)};
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
