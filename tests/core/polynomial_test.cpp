#include <blossom/core/algebra/polynomial.hpp>
#include "core_test.hpp"

namespace {

Polynomial from(std::initializer_list<Rational> coefficients) {
    return Polynomial(std::span<const Rational>(coefficients.begin(), coefficients.size()));
}

const Polynomial t = Polynomial::monomial(1);

/// The value as a sum of powers times coefficients.
Rational sum_of_powers(const Polynomial& polynomial, const Rational& x) {
    Rational value;
    Rational power = 1;
    for (std::size_t k = 0; k <= polynomial.degree(); ++k) {
        value += polynomial[k] * power;
        power *= x;
    }
    return value;
}

Polynomial nonzero(Random& random, std::size_t degree, Size size) {
    Polynomial chosen = polynomial(random, degree, size);
    while (chosen.is_zero()) chosen = polynomial(random, degree, size);
    return chosen;
}

}  // namespace

TEST_CASE("a polynomial drops leading zeros and reduces its denominator", "[polynomial]") {
    CHECK(from({1, 2, 0, 0}).degree() == 1);
    CHECK(from({0, 0}).is_zero());
    CHECK(from({}).is_zero());
    CHECK(Polynomial(0).is_zero());
    CHECK(Polynomial(Rational(0)) == Polynomial());
    CHECK(Polynomial().degree() == 0);
    CHECK(Polynomial().coefficients().empty());
    CHECK(Polynomial().leading_coefficient() == 0);
    CHECK(from({Rational(1, 2), Rational(1, 3)}).coefficients().denominator() == 6);
    CHECK(Polynomial(RationalVector({2, 4, 0}, 6)).coefficients().denominator() == 3);
    CHECK(Polynomial::monomial(0) == Polynomial(1));
    CHECK(Polynomial::monomial(3) == t * t * t);
    CHECK(from({1, 2})[7] == 0);
}

TEST_CASE("polynomials are a commutative ring", "[polynomial]") {
    Random random(111);
    for (int i = 0; i < 1500; ++i) {
        const Size size = i % 4 == 0 ? Size::any : Size::small;
        const Polynomial a = polynomial(random, 6, size);
        const Polynomial b = polynomial(random, 6, size);
        const Polynomial c = polynomial(random, 6, size);
        CAPTURE(a, b, c);
        CHECK(a + b == b + a);
        CHECK((a + b) + c == a + (b + c));
        CHECK(a + Polynomial() == a);
        CHECK(a - a == Polynomial());
        CHECK(a - b == a + -b);
        CHECK(-(-a) == a);
        CHECK(a * b == b * a);
        CHECK((a * b) * c == a * (b * c));
        CHECK(a * Polynomial(1) == a);
        CHECK((a * Polynomial()).is_zero());
        CHECK(a * (b + c) == a * b + a * c);
        Polynomial self = a;
        self += self;
        CHECK(self == a * 2);
        self -= self;
        CHECK(self.is_zero());
        self = a;
        self *= self;
        CHECK(self == a * a);
        CHECK((a + b).coefficients().denominator() ==
              Polynomial((a + b).coefficients()).coefficients().denominator());
    }
}

TEST_CASE("evaluation is a homomorphism", "[polynomial]") {
    Random random(112);
    for (int i = 0; i < 1500; ++i) {
        const Polynomial a = polynomial(random, 6, Size::any);
        const Polynomial b = polynomial(random, 6, Size::small);
        const Rational x = number(random, i % 2 == 0 ? Size::any : Size::small);
        CAPTURE(a, b, x);
        CHECK(a(x) == sum_of_powers(a, x));
        CHECK((a + b)(x) == a(x) + b(x));
        CHECK((a - b)(x) == a(x) - b(x));
        CHECK((a * b)(x) == a(x) * b(x));
    }
    CHECK(Polynomial()(5) == 0);
}

TEST_CASE("division leaves a remainder of smaller degree", "[polynomial]") {
    Random random(113);
    for (int i = 0; i < 1500; ++i) {
        const Size size = i % 4 == 0 ? Size::any : Size::small;
        const Polynomial a = polynomial(random, 8, size);
        const Polynomial b = nonzero(random, 5, size);
        CAPTURE(a, b);
        const auto [quotient, remainder] = divide(a, b);
        CHECK(quotient * b + remainder == a);
        CHECK((remainder.is_zero() || remainder.degree() < b.degree()));
        CHECK(divide_exactly(a * b, b) == a);
        if (!remainder.is_zero()) {
            CHECK(failure_code([&] { divide_exactly(a, b); }) == ErrorCode::inexact_division);
        }
    }
    CHECK(failure_code([] { divide(t, Polynomial()); }) == ErrorCode::division_by_zero);
    CHECK(failure_code([] { divide_exactly(Polynomial(), Polynomial()); }) == ErrorCode::division_by_zero);
    CHECK(divide_exactly(Polynomial(), t).is_zero());
    CHECK(divide(t, Polynomial(2)).first == t * Polynomial(Rational(1, 2)));
}

TEST_CASE("the greatest common divisor is monic, divides both and leaves coprime quotients", "[polynomial]") {
    Random random(114);
    for (int i = 0; i < 600; ++i) {
        const Polynomial shared = nonzero(random, 3, Size::small);
        const Polynomial a = shared * polynomial(random, 4, Size::small);
        const Polynomial b = shared * polynomial(random, 4, Size::small);
        CAPTURE(a, b, shared);
        const Polynomial divisor = gcd(a, b);
        CHECK(divisor == gcd(b, a));
        if (a.is_zero() && b.is_zero()) {
            CHECK(divisor.is_zero());
            continue;
        }
        CHECK(divisor.leading_coefficient() == 1);
        CHECK(divide(divisor, shared).second.is_zero());
        const Polynomial x = divide_exactly(a, divisor);
        const Polynomial y = divide_exactly(b, divisor);
        CHECK(gcd(x, y) == Polynomial(1));
    }
    CHECK(gcd(Polynomial(), Polynomial()).is_zero());
    CHECK(gcd(t * 4 - 2, Polynomial()) == t - Polynomial(Rational(1, 2)));
    CHECK(gcd(Polynomial(), t * -3) == t);
    CHECK(gcd(Polynomial(6), Polynomial(4)) == Polynomial(1));
    CHECK(gcd(pow(t - 1, 3) * pow(t + 2, 2), pow(t - 1, 2) * pow(t + 2, 4)) == pow(t - 1, 2) * pow(t + 2, 2));
}

TEST_CASE("composition is evaluation at a polynomial", "[polynomial]") {
    Random random(115);
    for (int i = 0; i < 500; ++i) {
        const Polynomial outer = polynomial(random, 5, Size::small);
        const Polynomial inner = polynomial(random, 3, Size::small);
        const Polynomial third = polynomial(random, 2, Size::small);
        const Rational x = number(random, Size::small);
        CAPTURE(outer, inner, x);
        CHECK(compose(outer, inner)(x) == outer(inner(x)));
        CHECK(compose(outer, t) == outer);
        CHECK(compose(t, inner) == inner);
        CHECK(compose(compose(outer, inner), third) == compose(outer, compose(inner, third)));
    }
}

TEST_CASE("the derivative is linear and obeys the product and chain rules", "[polynomial]") {
    Random random(116);
    for (int i = 0; i < 500; ++i) {
        const Polynomial a = polynomial(random, 5, Size::any);
        const Polynomial b = polynomial(random, 5, Size::small);
        CAPTURE(a, b);
        CHECK(derivative(a + b) == derivative(a) + derivative(b));
        CHECK(derivative(a * b) == derivative(a) * b + a * derivative(b));
        const Polynomial inner = polynomial(random, 3, Size::small);
        CHECK(derivative(compose(b, inner)) == compose(derivative(b), inner) * derivative(inner));
    }
    CHECK(derivative(Polynomial()).is_zero());
    CHECK(derivative(Polynomial(5)).is_zero());
    CHECK(derivative(Polynomial::monomial(7)) == Polynomial::monomial(6) * 7);
}

TEST_CASE("powers are repeated products", "[polynomial]") {
    Random random(117);
    for (int i = 0; i < 200; ++i) {
        const Polynomial base = polynomial(random, 3, Size::small);
        Polynomial expected = 1;
        for (std::size_t k = 0; k <= 7; ++k) {
            CHECK(pow(base, k) == expected);
            expected *= base;
        }
    }
    CHECK(pow(Polynomial(), 0) == Polynomial(1));
}
