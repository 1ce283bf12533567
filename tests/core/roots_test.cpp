#include <blossom/core/curve/roots.hpp>
#include "core_test.hpp"

#include "support/root_check.hpp"

namespace {

const Polynomial t = Polynomial::monomial(1);

/// A product of linear factors, of quadratic factors with two irrational roots, and of quadratic factors
/// without real roots.
struct Product {
    Polynomial polynomial = 1;
    std::set<Rational> rational_roots;

    void multiply(Random& random) {
        const std::size_t multiplicity = 1 + random.below(3);
        const Rational p = random.one_in(4) ? number(random, Size::any) : number(random, Size::small);
        const std::uint64_t kind = random.below(4);
        if (kind < 2) {
            rational_roots.insert(p);
            polynomial *= pow(t - Polynomial(p), multiplicity);
        } else {
            // (t - p)^2 - 2 r^2, whose roots p +- r sqrt(2) are irrational, or (t - p)^2 + 1.
            const Rational r = Rational(1 + random.below(9), 1 + random.below(9));
            const Polynomial square = (t - Polynomial(p)) * (t - Polynomial(p));
            polynomial *= pow(kind == 2 ? square - Polynomial(2 * r * r) : square + 1, multiplicity);
        }
    }
};

Product product(Random& random) {
    Product result;
    for (std::uint64_t factors = 1 + random.below(4); factors > 0; --factors) result.multiply(random);
    result.polynomial *= Polynomial(1 + abs(number(random, Size::small)));
    return result;
}

/// A random interval; in a third of the cases a rational root is an end.
Interval search_interval(Random& random, const Product& product) {
    const Interval over = random.one_in(3) ? Interval(-1000, 1000) : interval(random, Size::small);
    if (product.rational_roots.empty() || !random.one_in(3)) return over;
    const Rational root = *product.rational_roots.begin();
    if (root == over.a() || root == over.b()) return over;
    return random.one_in(2) ? Interval(root, over.b()) : Interval(over.a(), root);
}

}  // namespace

TEST_CASE("the roots of products of known factors are isolated with their multiplicities", "[roots]") {
    Random random(371);
    std::size_t at_ends = 0;
    for (std::size_t i = 0; i < 300; ++i) {
        const Product made = product(random);
        const Interval over = search_interval(random, made);
        CAPTURE(i, made.polynomial, over.a(), over.b());
        const std::vector<Root> found = roots(made.polynomial, over);
        check_isolation(made.polynomial, over, found);

        std::vector<Rational> recognised;
        for (const Root& root : found) {
            if (root.is_rational()) recognised.push_back(root.lower);
        }
        std::vector<Rational> expected;
        for (const Rational& root : made.rational_roots) {
            if (root >= std::min(over.a(), over.b()) && root <= std::max(over.a(), over.b()))
                expected.push_back(root);
        }
        CHECK(recognised == expected);
        if (made.polynomial(over.a()).is_zero() || made.polynomial(over.b()).is_zero()) ++at_ends;
        CHECK(roots(made.polynomial, {over.b(), over.a()}) == found);
    }
    CHECK(at_ends > 20);
}

TEST_CASE("roots are refined to the requested width", "[roots]") {
    Random random(372);
    for (std::size_t i = 0; i < 60; ++i) {
        const Product made = product(random);
        const Rational width(1, pow(Integer(10), 1 + 3 * random.below(10)));
        CAPTURE(i, made.polynomial, width);
        const std::vector<Root> found = roots(made.polynomial, {-20, 30}, width);
        check_isolation(made.polynomial, {-20, 30}, found);
        for (const Root& root : found) CHECK(root.upper - root.lower <= width);
    }
}

TEST_CASE("the square root of two is bracketed as closely as is wanted", "[roots]") {
    const Rational width(1, pow(Integer(10), 60));
    const std::vector<Root> found = roots(t * t - 2, {0, 2}, width);
    REQUIRE(found.size() == 1);
    CHECK(found[0].lower * found[0].lower < 2);
    CHECK(found[0].upper * found[0].upper > 2);
    CHECK(found[0].upper - found[0].lower <= width);
    CHECK(found[0].multiplicity == 1);
}

TEST_CASE("the ends of an interval are not roots of another factor", "[roots]") {
    const Polynomial polynomial = (t - 1) * pow(t * t - 2, 2);
    for (const Interval& over :
         {Interval(0, 2), Interval(1, 2), Interval(0, 3), Interval(1, Rational(3, 2))}) {
        check_isolation(polynomial, over, roots(polynomial, over));
    }
    const Polynomial close = pow(t - Polynomial(Rational(7, 5)), 3) * (t * t - 2) * pow(t * t * 25 - 49, 2);
    check_isolation(close, {-3, 3}, roots(close, {-3, 3}));
}

TEST_CASE("a squarefree decomposition multiplies back and consists of coprime squarefree factors",
          "[roots]") {
    Random random(373);
    for (std::size_t i = 0; i < 200; ++i) {
        const Polynomial polynomial = product(random).polynomial;
        CAPTURE(polynomial);
        Polynomial again(polynomial.leading_coefficient());
        std::size_t last = 0;
        const auto factors = squarefree_factors(polynomial);
        for (const auto& [factor, multiplicity] : factors) {
            CHECK(multiplicity > last);
            last = multiplicity;
            CHECK(factor.leading_coefficient() == 1);
            CHECK(factor.degree() > 0);
            CHECK(gcd(factor, derivative(factor)) == Polynomial(1));
            for (const auto& [other, power] : factors) {
                if (power != multiplicity) CHECK(gcd(factor, other) == Polynomial(1));
            }
            again *= pow(factor, multiplicity);
        }
        CHECK(again == polynomial);
    }
}

TEST_CASE("constants have no roots, and zero is refused", "[roots]") {
    CHECK(roots(Polynomial(5), {-3, 3}).empty());
    CHECK(squarefree_factors(Polynomial(Rational(-2, 3))).empty());
    CHECK(failure_code([] { roots(Polynomial(), {0, 1}); }) == ErrorCode::division_by_zero);
    CHECK(failure_code([] { squarefree_factors(Polynomial()); }) == ErrorCode::division_by_zero);
    CHECK(roots(t * t + 1, {-100, 100}).empty());
    CHECK(roots(t, {0, 1}) == std::vector<Root>{{0, 0, 1}});
    CHECK(roots(t, {1, 0}) == std::vector<Root>{{0, 0, 1}});
    CHECK(roots(t, {-1, 0}) == std::vector<Root>{{0, 0, 1}});
    CHECK(roots(t, {1, 2}).empty());
    CHECK(roots(pow(t, 7) * pow(t - 1, 2), {0, 1}) == std::vector<Root>{{0, 0, 7}, {1, 1, 2}});
}

TEST_CASE("an unbounded range has all roots of its side, and a bound exceeds them", "[roots]") {
    const Polynomial polynomial = (t * t - 2) * (t + 100) * (t - Rational(1, 1000));
    CHECK(roots(polynomial, {}).size() == 4);
    CHECK(roots(polynomial, {0, std::nullopt}).size() == 2);
    CHECK(roots(polynomial, {std::nullopt, 0}).size() == 2);
    CHECK(roots(polynomial, {1000, std::nullopt}).empty());
    CHECK(roots(polynomial, {std::nullopt, -1000}).empty());
    CHECK(root_bound(polynomial) > 100);
    CHECK(root_bound(polynomial) <= 512);
    CHECK(root_bound(pow(t, 7)) == Rational(1));
    CHECK(root_bound(t - Rational(1, 1000)) <= Rational(1, 128));
    CHECK(failure_code([] { root_bound(Polynomial()); }) == ErrorCode::division_by_zero);
}

TEST_CASE("a root can be narrowed to any width", "[roots]") {
    const Root root = roots(pow(t * t - 2, 3) * (t - 1), {0, 2}).back();
    const Rational width(1, Integer(1) << 300);
    const Root narrow = narrowed(root, width);
    CHECK(narrow.upper - narrow.lower <= width);
    CHECK(narrow.lower * narrow.lower < 2);
    CHECK(narrow.upper * narrow.upper > 2);
    CHECK(narrow.multiplicity == 3);
    CHECK(narrowed(root, 5) == root);
}
