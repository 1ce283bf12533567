#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/row_recurrences.hpp>

#include <limits>
#include <optional>

#include "fixed_width_rows.hpp"

namespace blossom {

namespace {

using fixed_width::BitBound;
using fixed_width::LimbRow;

/// The weights of all levels as words.
struct WordWeights {
    std::vector<std::int64_t> own;
    std::vector<std::int64_t> neighbours;

    std::size_t final_bits(std::size_t start_bits) const {
        BitBound bound(start_bits);
        for (std::size_t i = 0; i < own.size(); ++i)
            bound.multiply(UInt128{magnitude(own[i])} + magnitude(neighbours[i]));
        return bound.bits();
    }
    std::vector<WordFactor> factors() const {
        std::vector<WordFactor> factors;
        factors.reserve(own.size());
        for (std::size_t i = 0; i < own.size(); ++i) factors.push_back({own[i], neighbours[i], 1});
        return factors;
    }
};

/// The values as words, if all their magnitudes are below 2^63.
std::optional<std::vector<std::int64_t>> as_words(std::span<const Integer> values) {
    std::vector<std::int64_t> words;
    words.reserve(values.size());
    for (const Integer& value : values) {
        const auto word = value.to_int64();
        if (!word || *word == std::numeric_limits<std::int64_t>::min()) return std::nullopt;
        words.push_back(*word);
    }
    return words;
}

std::optional<WordWeights> word_weights(std::span<const Integer> own, std::span<const Integer> neighbours) {
    auto first = as_words(own);
    if (!first) return std::nullopt;
    auto second = as_words(neighbours);
    if (!second) return std::nullopt;
    return WordWeights{std::move(*first), std::move(*second)};
}

template <class Row, class R, class Entry>
TriangleEdges edges_of(Row& row, std::size_t n, const R& left, const R& right, const Entry& entry) {
    TriangleEdges edges;
    edges.left.reserve(n + 1);
    edges.right.resize(n + 1);
    row_recurrences::shrink(row, n, left, right, [&](std::size_t i) {
        edges.left.push_back(entry(0));
        edges.right[i] = entry(i);
    });
    return edges;
}

}  // namespace

TriangleEdges triangle_edges(std::span<const Integer> entries, const Integer& left, const Integer& right) {
    const std::size_t n = entries.size() - 1;
    const Integer weights[] = {left, right};
    const auto words = as_words(weights);
    if (!words) {
        row_recurrences::RingRow<Integer> row({entries.begin(), entries.end()});
        return edges_of(row, n, left, right, [&](std::size_t k) { return row.entries()[k]; });
    }
    const std::size_t start_bits = greatest_bit_length(entries);
    BitBound bound(start_bits);
    for (std::size_t i = 0; i < n; ++i)
        bound.multiply(UInt128{magnitude((*words)[0])} + magnitude((*words)[1]));
    LimbRow row(n + 1, start_bits, bound.bits());
    for (std::size_t k = 0; k <= n; ++k) row.set(k, entries[k]);
    return edges_of(row, n, (*words)[0], (*words)[1], [&](std::size_t k) { return row.integer(k); });
}

std::vector<Integer> product_of_linear_factors(std::span<const Integer> constants,
                                               std::span<const Integer> slopes) {
    const auto weights = word_weights(constants, slopes);
    if (!weights) return product_of_linear_factors<Integer>(constants, slopes);

    const std::size_t size = constants.size() + 1;
    LimbRow row(size, 1, weights->final_bits(1));
    row.set(0, 1);
    row.multiply_out(weights->factors());
    std::vector<Integer> coefficients;
    coefficients.reserve(size);
    for (std::size_t k = 0; k < size; ++k) coefficients.push_back(row.integer(k));
    return coefficients;
}

Integer fold_triangle(std::vector<Integer> entries, std::span<const Integer> left,
                      std::span<const Integer> right) {
    const auto weights = word_weights(left, right);
    if (!weights) return fold_triangle<Integer>(std::move(entries), left, right);

    const std::size_t start_bits = greatest_bit_length(entries);
    LimbRow row(entries.size(), start_bits, weights->final_bits(start_bits));
    for (std::size_t k = 0; k < entries.size(); ++k) row.set(k, entries[k]);
    row_recurrences::fold(row, std::span(weights->own), std::span(weights->neighbours));
    return row.integer(0);
}

}  // namespace blossom
