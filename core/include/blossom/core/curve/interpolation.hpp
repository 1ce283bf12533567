#pragma once

#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// One datum of an interpolation: a derivative at a node, of which several may be known.
struct NodeDatum {
    std::size_t index = 0;  ///< of the node and its value in the lists given
    std::size_t order = 0;  ///< of the derivative
};

/// The data at these nodes in increasing order of the nodes, at one node in the order given: the value at its
/// first occurrence, the derivative of order 1 at its second, and so on.
/// Errors: `wrong_arity` for no node, or unless there is one value per node; `mismatched_dimensions`, at
/// `Part::values / i`, unless all values have the same dimension.
std::vector<NodeDatum> data_in_order(std::span<const Rational> nodes, std::span<const Coordinates> values);

/// The polynomial map of formal degree n, one less than the number of nodes, with these values; where a node
/// occurs k times before, the value is that of the derivative of order k.
///
/// Newton's form by divided differences, in which [x, ..., x] of k + 1 equal nodes is P^(k)(x) / k!. Cost:
/// n^2 / 2 differences and n^2 / 2 multiply-adds a coordinate. Errors: those of `data_in_order`;
/// `limit_exceeded`.
PolynomialCurve interpolate(std::span<const Rational> nodes, std::span<const Coordinates> values,
                            const Limits& limits = {});

/// a + i (b - a) / n for i = 0..n; a alone for n = 0.
std::vector<Rational> uniform_nodes(const Interval& interval, std::size_t n);

}  // namespace blossom
