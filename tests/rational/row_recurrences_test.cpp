#include <blossom/rational/row_recurrences.hpp>
#include "rational_test.hpp"

// The integer overloads choose a width that must hold every intermediate value. At the limits of each width,
// they are compared with the template on Integer, which has no width.

namespace {

struct Weights {
    std::vector<Integer> own;
    std::vector<Integer> neighbours;

    /// The bits of prod(|own| + |neighbours|), which the results approach if no signs cancel.
    std::size_t bits() const {
        Integer product = 1;
        for (std::size_t i = 0; i < own.size(); ++i) product *= abs(own[i]) + abs(neighbours[i]);
        return product.bit_length();
    }
};

void check_product(const Weights& weights) {
    CHECK(product_of_linear_factors(weights.own, weights.neighbours) ==
          product_of_linear_factors<Integer>(weights.own, weights.neighbours));
}

void check_fold(const std::vector<Integer>& row, const Weights& weights) {
    CHECK(fold_triangle(row, weights.own, weights.neighbours) ==
          fold_triangle<Integer>(row, weights.own, weights.neighbours));
}

/// The edges by computing every level.
TriangleEdges edges_by_levels(std::vector<Integer> level, const Integer& left, const Integer& right) {
    TriangleEdges edges;
    std::vector<Integer> last;
    for (;;) {
        edges.left.push_back(level.front());
        last.push_back(level.back());
        if (level.size() == 1) break;
        std::vector<Integer> next;
        for (std::size_t j = 0; j + 1 < level.size(); ++j)
            next.push_back(left * level[j] + right * level[j + 1]);
        level = next;
    }
    edges.right.assign(last.rbegin(), last.rend());
    return edges;
}

void check_edges(const std::vector<Integer>& row, const Integer& left, const Integer& right) {
    const TriangleEdges expected = edges_by_levels(row, left, right);
    const TriangleEdges edges = triangle_edges(row, left, right);
    CHECK(edges.left == expected.left);
    CHECK(edges.right == expected.right);
}

/// A weight of at most `bits` bits; sometimes zero or the extreme value of this width.
Integer weight(Random& random, std::size_t bits) {
    if (random.one_in(12)) return 0;
    if (random.one_in(12)) return (Integer(1) << bits) - 1;
    if (random.one_in(12)) return -(Integer(1) << bits) + 1;
    return integer_of_bits(random, random.below(bits + 1));
}

/// Weights of n levels whose bound has about `bits` bits; in half of the cases all have the same sign.
Weights weights_of_bits(Random& random, std::size_t n, std::size_t bits) {
    Weights weights;
    const bool one_sign = random.one_in(2);
    const std::size_t share = std::min<std::size_t>(62, bits / n);
    for (std::size_t i = 0; i < n; ++i) {
        Integer own = weight(random, share);
        Integer neighbour = weight(random, share);
        weights.own.push_back(one_sign ? abs(own) : own);
        weights.neighbours.push_back(one_sign ? abs(neighbour) : neighbour);
    }
    return weights;
}

std::vector<Integer> row_of_bits(Random& random, std::size_t size, std::size_t bits) {
    std::vector<Integer> row;
    for (std::size_t i = 0; i < size; ++i) row.push_back(integer_of_bits(random, random.below(bits + 1)));
    return row;
}

}  // namespace

TEST_CASE("recurrences of any width on random weights", "[row_recurrences]") {
    Random random(81);
    for (int i = 0; i < 12'000; ++i) {
        const std::size_t n = 1 + random.below(9);
        const Weights weights = weights_of_bits(random, n, random.below(300));
        check_product(weights);
        check_fold(row_of_bits(random, n + 1, random.below(200)), weights);
    }
}

TEST_CASE("recurrences whose bound has 62 to 66 or 126 to 130 bits", "[row_recurrences]") {
    Random random(82);
    std::map<std::size_t, int> seen_products;
    std::map<std::size_t, int> seen_folds;
    for (int i = 0; i < 20'000; ++i) {
        const std::size_t target = (random.one_in(2) ? 61 : 125) + random.below(7);
        const std::size_t n = 1 + random.below(6);
        Weights weights = weights_of_bits(random, n, random.below(target));
        // The last level, then the row, fill up the bits to the target.
        weights.own.back() = 0;
        weights.neighbours.back() = 1;
        const std::size_t missing = target - std::min(target, weights.bits());
        weights.own.back() = integer_of_bits(random, std::min<std::size_t>(missing, 62));
        const std::size_t bits = weights.bits();
        ++seen_products[bits];
        check_product(weights);
        if (bits > target) continue;
        const std::size_t entry_bits = target - bits;
        std::vector<Integer> row = row_of_bits(random, n + 1, entry_bits);
        row[random.below(n + 1)] = integer_of_bits(random, entry_bits);
        ++seen_folds[bits + entry_bits];
        check_fold(row, weights);
    }
    for (const std::size_t bits : {62U, 63U, 64U, 65U, 66U, 126U, 127U, 128U, 129U, 130U}) {
        CAPTURE(bits);
        CHECK(seen_products[bits] > 50);
        CHECK(seen_folds[bits] > 200);
    }
}

TEST_CASE("results that reach their bound exactly", "[row_recurrences]") {
    // Weights (x, x) or (x, -x) on a row of one magnitude: the bound 2^n x^n |entry| is attained.
    for (std::size_t n = 1; n <= 5; ++n) {
        for (std::size_t bits = 1; bits <= 63; ++bits) {
            for (const Integer& x : {Integer(1) << (bits - 1), (Integer(1) << bits) - 1}) {
                for (std::size_t entry_bits = 1; entry_bits <= 70; entry_bits += 3) {
                    const Integer entry = (Integer(1) << entry_bits) - 1;
                    std::vector<Integer> row(n + 1, entry);
                    Weights same{std::vector<Integer>(n, x), std::vector<Integer>(n, x)};
                    const Integer expected = pow(x * 2, n) * entry;
                    CHECK(fold_triangle(row, same.own, same.neighbours) == expected);
                    for (Integer& own : same.own) own.negate();
                    for (std::size_t k = 1; k <= n; k += 2) row[k].negate();
                    CHECK(abs(fold_triangle(row, same.own, same.neighbours)) == expected);
                }
                const std::vector<Integer> slopes(n, x);
                CHECK(product_of_linear_factors(slopes, slopes)[n / 2] == pow(x, n) * binomial(n, n / 2));
            }
        }
    }
}

TEST_CASE("the least and the greatest word as weights", "[row_recurrences]") {
    Random random(83);
    const std::vector<Integer> extremes{INT64_MIN, INT64_MIN + 1, INT64_MAX, -1, 0, 1, Integer(1) << 62};
    for (int i = 0; i < 6000; ++i) {
        const std::size_t n = 1 + random.below(7);
        Weights weights;
        for (std::size_t k = 0; k < n; ++k) {
            weights.own.push_back(extremes[random.below(extremes.size())]);
            weights.neighbours.push_back(extremes[random.below(extremes.size())]);
        }
        check_product(weights);
        check_fold(row_of_bits(random, n + 1, random.below(150)), weights);
        std::vector<Integer> row;
        for (std::size_t k = 0; k <= n; ++k) row.push_back(extremes[random.below(extremes.size())]);
        check_fold(row, weights);
    }
}

TEST_CASE("weights just beyond a word take the generic path", "[row_recurrences]") {
    Random random(84);
    const std::vector<Integer> beyond{Integer(INT64_MAX) + 1, Integer(INT64_MIN) - 1, Integer(1) << 64,
                                      -(Integer(1) << 100)};
    for (int i = 0; i < 3000; ++i) {
        const std::size_t n = 1 + random.below(6);
        Weights weights = weights_of_bits(random, n, 40 * n);
        auto& changed = random.one_in(2) ? weights.own : weights.neighbours;
        changed[random.below(n)] = beyond[random.below(beyond.size())];
        check_product(weights);
        check_fold(row_of_bits(random, n + 1, random.below(150)), weights);
    }
}

TEST_CASE("many limbs, negative weights and entries of many sizes", "[row_recurrences]") {
    Random random(85);
    for (int i = 0; i < 300; ++i) {
        const std::size_t n = 20 + random.below(30);
        const Weights weights = weights_of_bits(random, n, n * (1 + random.below(62)));
        check_product(weights);
        check_fold(row_of_bits(random, n + 1, random.below(700)), weights);
    }
}

TEST_CASE("recurrences without levels", "[row_recurrences]") {
    CHECK(product_of_linear_factors({}, {}) == std::vector<Integer>{1});
    for (const Integer& entry :
         {Integer(0), Integer(INT64_MIN), Integer(INT64_MAX), -(Integer(1) << 127), Integer(1) << 500}) {
        CHECK(fold_triangle({entry}, {}, {}) == entry);
    }
}

TEST_CASE("with constants 1 the product holds the elementary symmetric functions", "[row_recurrences]") {
    const std::vector<Integer> ones(4, 1);
    const std::vector<Integer> slopes{2, -3, 5, 7};
    CHECK(product_of_linear_factors(ones, slopes) == std::vector<Integer>{1, 11, 17, -107, -210});
}

TEST_CASE("the edges of a triangle agree with its levels, for weights of words and beyond") {
    Random random(20261129);
    for (int i = 0; i < 400; ++i) {
        const std::size_t bits = random.one_in(8) ? 70 : 1 + random.below(63);
        const auto row = row_of_bits(random, 1 + random.below(12), random.below(260));
        check_edges(row, weight(random, bits), weight(random, bits));
    }
    const Integer least = std::numeric_limits<std::int64_t>::min();
    check_edges({1, -1, 3}, least, 1);
    check_edges({1, -1, 3}, 1, least);
    check_edges({least, least, least}, -1, -1);
    check_edges({7}, 2, 3);
}
