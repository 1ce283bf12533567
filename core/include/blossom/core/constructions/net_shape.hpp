#pragma once

#include <blossom/rational/integer.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/net_sums.hpp>

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// Exponents (i_0, ..., i_s) for the vertices of a simplex of dimension s; their sum is the degree.
using MultiIndex = std::vector<std::size_t>;

/// C(degree + dimension, dimension), the number of multi-indices of a simplex.
/// Errors: `limit_exceeded` if it is greater than `limits.numbers`.
std::size_t multi_index_count(std::size_t dimension, std::size_t degree, const Limits& limits = {});

/// All multi-indices in descending lexicographic order: (n, 0, ..., 0), (n-1, 1, 0, ..., 0), ..., (0, ..., 0,
/// n). For a segment this is the order of the control points of a curve.
std::vector<MultiIndex> multi_indices(std::size_t dimension, std::size_t degree);

/// The position of an index in this order. Cost: O(s^2).
std::size_t position(std::span<const std::size_t> index);

/// n! / (i_0! ... i_s!).
Integer multinomial(std::span<const std::size_t> index);

/// The shape of a control net over a product of simplices, with one multi-index per factor.
///
/// A curve is one segment, a triangular patch one triangle, a tensor-product patch several segments, a prism
/// a triangle and a segment. The index of the last factor changes fastest in the sequence of points, and the
/// indices of one factor are in descending lexicographic order.
class NetShape {
public:
    /// Errors: `limit_exceeded` if a degree is greater than `limits.degree` or the net would have more than
    /// `limits.numbers` points.
    explicit NetShape(std::vector<SimplexFactor> factors, const Limits& limits = {});
    /// One simplex.
    static NetShape simplex(Count dimension, Count degree, const Limits& limits = {});
    /// One segment of any degree: the shape of a curve.
    static NetShape segment(Count degree) {
        return NetShape({{1, degree}}, {.degree = degree, .numbers = degree + 1});
    }
    /// One segment per degree.
    static NetShape tensor(std::span<const std::size_t> degrees, const Limits& limits = {});

    std::size_t factors() const { return factors_.size(); }
    /// Errors: `outside_domain` unless factor < factors().
    const SimplexFactor& operator[](std::size_t factor) const {
        require_index(factor, factors_.size());
        return factors_[factor];
    }
    const std::vector<SimplexFactor>& list() const { return factors_; }
    /// The number of points of the net.
    std::size_t size() const { return size_; }
    /// The number of indices of one factor.
    std::size_t count(std::size_t factor) const { return counts_[factor]; }
    /// The product of the counts of all factors before this one, and of those behind it.
    std::size_t before(std::size_t factor) const;
    std::size_t behind(std::size_t factor) const;
    /// The sum of the dimensions.
    std::size_t dimension() const;

    /// The same shape with another degree in one factor, without limits unless they are given. Errors:
    /// `limit_exceeded`.
    NetShape with_degree(std::size_t factor, std::size_t degree,
                         const Limits& limits = {.degree = any, .numbers = any}) const;
    /// The position in the net of the point with one multi-index per factor.
    std::size_t position_of(std::span<const MultiIndex> indices) const;

    friend bool operator==(const NetShape&, const NetShape&) = default;
    /// "degree 1 on a simplex of dimension 2, degree 3 on a simplex of dimension 1".
    friend std::string to_string(const NetShape& shape);
    friend std::size_t hash_value(const NetShape& shape) { return hash_of(shape.factors_); }

private:
    static constexpr std::size_t any = std::numeric_limits<std::size_t>::max();

    std::vector<SimplexFactor> factors_;
    std::vector<std::size_t> counts_;
    std::size_t size_ = 1;
};

/// For every point of a net, in order, one multi-index per factor.
std::vector<std::vector<MultiIndex>> net_indices(const NetShape& shape);

/// For every point of a net, the product of the multinomial coefficients of its indices.
std::vector<Integer> multinomials(const NetShape& shape);

/// For every index of degree n - 1 in dimension s, the positions of the s + 1 indices of degree n above it:
/// index + e_0, ..., index + e_s.
std::vector<std::size_t> raised_positions(std::size_t dimension, std::size_t lower_degree);

}  // namespace blossom
