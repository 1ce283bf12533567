#pragma once

#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

/// Recurrences in which every entry of a row becomes a combination of itself and one neighbour. They are
/// templates over any commutative ring; the overloads for integers run the same recurrences on words of fixed
/// width.

namespace blossom {

namespace row_recurrences {

/// A row over a ring R that is constructible from an int.
template <class R>
class RingRow {
public:
    explicit RingRow(std::vector<R> entries) : entries_(std::move(entries)) {}

    /// Sets the weights of the next level.
    void set_weights(const R& own, const R& neighbours) {
        own_ = &own;
        neighbours_ = &neighbours;
    }
    /// entry[k] = own * entry[k] + neighbours * entry[neighbour]
    void combine(std::size_t k, std::size_t neighbour) {
        entries_[k] = *own_ * entries_[k] + *neighbours_ * entries_[neighbour];
    }
    /// entry[k] = own * entry[k]
    void scale(std::size_t k) { entries_[k] = *own_ * entries_[k]; }

    std::vector<R>& entries() { return entries_; }

private:
    std::vector<R> entries_;
    const R* own_ = nullptr;
    const R* neighbours_ = nullptr;
};

/// For i = 0, 1, ...: multiplies the polynomial in entries 0..i by constants[i] + slopes[i] X.
template <class Row, class R>
void multiply_linear_factors(Row& row, std::span<const R> constants, std::span<const R> slopes) {
    for (std::size_t i = 0; i < constants.size(); ++i) {
        row.set_weights(constants[i], slopes[i]);
        for (std::size_t k = i + 1; k > 0; --k) row.combine(k, k - 1);
        row.scale(0);
    }
}

/// Folds entries 0..n to entry 0: on level i entry j becomes left[i] * entry[j] + right[i] * entry[j + 1].
template <class Row, class R>
void fold(Row& row, std::span<const R> left, std::span<const R> right) {
    const std::size_t n = left.size();
    for (std::size_t i = 0; i < n; ++i) {
        row.set_weights(left[i], right[i]);
        for (std::size_t j = 0; j + i < n; ++j) row.combine(j, j + 1);
    }
}

/// The triangle over entries 0..n whose levels all have these weights; edges(i) is called when the entries
/// 0..i are those of level n - i, for i from n down to 0.
template <class Row, class R>
void shrink(Row& row, std::size_t n, const R& left, const R& right, const auto& edges) {
    edges(n);
    for (std::size_t i = n; i-- > 0;) {
        row.set_weights(left, right);
        for (std::size_t j = 0; j <= i; ++j) row.combine(j, j + 1);
        edges(i);
    }
}

}  // namespace row_recurrences

/// The edges of a triangle over n + 1 entries: `left[i]` is the first entry of level i, `right[i]` the last
/// entry of level n - i.
struct TriangleEdges {
    std::vector<Integer> left;
    std::vector<Integer> right;
};

/// The edges of the triangle over `row` whose levels all map neighbours (x, y) to left x + right y: the
/// control points of the two parts of a subdivided curve.
///
/// Cost: n^2 / 2 multiply-adds, on words of the width that each level needs.
TriangleEdges triangle_edges(std::span<const Integer> row, const Integer& left, const Integer& right);

/// The coefficients of prod_i (constants[i] + slopes[i] X), lowest first, n + 1 of them for n factors.
/// With constants 1 they are the elementary symmetric functions of the slopes.
///
/// Cost: n^2 / 2 multiply-adds in R.
template <class R>
std::vector<R> product_of_linear_factors(std::span<const R> constants, std::span<const R> slopes) {
    std::vector<R> entries(constants.size() + 1, R(0));
    entries[0] = R(1);
    row_recurrences::RingRow<R> row(std::move(entries));
    row_recurrences::multiply_linear_factors(row, constants, slopes);
    return std::move(row.entries());
}

/// The apex of the triangle over `row` (n + 1 entries) whose level i maps neighbours (x, y) to left[i] x +
/// right[i] y. This is de Casteljau's algorithm with separate weights per level.
///
/// Cost: n^2 / 2 multiply-adds in R.
template <class R>
R fold_triangle(std::vector<R> row, std::span<const R> left, std::span<const R> right) {
    row_recurrences::RingRow<R> triangle(std::move(row));
    row_recurrences::fold(triangle, left, right);
    return std::move(triangle.entries().front());
}

/// The same for integers, on words of a width that provably holds every intermediate value:
/// |entry| <= prod(|constants[i]| + |slopes[i]|).
std::vector<Integer> product_of_linear_factors(std::span<const Integer> constants,
                                               std::span<const Integer> slopes);

/// The same for integers; |entry| <= max |row[j]| * prod(|left[i]| + |right[i]|).
Integer fold_triangle(std::vector<Integer> row, std::span<const Integer> left,
                      std::span<const Integer> right);

}  // namespace blossom
