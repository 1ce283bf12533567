#include "rational_test.hpp"

namespace {

std::vector<Rational> rationals(Random& random) {
    std::vector<Rational> values;
    for (std::uint64_t i = random.below(7); i > 0; --i) values.push_back(rational(random));
    return values;
}

}  // namespace

TEST_CASE("a vector of rational numbers keeps its elements", "[rational_vector]") {
    Random random(51);
    for (int i = 0; i < 1500; ++i) {
        const std::vector<Rational> values = rationals(random);
        RationalVector vector(values);
        CHECK(vector.size() == values.size());
        CHECK(vector.empty() == values.empty());
        CHECK(vector.denominator().sign() == 1);
        CHECK(vector.to_rationals() == values);
        for (std::size_t k = 0; k < values.size(); ++k) {
            CHECK(vector[k] == values[k]);
            CHECK(Rational(vector.numerators()[k], vector.denominator()) == values[k]);
        }
        vector.make_canonical();
        CHECK(vector.to_rationals() == values);
    }
}

TEST_CASE("the factors of a denominator have it as their product", "[rational_vector]") {
    const auto check_factors = [](const RationalVector& vector) {
        Integer product = 1;
        for (const Integer& factor : vector.denominator_factors()) {
            CHECK(factor.sign() == 1);
            product *= factor;
        }
        CHECK(product == vector.denominator());
    };
    Random random(53);
    for (int i = 0; i < 1500; ++i) {
        const std::vector<Rational> values = rationals(random);
        const RationalVector vector(values);
        check_factors(vector);
        const Integer divisor = abs(integer(random)) + 1;
        const std::vector<Integer> weights{divisor * 6, divisor * 10};
        RationalVector weighted = vector.weighted(weights, divisor);
        check_factors(weighted);
        for (std::size_t k = 0; k < values.size(); ++k)
            CHECK(weighted[k] == values[k] * (k % 2 == 0 ? 6 : 10));
        weighted.make_canonical();
        check_factors(weighted);
        for (std::size_t k = 0; k < values.size(); ++k)
            CHECK(weighted[k] == values[k] * (k % 2 == 0 ? 6 : 10));
        const RationalVector same = vector.over_same_denominator({1, -2});
        check_factors(same);
        CHECK(same[1] == Rational(-2, vector.denominator()));
    }
    CHECK(
        RationalVector(std::vector<Rational>{Rational(1, 6), Rational(1, 10)}).denominator_factors().size() ==
        2);
}

TEST_CASE("the common denominator of rational numbers is the least", "[rational_vector]") {
    const std::vector<Rational> values{Rational(1, 4), Rational(1, 6), Rational(5)};
    const RationalVector vector(values);
    CHECK(vector.denominator() == 12);
    CHECK(vector.numerators() == std::vector<Integer>{3, 2, 60});
}

TEST_CASE("made canonical, equal vectors are equal in every number", "[rational_vector]") {
    Random random(52);
    for (int i = 0; i < 1500; ++i) {
        const std::vector<Rational> values = rationals(random);
        const RationalVector plain(values);
        Integer factor = integer(random);
        if (factor.is_zero()) factor = -3;
        std::vector<Integer> numerators = plain.numerators();
        for (Integer& numerator : numerators) numerator *= factor;
        RationalVector scaled(numerators, plain.denominator() * factor);
        CHECK(scaled == plain);
        CHECK(plain == scaled);
        scaled.make_canonical();
        RationalVector canonical = plain;
        canonical.make_canonical();
        CHECK(scaled.numerators() == canonical.numerators());
        CHECK(scaled.denominator() == canonical.denominator());
    }
}

TEST_CASE("vectors of zeros have denominator 1 when canonical, empty ones too", "[rational_vector]") {
    RationalVector zeros({0, 0, 0}, 12);
    zeros.make_canonical();
    CHECK(zeros.denominator() == 1);
    RationalVector empty({}, -5);
    empty.make_canonical();
    CHECK(empty.denominator() == 1);
    CHECK(empty == RationalVector());
}

TEST_CASE("different vectors differ", "[rational_vector]") {
    CHECK_FALSE(RationalVector({1, 2}, 3) == RationalVector({1, 2}, 4));
    CHECK_FALSE(RationalVector({1, 2}, 3) == RationalVector({1, 3}, 3));
    CHECK_FALSE(RationalVector({1, 2}, 3) == RationalVector({1, 2, 0}, 3));
    CHECK_FALSE(RationalVector({2, 4}, 6) == RationalVector({1, 2, 0}, 3));
    CHECK(RationalVector({2, 4}, 6) == RationalVector({-1, -2}, -3));
}

TEST_CASE("a common denominator of zero is an error", "[rational_vector]") {
    CHECK(failure_code([] { RationalVector({1}, 0); }) == ErrorCode::zero_denominator);
}

TEST_CASE("the greatest bit length", "[rational_vector]") {
    CHECK(greatest_bit_length({}) == 0);
    const std::vector<Integer> values{0, -1, -(Integer(1) << 70), Integer(1) << 69};
    CHECK(greatest_bit_length(values) == 71);
    CHECK(greatest_bit_length(std::span(values).first(2)) == 1);
}
