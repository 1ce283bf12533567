#pragma once

#include <blossom/core/constructions/constructions.hpp>
#include <blossom/core/constructions/net_shape.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

/// The constructions of a blossom over a product of simplices, as templates over any commutative ring R that
/// contains the integers, like those for curves in `constructions.hpp`. A net is a row of elements of R in
/// the order of `NetShape`, for one coordinate of the map.

namespace blossom {

/// A homogeneous argument of one factor over R: s + 1 coordinates with respect to the vertices.
template <class R>
using Tuple = std::vector<R>;

/// One list of arguments per factor.
template <class R>
using TupleLists = std::vector<std::vector<Tuple<R>>>;

namespace constructions {

/// One step of de Casteljau's algorithm in one factor: the net of the blossom with one argument fixed. Entry
/// i of degree n - 1 is sum_k weights[k] * entry (i + e_k) of degree n.
///
/// Cost: (s + 1) multiply-adds per entry of the result. Source: DeRose, section 5.1; Fernandez-Jambrina,
/// section 2. Statements: derose-tri-eval, fj-tri-blossom.
template <class R>
std::vector<R> fold(const NetShape& shape, std::size_t factor, std::span<const R> net,
                    const Tuple<R>& weights) {
    const std::size_t vertices = shape[factor].dimension + 1;
    const std::size_t count = shape.count(factor);
    const std::size_t behind = shape.behind(factor);
    const std::vector<std::size_t> raised =
        raised_positions(shape[factor].dimension, shape[factor].degree - 1);
    std::vector<R> folded;
    folded.reserve(shape.before(factor) * (raised.size() / vertices) * behind);
    for (std::size_t block = 0; block < net.size(); block += count * behind) {
        for (std::size_t i = 0; i < raised.size(); i += vertices) {
            for (std::size_t k = 0; k < behind; ++k) {
                R sum(0);
                for (std::size_t v = 0; v < vertices; ++v) {
                    accumulate_product(sum, weights[v], net[block + raised[i + v] * behind + k]);
                }
                folded.push_back(std::move(sum));
            }
        }
    }
    return folded;
}

/// The blossom by de Casteljau's algorithm with one argument of one factor per level; a factor of degree n
/// has n arguments.
///
/// Cost: for one simplex C(n + s, s + 1) entries of s + 1 multiply-adds; factors with many entries behind
/// them come last, when the net is small.
template <class R>
R folded_to_value(NetShape shape, std::vector<R> net, const TupleLists<R>& arguments) {
    for (std::size_t factor = shape.factors(); factor-- > 0;) {
        for (const Tuple<R>& argument : arguments[factor]) {
            net = fold<R>(shape, factor, net, argument);
            shape = shape.with_degree(factor, shape[factor].degree - 1);
        }
    }
    return std::move(net.front());
}

/// The coefficients of prod_j sum_k forms[j][k] X_k in the order of the multi-indices. Over (mass, x_1, ...,
/// x_s) of points they are the symmetric functions of points, over barycentric coordinates the weights of the
/// control points.
///
/// `power` holds the coefficients of the polynomial that is multiplied by the forms. Cost: (s + 1)
/// multiply-adds per multi-index of each degree on the way.
template <class R>
std::vector<R> times_linear_forms(std::size_t dimension, std::size_t degree, std::vector<R> power,
                                  std::span<const Tuple<R>> forms) {
    for (const Tuple<R>& form : forms) {
        const std::vector<std::size_t> raised = raised_positions(dimension, degree++);
        std::vector<R> product(raised.back() + 1, R(0));
        for (std::size_t i = 0; i < power.size(); ++i) {
            for (std::size_t k = 0; k <= dimension; ++k) {
                accumulate_product(product[raised[i * (dimension + 1) + k]], form[k], power[i]);
            }
        }
        power = std::move(product);
    }
    return power;
}

/// base^0, ..., base^n. A ring may overload this with a faster algorithm.
template <class R>
std::vector<R> powers(const R& base, std::size_t n) {
    std::vector<R> row(1, R(1));
    for (std::size_t k = 0; k < n; ++k) row.push_back(row.back() * base);
    return row;
}

/// prod_k x_k^(i_k) for every multi-index i of a degree. Cost: s multiplications per index, and n per
/// coordinate for its powers.
template <class R>
std::vector<R> monomials(const Tuple<R>& x, std::size_t degree) {
    std::vector<std::vector<R>> factors;
    for (const R& coordinate : x) factors.push_back(powers(coordinate, degree));
    std::vector<R> products;
    for (const MultiIndex& index : multi_indices(x.size() - 1, degree)) {
        R product = factors[0][index[0]];
        for (std::size_t k = 1; k < index.size(); ++k) {
            if (index[k] > 0) product = product * factors[k][index[k]];
        }
        products.push_back(std::move(product));
    }
    return products;
}

/// sum_k row[k] x^k y^(n-k) for each row. A ring may overload this with a faster algorithm.
template <class R>
std::vector<R> form_values(const std::vector<std::vector<R>>& rows, const R& x, const R& y) {
    std::vector<R> values;
    values.reserve(rows.size());
    for (const auto& row : rows) values.push_back(form_value(std::span<const R>(row), x, y));
    return values;
}

/// The sum of the entries of a net, each multiplied by the weight of its index in every factor. `weights` has
/// one list per factor. Cost: one multiply-add per entry, and fewer for the factors before the last.
template <class R>
R contracted(std::vector<R> net, std::span<const std::vector<R>> weights) {
    for (std::size_t factor = weights.size(); factor-- > 0;) {
        const std::span<const R> row(weights[factor]);
        std::vector<R> shorter;
        shorter.reserve(net.size() / row.size());
        for (std::size_t i = 0; i < net.size(); i += row.size()) {
            shorter.push_back(dot(std::span<const R>(net).subspan(i, row.size()), row));
        }
        net = std::move(shorter);
    }
    return std::move(net.front());
}

/// The sum over all sub-multisets S_f of the arguments of every factor f of prod_f (-1)^(n_f - |S_f|) times
/// form(sums, sizes), with one tuple per factor: the sum of S_f, zero for the empty set, and its size. If
/// `form` is a homogeneous polynomial, this is n_1! ... n_r! times its blossom, computed from values only:
/// the inverse formula applied in one factor after the other.
///
/// `form` gives one entry per coordinate, or none for zero. Cost: prod (m_i + 1) calls, m_i the
/// multiplicities. Source: Fernandez-Jambrina, theorem 1 and equation (21). Statements: fj-eq21,
/// fj-tensor-inverse.
template <class R, class Form>
std::vector<R> polarized(const NetShape& shape, const std::vector<Groups<Tuple<R>>>& factors,
                         const Form& form) {
    std::vector<Tuple<R>> sums(shape.factors());
    std::vector<std::size_t> sizes(shape.factors());
    const auto descend = [&](const auto& self, std::size_t factor) -> std::vector<R> {
        if (factor == factors.size()) return form(std::as_const(sums), std::as_const(sizes));
        const Tuple<R> zero(shape[factor].dimension + 1, R(0));
        const auto term = [&](const Tuple<R>& sum, std::size_t size) {
            sums[factor] = sum;
            sizes[factor] = size;
            return self(self, factor + 1);
        };
        return alternating_sum<R, Tuple<R>>(factors[factor], zero, 0, term);
    };
    return descend(descend, 0);
}

/// The levels of de Casteljau's pyramid in one factor with the same argument on each level: level r is the
/// net of degree n - r of the blossom with r arguments fixed.
///
/// Cost: C(n + s, s + 1) entries of s + 1 multiply-adds for one simplex.
template <class R>
std::vector<std::vector<R>> pyramid(NetShape shape, std::size_t factor, std::span<const R> net,
                                    const Tuple<R>& argument) {
    std::vector<std::vector<R>> levels{std::vector<R>(net.begin(), net.end())};
    while (shape[factor].degree > 0) {
        levels.push_back(fold<R>(shape, factor, levels.back(), argument));
        shape = shape.with_degree(factor, shape[factor].degree - 1);
    }
    return levels;
}

/// The net over the frame in which the argument of the pyramid replaces the element `vertex`: entry i is
/// entry i - i_vertex e_vertex of level i_vertex. If the argument was multiplied by `scale`, the result is
/// scale^n times the net.
///
/// Cost: one product per entry. Source: DeRose, section 5.2. Statement: derose-tri-subdiv.
template <class R>
std::vector<R> with_vertex_replaced(const NetShape& shape, std::size_t factor, std::size_t vertex,
                                    const std::vector<std::vector<R>>& levels, const Integer& scale = 1) {
    const auto [dimension, degree] = shape[factor];
    const std::size_t behind = shape.behind(factor);
    std::vector<R> powers{R(1)};
    for (std::size_t r = 0; r < degree; ++r) powers.push_back(powers.back() * R(scale));
    std::vector<MultiIndex> indices = multi_indices(dimension, degree);
    std::vector<R> net;
    net.reserve(shape.size());
    for (std::size_t block = 0; block < shape.before(factor); ++block) {
        for (const MultiIndex& index : indices) {
            const std::size_t r = index[vertex];
            MultiIndex lower = index;
            lower[vertex] = 0;
            const std::vector<R>& level = levels[r];
            const std::size_t count = level.size() / shape.before(factor);
            const std::size_t begin = block * count + position(lower) * behind;
            for (std::size_t k = begin; k < begin + behind; ++k) net.push_back(powers[degree - r] * level[k]);
        }
    }
    return net;
}

}  // namespace constructions

}  // namespace blossom
