#include <blossom/rational/integer_polynomials.hpp>

#include <algorithm>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace blossom;
using blossom::testing::Random;

namespace {

IntegerPolynomial plain_product(const IntegerPolynomial& a, const IntegerPolynomial& b) {
    IntegerPolynomial result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
    }
    return result;
}

/// A polynomial of this degree, with coefficients of up to `bits` bits and a nonzero leading coefficient.
IntegerPolynomial random_polynomial(Random& random, std::size_t degree, std::size_t bits) {
    IntegerPolynomial polynomial;
    for (std::size_t k = 0; k <= degree; ++k) {
        Integer value = random.between(-3, 3);
        for (std::size_t i = 8; i < bits; i += 8) value = (value << 8) + Integer(random.between(-100, 100));
        polynomial.push_back(std::move(value));
    }
    if (polynomial.back().is_zero()) polynomial.back() = random.between(1, 5);
    return polynomial;
}

IntegerPolynomial linear(const Rational& root) { return {-root.numerator(), root.denominator()}; }

Rational value(const IntegerPolynomial& polynomial, const Rational& t) {
    Rational sum;
    for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * t + Rational(polynomial[k]);
    return sum;
}

}  // namespace

TEST_CASE("a product of integer polynomials keeps leading zeros") {
    CHECK(product(IntegerPolynomial{}, IntegerPolynomial{1, 2}) == IntegerPolynomial{});
    CHECK(product(IntegerPolynomial{1, 2}, IntegerPolynomial{3, -1}) == IntegerPolynomial{3, 5, -2});
    Random random(8);
    for (const std::size_t size : {1U, 63U, 64U, 65U, 100U}) {
        IntegerPolynomial a = random_polynomial(random, size - 1, 8 * (1 + random.below(20)));
        IntegerPolynomial b = random_polynomial(random, 70, 8 * (1 + random.below(20)));
        CHECK(product(a, b) == plain_product(a, b));
        a.back() = 0;
        CHECK(product(a, b) == plain_product(a, b));
        CHECK(product(a, IntegerPolynomial(80)) == IntegerPolynomial(size + 79));
    }
}

TEST_CASE("a quotient of integer polynomials exists exactly where the product says so") {
    Random random(1);
    for (int round = 0; round < 300; ++round) {
        const IntegerPolynomial a = random_polynomial(random, random.below(6), 8 * (1 + random.below(20)));
        const IntegerPolynomial b = random_polynomial(random, random.below(6), 8 * (1 + random.below(20)));
        IntegerPolynomial whole = plain_product(a, b);
        CHECK(exact_quotient(whole, b) == a);
        if (b.size() < 2) continue;
        whole[random.below(b.size() - 1)] += Integer(1);
        CHECK_FALSE(exact_quotient(whole, b));
    }
    CHECK_FALSE(exact_quotient(IntegerPolynomial{1, 1}, IntegerPolynomial{1, 2}));
    CHECK_FALSE(exact_quotient(IntegerPolynomial{1}, IntegerPolynomial{1, 2}));
    CHECK(exact_quotient(IntegerPolynomial{}, IntegerPolynomial{1, 2}) == IntegerPolynomial{});
}

TEST_CASE("the greatest common divisor divides both and takes their common factor") {
    Random random(2);
    for (int round = 0; round < 200; ++round) {
        const std::size_t bits = 8 * (1 + random.below(40));
        const IntegerPolynomial common = random_polynomial(random, random.below(7), bits);
        const IntegerPolynomial a = random_polynomial(random, random.below(7), bits);
        const IntegerPolynomial b = random_polynomial(random, random.below(7), bits);
        const IntegerPolynomial found = primitive_gcd(plain_product(a, common), plain_product(b, common));
        const auto rest_a = exact_quotient(plain_product(a, common), found);
        const auto rest_b = exact_quotient(plain_product(b, common), found);
        REQUIRE(rest_a);
        REQUIRE(rest_b);
        CHECK(primitive_gcd(*rest_a, *rest_b) == IntegerPolynomial{1});
        Integer content;
        for (const Integer& coefficient : found) content = gcd(content, coefficient);
        CHECK(content == Integer(1));
        CHECK(found.back().sign() > 0);
        CHECK(found.size() >= common.size());
    }
    CHECK(primitive_gcd(IntegerPolynomial{6, 6}, IntegerPolynomial{-4, 0, 4}) == IntegerPolynomial{1, 1});
    CHECK(primitive_gcd(IntegerPolynomial{6}, IntegerPolynomial{4}) == IntegerPolynomial{1});
}

TEST_CASE("the rational roots of a squarefree polynomial are found, and no others") {
    Random random(3);
    const IntegerPolynomial without_any[] = {{1}, {1, 0, 1}, {-2, 0, 1}, {-2, 0, 0, 3}, {-7, 1, 0, 0, 0, 5}};
    for (int round = 0; round < 200; ++round) {
        std::vector<Rational> expected;
        IntegerPolynomial polynomial = without_any[random.below(5)];
        const std::size_t count = random.below(12);
        const std::int64_t most = random.one_in(2) ? 12 : 1'000'000'000'000;
        while (expected.size() < count) {
            const Rational root(random.between(-most, most), random.between(1, most));
            if (std::ranges::find(expected, root) != expected.end()) continue;
            expected.push_back(root);
            polynomial = plain_product(polynomial, linear(root));
        }
        std::vector<Rational> found = rational_roots(polynomial);
        std::ranges::sort(found);
        std::ranges::sort(expected);
        CHECK(found == expected);
    }
}

TEST_CASE("rational roots that are equal modulo the first prime, or beyond it, are found") {
    const std::int64_t prime = 4001;
    const std::vector<Rational> expected = {Rational(-prime), Rational(0),         Rational(1, 3),
                                            Rational(5),      Rational(5 + prime), Rational(5 + 2 * prime)};
    IntegerPolynomial polynomial = {-2, 0, 1};
    for (const Rational& root : expected) polynomial = plain_product(polynomial, linear(root));
    std::vector<Rational> found = rational_roots(polynomial);
    std::ranges::sort(found);
    CHECK(found == expected);
    // A leading coefficient that the prime divides.
    CHECK(rational_roots(linear(Rational(2, prime))) == std::vector<Rational>{Rational(2, prime)});
    // Roots modulo every prime, none of them rational.
    const IntegerPolynomial product_of_squares =
        plain_product(plain_product({-2, 0, 1}, {-3, 0, 1}), {-6, 0, 1});
    CHECK(rational_roots(product_of_squares).empty());
    CHECK(value(polynomial, Rational(1, 3)).is_zero());
}

namespace {

using Row = std::vector<IntegerPolynomial>;

/// The determinant by expansion along the first row; zero polynomials have no coefficients.
IntegerPolynomial determinant(const std::vector<Row>& matrix) {
    if (matrix.empty()) return {1};
    IntegerPolynomial sum;
    for (std::size_t j = 0; j < matrix.size(); ++j) {
        if (matrix[0][j].empty()) continue;
        std::vector<Row> minor(matrix.begin() + 1, matrix.end());
        for (Row& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
        const IntegerPolynomial below = determinant(minor);
        if (below.empty()) continue;
        const IntegerPolynomial term = plain_product(matrix[0][j], below);
        sum.resize(std::max(sum.size(), term.size()));
        for (std::size_t k = 0; k < term.size(); ++k) sum[k] += j % 2 == 0 ? term[k] : -term[k];
    }
    while (!sum.empty() && sum.back().is_zero()) sum.pop_back();
    return sum;
}

/// Sylvester's matrix with the highest powers of t first.
std::vector<Row> sylvester(const Row& f, const Row& g) {
    const std::size_t m = f.size() - 1;
    const std::size_t n = g.size() - 1;
    std::vector<Row> matrix(m + n, Row(m + n));
    for (std::size_t i = 0; i < n; ++i)
        std::reverse_copy(f.begin(), f.end(), matrix[i].begin() + static_cast<std::ptrdiff_t>(i));
    for (std::size_t i = 0; i < m; ++i)
        std::reverse_copy(g.begin(), g.end(), matrix[n + i].begin() + static_cast<std::ptrdiff_t>(i));
    return matrix;
}

Row random_rows(Random& random, std::size_t degree) {
    Row rows;
    for (std::size_t k = 0; k <= degree; ++k) {
        const bool is_zero = k < degree && random.one_in(4);
        rows.push_back(is_zero ? IntegerPolynomial()
                               : random_polynomial(random, random.below(3), random.one_in(5) ? 80 : 8));
    }
    return rows;
}

}  // namespace

TEST_CASE("a resultant is the determinant of Sylvester's matrix") {
    CHECK(resultant(Row{{0, -1}, {1}}, Row{{-2}, {}, {1}}) == IntegerPolynomial{-2, 0, 1});
    CHECK(resultant(Row{{5}}, Row{{7}}) == IntegerPolynomial{1});
    CHECK(resultant(Row{}, Row{{7}}).empty());
    Random random(41);
    for (int i = 0; i < 150; ++i) {
        CAPTURE(i);
        const Row f = random_rows(random, random.below(4));
        Row g = random_rows(random, random.below(4));
        if (random.one_in(6)) g = f;  // a common factor
        CHECK(resultant(f, g) == determinant(sylvester(f, g)));
    }
}
