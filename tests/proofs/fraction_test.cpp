#include <blossom/proofs/fraction.hpp>
#include <blossom/rational/error.hpp>

#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace blossom;
using namespace blossom::proofs;
using blossom::testing::Random;

namespace {

SparsePolynomial random_polynomial(Random& random) {
    std::vector<SparsePolynomial> terms;
    for (std::size_t i = random.below(4); i > 0; --i) {
        const std::size_t exponents[] = {random.below(3), random.below(2), random.below(2)};
        terms.push_back(SparsePolynomial::term(
            Rational(Integer(random.between(-3, 3)), Integer(random.between(1, 3))), exponents));
    }
    return sum(terms);
}

Fraction random_fraction(FractionField& field, Random& random) {
    SparsePolynomial divisor = random_polynomial(random);
    if (divisor.is_zero()) divisor = 1;
    return field.quotient({random_polynomial(random), {}}, {divisor, {}});
}

Fraction sum_of(FractionField& field, const Fraction& a, const Fraction& b) {
    const Fraction both[] = {a, b};
    return field.sum(both);
}

}  // namespace

TEST_CASE("rational functions are a field, and zero has one form") {
    Random random(31);
    std::size_t proper = 0;
    for (int i = 0; i < 300; ++i) {
        FractionField field{Limits{}};
        const Fraction a = random_fraction(field, random);
        const Fraction b = random_fraction(field, random);
        const Fraction c = random_fraction(field, random);
        if (!a.denominator.empty()) ++proper;
        CHECK(field.equal(sum_of(field, a, b), sum_of(field, b, a)));
        CHECK(field.equal(sum_of(field, sum_of(field, a, b), c), sum_of(field, a, sum_of(field, b, c))));
        CHECK(field.equal(field.product(a, b), field.product(b, a)));
        CHECK(field.equal(field.product(field.product(a, b), c), field.product(a, field.product(b, c))));
        CHECK(field.equal(field.product(a, sum_of(field, b, c)),
                          sum_of(field, field.product(a, b), field.product(a, c))));
        const Fraction zero = field.difference(a, a);
        CHECK(zero.numerator == SparsePolynomial());
        CHECK(zero.denominator.empty());
        if (!b.is_zero()) CHECK(field.equal(field.product(field.quotient(a, b), b), a));
        CHECK(field.equal(field.power(a, 3), field.product(a, field.product(a, a))));
        CHECK(field.equal(field.reduced(a), a));
    }
    CHECK(proper > 100);
}

TEST_CASE("denominators are products of factors") {
    FractionField field{Limits{}};
    const auto x = SparsePolynomial::variable(0);
    const auto y = SparsePolynomial::variable(1);
    const auto factors_of = [&](const SparsePolynomial& polynomial) {
        SparsePolynomial product = 1;
        std::size_t count = 0;
        const auto [unit, factors] = field.factorise(polynomial);
        for (const auto& [factor, exponent] : factors) {
            product *= pow(field.factors()[factor], exponent);
            count += exponent;
        }
        CHECK(product * SparsePolynomial(unit) == polynomial);
        return count;
    };
    CHECK(factors_of(x * x * y) == 3);
    CHECK(factors_of((x - y) * (x - y) * (y - x)) == 3);
    CHECK(factors_of(SparsePolynomial(6) * (x + y) * (x + y)) == 2);
    CHECK(factors_of(x * x + y * y) == 1);
    CHECK(factors_of(SparsePolynomial(-5)) == 0);
}

TEST_CASE("work and terms are counted against their limits") {
    Limits limits;
    limits.expansion_terms = 50;
    FractionField field(limits);
    Fraction x{SparsePolynomial::variable(0) + SparsePolynomial::variable(1) + SparsePolynomial(1), {}};
    CHECK_NOTHROW(field.power(x, 5));
    CHECK_THROWS_AS(field.power(x, 20), Error);
    limits = {};
    limits.expansion_work = 1000;
    FractionField exhausted(limits);
    CHECK_THROWS_AS(exhausted.power(x, 20), Error);
    CHECK_THROWS_AS(exhausted.quotient(x, {}), Error);
}

TEST_CASE("a sum has no factor left in numerator and denominator") {
    FractionField field{Limits{}};
    const auto x = [](std::size_t i) { return SparsePolynomial::variable(i); };
    const auto f = [&](const SparsePolynomial& a, const SparsePolynomial& b) {
        return field.quotient({a, {}}, {b, {}});
    };
    // 1/((x-y)(x-z)) + 1/((y-x)(y-z)) + 1/((z-x)(z-y)) = 0, and two of them are 1/((x-z)(z-y)).
    const Fraction a = f(1, (x(0) - x(1)) * (x(0) - x(2)));
    const Fraction b = f(1, (x(1) - x(0)) * (x(1) - x(2)));
    const Fraction c = f(1, (x(2) - x(0)) * (x(2) - x(1)));
    const Fraction two = sum_of(field, a, b);
    CHECK(two.denominator.size() == 2);
    CHECK(two.numerator.variables() == 0);
    CHECK(sum_of(field, two, c).is_zero());
    // Over one denominator, and where a factor occurs twice in one of them.
    CHECK(sum_of(field, f(x(0), x(0) - x(1)), f(-x(1), x(0) - x(1))).denominator.empty());
    const Fraction square = sum_of(field, f(1, (x(0) - x(1)) * (x(0) - x(1))), f(1, x(0) - x(1)));
    CHECK(square.denominator == Factors{{field.factorise(x(0) - x(1)).factors[0].first, 2}});
    CHECK(field.product(square, f(x(0) - x(1), 1)).denominator.front().second == 1);
}
