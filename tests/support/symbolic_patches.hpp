#pragma once

// Patches over the ring of polynomials in many variables: what is shown here is shown for all their values.

#include <blossom/core/constructions/net_constructions.hpp>

#include <initializer_list>
#include <vector>

#include "symbolic.hpp"

namespace blossom::testing {

using SymbolTuple = Tuple<Symbol>;
using SymbolTuples = std::vector<SymbolTuple>;
using SymbolLists = std::vector<SymbolTuples>;

inline NetShape tensor_shape(std::initializer_list<std::size_t> degrees) {
    return NetShape::tensor(std::vector<std::size_t>(degrees));
}

/// (1 - u, u), a point of a segment.
inline SymbolTuple on_segment(const Symbol& u) { return {1 - u, u}; }
/// (1 - v - w, v, w), a point of a triangle.
inline SymbolTuple in_triangle(const Symbol& v, const Symbol& w) { return {1 - v - w, v, w}; }
/// The point with new symbols for its free coordinates.
inline SymbolTuple generic_point(Variables& variables, std::size_t dimension) {
    SymbolTuple tuple{1};
    for (std::size_t k = 0; k < dimension; ++k) {
        tuple.push_back(variables.next());
        tuple[0] -= tuple.back();
    }
    return tuple;
}
inline SymbolTuples generic_points(Variables& variables, std::size_t dimension, std::size_t n) {
    SymbolTuples tuples;
    while (tuples.size() < n) tuples.push_back(generic_point(variables, dimension));
    return tuples;
}
inline SymbolTuple vertex(std::size_t dimension, std::size_t k) {
    SymbolTuple tuple(dimension + 1, 0);
    tuple[k] = 1;
    return tuple;
}
/// i_k copies of each element.
inline SymbolTuples copies(const MultiIndex& index, const SymbolTuples& elements) {
    SymbolTuples tuples;
    for (std::size_t k = 0; k < index.size(); ++k) tuples.insert(tuples.end(), index[k], elements[k]);
    return tuples;
}

/// The blossom of a net by de Casteljau's algorithm.
inline Symbol by_casteljau(const NetShape& shape, const Symbols& net, const SymbolLists& arguments) {
    return constructions::folded_to_value<Symbol>(shape, net, arguments);
}

/// C(n, k) u^k (1 - u)^(n-k).
inline Symbol bernstein(std::size_t n, std::size_t k, const Symbol& u) {
    return scaled(binomial(n, k), pow(u, k) * pow(1 - u, n - k));
}

/// sum n!/(i!j!k!) u^i v^j w^k b_ijk, with the indices in lexicographically descending order.
inline Symbol triangle_value(std::size_t n, const Symbols& net, const SymbolTuple& point) {
    Symbol sum = 0;
    std::size_t place = 0;
    for (std::size_t i = n + 1; i-- > 0;) {
        for (std::size_t j = n - i + 1; j-- > 0;) {
            const std::size_t k = n - i - j;
            sum += scaled(binomial(n, i) * binomial(n - i, j),
                          net[place++] * pow(point[0], i) * pow(point[1], j) * pow(point[2], k));
        }
    }
    return sum;
}

}  // namespace blossom::testing
