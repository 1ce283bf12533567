#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/interpolation.hpp>
#include <blossom/core/patch/net_interpolation.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/spline/spline_interpolation.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "curve/newton_steps.hpp"

namespace blossom {

namespace {

void require_grid(const GridData& data, std::size_t directions) {
    if (data.nodes.empty() || data.nodes.size() != directions) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(data.nodes.size()) + " lists of nodes for " + std::to_string(directions) +
                        " directions",
                    Part::nodes);
    }
    std::size_t count = 1;
    for (const auto& nodes : data.nodes) {
        if (__builtin_mul_overflow(count, nodes.size(), &count)) count = 0;
    }
    if (count != data.values.size() || count == 0) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(data.values.size()) + " values on a grid of another number of points",
                    Part::values);
    }
}

/// The values with those in direction d replaced by as many points fit(d, nodes, values of a curve): all rows
/// are one curve, of which each other value is a coordinate.
template <class Fit>
std::vector<Coordinates> along_directions(const GridData& data, const Fit& fit) {
    std::vector<Coordinates> values = data.values;
    const std::size_t dimension = values.front().size();
    std::size_t behind = 1;
    for (std::size_t d = data.nodes.size(); d-- > 0;) {
        const std::size_t count = data.nodes[d].size();
        std::vector<Coordinates> rows(count);
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::ranges::move(values[i], std::back_inserter(rows[i / behind % count]));
        }
        rows = within(Part::nodes, [&] {
            return within(d, [&] {
                try {
                    return fit(d, std::span(data.nodes[d]), std::span<const Coordinates>(rows));
                } catch (const Error& error) {
                    throw error.at(error.place().inside(Part::nodes));
                }
            });
        });
        std::vector<std::size_t> taken(count);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t row = i / behind % count;
            const auto begin = rows[row].begin() + static_cast<std::ptrdiff_t>(taken[row]);
            values[i].assign(std::make_move_iterator(begin),
                             std::make_move_iterator(begin + static_cast<std::ptrdiff_t>(dimension)));
            taken[row] += dimension;
        }
        behind *= count;
    }
    return values;
}

/// Calls steps(row) for the numbers on every line of a net from vertex 0 in the direction of vertex k.
template <class Steps>
void on_lines(std::span<Integer> numbers, const std::vector<MultiIndex>& indices, std::size_t k,
              const Steps& steps) {
    std::vector<Integer> row;
    for (const MultiIndex& first : indices) {
        if (first[k] > 0) continue;
        std::vector<std::size_t> places;
        for (MultiIndex index = first;; --index[0], ++index[k]) {
            places.push_back(position(index));
            if (index[0] == 0) break;
        }
        row.clear();
        for (const std::size_t place : places) row.push_back(std::move(numbers[place]));
        steps(std::span(row));
        for (std::size_t i = 0; i < places.size(); ++i) numbers[places[i]] = std::move(row[i]);
    }
}

void take_differences(std::span<Integer> row) {
    for (std::size_t level = 1; level < row.size(); ++level) {
        for (std::size_t i = row.size() - 1; i >= level; --i) row[i] -= row[i - 1];
    }
}

}  // namespace

BezierPatch interpolate(const GridData& data, std::span<const Interval> box, const Limits& limits) {
    require_grid(data, box.size());
    const std::vector<Coordinates> points = along_directions(
        data, [&](std::size_t d, std::span<const Rational> nodes, std::span<const Coordinates> values) {
            return control_points(interpolate(nodes, values, limits), box[d], limits)
                .control_points()
                .to_points();
        });
    std::vector<std::size_t> degrees;
    degrees.reserve(data.nodes.size());
    for (const auto& nodes : data.nodes) degrees.push_back(nodes.size() - 1);
    return {NetShape::tensor(degrees, limits), points};
}

TensorBSpline interpolate(const GridData& data, std::span<const KnotVector> knots, const Limits& limits) {
    require_grid(data, knots.size());
    std::vector<Coordinates> points = along_directions(
        data, [&](std::size_t d, std::span<const Rational> nodes, std::span<const Coordinates> values) {
            return interpolate(knots[d], nodes, values, limits).control_points();
        });
    return {{knots.begin(), knots.end()}, std::move(points)};
}

BezierPatch interpolate_on_lattice(const SimplexFactor& simplex, const PointArray& values,
                                   const Limits& limits) {
    const auto [dimension, n] = simplex;
    const NetShape shape = NetShape::simplex(dimension, n, limits);
    if (n == 0 || dimension == 0 || values.size() != shape.size()) return {shape, values};
    const std::vector<MultiIndex> indices = multi_indices(dimension, n);
    const Integer factor = factorial(n);
    require_result_bits(greatest_bit_length(values.numbers().numerators()) + n + 2 * factor.bit_length(),
                        limits, values.numbers().size());
    std::vector<Integer> nodes(n);
    std::iota(nodes.begin(), nodes.end(), 0);
    std::vector<Integer> numerators;
    for (const auto given : values.rows()) {
        std::vector<Integer> row(given.begin(), given.end());
        for (std::size_t k = 1; k <= dimension; ++k) on_lines(row, indices, k, take_differences);
        // n! / prod a_k! is an integer, since the sum of the a_k is at most n.
        for (std::size_t i = 0; i < row.size(); ++i) {
            Integer divisor = 1;
            for (std::size_t k = 1; k <= dimension; ++k) divisor *= factorial(indices[i][k]);
            row[i] *= divide_exactly(factor, divisor);
        }
        for (std::size_t k = 1; k <= dimension; ++k) {
            on_lines(row, indices, k, [&](std::span<Integer> line) { multiply_by_nodes(line, nodes); });
        }
        for (std::size_t i = 0; i < row.size(); ++i) row[i] *= pow(Integer(n), n - indices[i][0]);
        std::ranges::move(row, std::back_inserter(numerators));
    }
    PointArray coefficients(values.dimension(),
                            RationalVector(std::move(numerators), values.denominator() * factor));
    coefficients.make_canonical();
    const BarycentricFrame frame = BarycentricFrame::standard(dimension);
    return control_net(PolynomialPatch(shape, std::move(coefficients)), std::span(&frame, 1), limits);
}

}  // namespace blossom
