#include <blossom/core/algebra/sparse_polynomial.hpp>
#include "core_test.hpp"

namespace {

/// Up to `terms` terms in some of the first `variables` variables.
SparsePolynomial sparse_polynomial(Random& random, std::size_t terms, std::size_t variables, Size size) {
    SparsePolynomial result;
    for (std::uint64_t i = random.below(terms + 1); i > 0; --i) {
        std::vector<std::size_t> exponents(random.below(variables + 1));
        for (std::size_t& exponent : exponents) exponent = random.one_in(2) ? 0 : random.below(5);
        result += SparsePolynomial::term(number(random, size), exponents);
    }
    return result;
}

std::vector<Rational> values(Random& random, std::size_t n) {
    std::vector<Rational> point;
    while (point.size() < n) point.push_back(number(random, Size::small));
    return point;
}

/// Checks the order of terms, that there are no zeros, the least denominator and no unused words, so that
/// equal polynomials have equal representations.
void check_canonical(const SparsePolynomial& polynomial) {
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        CHECK_FALSE(polynomial.coefficient(i).is_zero());
        if (i == 0) continue;
        std::vector<std::size_t> previous;
        std::vector<std::size_t> current;
        for (std::size_t k = 0; k < polynomial.variables(); ++k) {
            previous.push_back(polynomial.exponent(i - 1, k));
            current.push_back(polynomial.exponent(i, k));
        }
        CHECK(previous > current);
    }
    Integer common = polynomial.coefficients().denominator();
    for (const Integer& numerator : polynomial.coefficients().numerators()) common = gcd(common, numerator);
    CHECK(common == 1);
    std::size_t occurring = 0;
    for (std::size_t k = 0; k < polynomial.variables(); ++k) {
        if (polynomial.degree_in(k) > 0) occurring = k + 1;
    }
    CHECK(polynomial.variables() < occurring + 4);
}

}  // namespace

TEST_CASE("terms keep their exponents in every width", "[sparse_polynomial]") {
    for (std::size_t variables = 1; variables <= 12; ++variables) {
        std::vector<std::size_t> exponents;
        for (std::size_t k = 0; k < variables; ++k) exponents.push_back(k % 3 == 0 ? 32767 : k + 1);
        const SparsePolynomial term = SparsePolynomial::term(Rational(-2, 3), exponents);
        CHECK(term.size() == 1);
        CHECK(term.coefficient(0) == Rational(-2, 3));
        std::size_t total = 0;
        for (std::size_t k = 0; k < variables; ++k) {
            CAPTURE(variables, k);
            CHECK(term.exponent(0, k) == exponents[k]);
            CHECK(term.degree_in(k) == exponents[k]);
            total += exponents[k];
        }
        CHECK(term.exponent(0, variables) == 0);
        CHECK(term.exponent(0, 1000) == 0);
        CHECK(term.degree(0) == total);
        CHECK(term.total_degree() == total);
        CHECK(SparsePolynomial::variable(variables - 1).exponent(0, variables - 1) == 1);
    }
}

TEST_CASE("zero is one object", "[sparse_polynomial]") {
    const SparsePolynomial x = SparsePolynomial::variable(9);
    const SparsePolynomial third = SparsePolynomial(Rational(1, 3));
    const std::vector<std::size_t> exponents{0, 5};
    for (const SparsePolynomial& zero :
         {SparsePolynomial(0), SparsePolynomial(Rational(0)), x - x, third - third, (x + third) - third - x,
          x * SparsePolynomial(0), SparsePolynomial::term(0, exponents), sum({})}) {
        CHECK(zero == SparsePolynomial());
        CHECK(zero.is_zero());
        CHECK(zero.variables() == 0);
        CHECK(zero.coefficients().denominator() == 1);
        CHECK(zero.total_degree() == 0);
    }
}

TEST_CASE("a variable that cancels leaves no trace", "[sparse_polynomial]") {
    const SparsePolynomial x = SparsePolynomial::variable(0);
    const SparsePolynomial far = SparsePolynomial::variable(11);
    CHECK((x + far) - far == x);
    CHECK(((x + far) - far).variables() == x.variables());
    CHECK(SparsePolynomial::term(1, std::vector<std::size_t>{1, 0, 0, 0, 0, 0, 0, 0, 0}) == x);
}

TEST_CASE("sparse polynomials are a commutative ring in 1 to 12 variables", "[sparse_polynomial]") {
    Random random(121);
    for (int i = 0; i < 1200; ++i) {
        const std::size_t variables = 1 + static_cast<std::size_t>(i) % 12;
        const Size size = i % 5 == 0 ? Size::any : Size::small;
        const SparsePolynomial a = sparse_polynomial(random, 6, variables, size);
        const SparsePolynomial b = sparse_polynomial(random, 6, 12, size);
        const SparsePolynomial c = sparse_polynomial(random, 4, variables, size);
        CAPTURE(a, b, c);
        CHECK(a + b == b + a);
        CHECK((a + b) + c == a + (b + c));
        CHECK(a + SparsePolynomial() == a);
        CHECK((a - a).is_zero());
        CHECK(a - b == a + -b);
        CHECK(a * b == b * a);
        CHECK((a * b) * c == a * (b * c));
        CHECK(a * SparsePolynomial(1) == a);
        CHECK((a * SparsePolynomial()).is_zero());
        CHECK(a * (b + c) == a * b + a * c);
        CHECK((a + b) * (a - b) == a * a - b * b);
        const auto product = product_within(a, b, 36);
        REQUIRE(product);
        CHECK(*product == a * b);
        if (!product->is_zero()) CHECK_FALSE(product_within(a, b, product->size() - 1));
        check_canonical(a + b);
        check_canonical(a * b);
        check_canonical((a + b) - b);
        SparsePolynomial self = a;
        self += self;
        CHECK(self == a * SparsePolynomial(2));
        self *= self;
        CHECK(self == a * a * SparsePolynomial(4));
        self -= self;
        CHECK(self.is_zero());
    }
}

TEST_CASE("evaluation of sparse polynomials is a homomorphism", "[sparse_polynomial]") {
    Random random(122);
    for (int i = 0; i < 600; ++i) {
        const std::size_t variables = 1 + static_cast<std::size_t>(i) % 12;
        const SparsePolynomial a = sparse_polynomial(random, 6, variables, Size::any);
        const SparsePolynomial b = sparse_polynomial(random, 6, variables, Size::small);
        const std::vector<Rational> point = values(random, variables);
        CAPTURE(a, b);
        Rational expected;
        for (std::size_t k = 0; k < a.size(); ++k) {
            Rational term = a.coefficient(k);
            for (std::size_t j = 0; j < variables; ++j) {
                for (std::size_t p = 0; p < a.exponent(k, j); ++p) term *= point[j];
            }
            expected += term;
        }
        CHECK(a(point) == expected);
        CHECK((a + b)(point) == a(point) + b(point));
        CHECK((a - b)(point) == a(point) - b(point));
        CHECK((a * b)(point) == a(point) * b(point));
    }
}

TEST_CASE("a value for every variable that occurs is needed", "[sparse_polynomial]") {
    const SparsePolynomial x = SparsePolynomial::variable(2);
    const std::vector<Rational> two{1, 2};
    const std::vector<Rational> three{1, 2, 5};
    CHECK(failure_code([&] { x(two); }) == ErrorCode::wrong_arity);
    CHECK(x(three) == 5);
    CHECK(SparsePolynomial(7)({}) == 7);
}

TEST_CASE("powers of sparse polynomials are repeated products", "[sparse_polynomial]") {
    Random random(123);
    for (int i = 0; i < 400; ++i) {
        // One term, two terms (the binomial theorem) and more are different paths.
        const SparsePolynomial base =
            sparse_polynomial(random, static_cast<std::size_t>(i) % 5, 6, Size::small);
        CAPTURE(base);
        SparsePolynomial expected = 1;
        for (std::size_t k = 0; k <= 6; ++k) {
            CHECK(pow(base, k) == expected);
            check_canonical(pow(base, k));
            expected *= base;
        }
    }
}

TEST_CASE("the sum of many is the sum of all", "[sparse_polynomial]") {
    Random random(124);
    for (std::size_t n = 0; n <= 20; ++n) {
        std::vector<SparsePolynomial> summands;
        SparsePolynomial expected;
        while (summands.size() < n) {
            summands.push_back(sparse_polynomial(random, 3, 5, Size::small));
            expected = expected + summands.back();
        }
        CHECK(sum(summands) == expected);
    }
}

TEST_CASE("exponents beyond 32767 are refused wherever they arise", "[sparse_polynomial]") {
    for (const std::size_t variable : {0U, 1U, 3U, 4U, 11U}) {
        CAPTURE(variable);
        const SparsePolynomial x = SparsePolynomial::variable(variable);
        std::vector<std::size_t> exponents(variable + 1);
        exponents[variable] = 32767;
        const SparsePolynomial greatest = SparsePolynomial::term(1, exponents);
        CHECK(pow(x, 32767) == greatest);
        CHECK(failure_code([&] { greatest* x; }) == ErrorCode::limit_exceeded);
        CHECK(failure_code([&] { greatest* greatest; }) == ErrorCode::limit_exceeded);
        CHECK(failure_code([&] { pow(x, 32768); }) == ErrorCode::limit_exceeded);
        CHECK(failure_code([&] { pow(x, 1'000'000'000); }) == ErrorCode::limit_exceeded);
        CHECK(failure_code([&] { pow(x + 1, 32768); }) == ErrorCode::limit_exceeded);
        CHECK(failure_code([&] { pow(x * x + 1, 16384); }) == ErrorCode::limit_exceeded);
        exponents[variable] = 32768;
        CHECK(failure_code([&] { SparsePolynomial::term(1, exponents); }) == ErrorCode::limit_exceeded);
        // The adjacent exponent in the same word is unchanged.
        CHECK((greatest * SparsePolynomial::variable(variable + 1)).exponent(0, variable) == 32767);
    }
}

TEST_CASE("exponents take the bits that they need", "[sparse_polynomial]") {
    const SparsePolynomial x = SparsePolynomial::variable(0);
    const SparsePolynomial far = SparsePolynomial::variable(20);
    for (const std::size_t n : {7u, 8u, 127u, 128u, 300u}) {
        SparsePolynomial power = 1;
        for (std::size_t i = 0; i < n; ++i) power *= x + far;
        CAPTURE(n);
        CHECK(power == pow(x + far, n));
        CHECK(power.degree_in(20) == n);
        CHECK(power.degrees().size() == 21);
        CHECK(power.degrees()[0] == n);
        CHECK(power.total_degree() == n);
        check_canonical(power);
        // The remaining exponents are small again.
        const SparsePolynomial high = pow(x, n) * far;
        CHECK((high + x + 1) - high == x + 1);
        check_canonical((high + far) - high);
    }
    const std::vector<std::size_t> most(5, 32767);
    CHECK(SparsePolynomial::term(1, most).degree(0) == 5 * 32767);
    CHECK(failure_code([&] { SparsePolynomial::term(1, most) * x; }) == ErrorCode::limit_exceeded);
}

TEST_CASE("powers of independent terms are those by products", "[sparse_polynomial]") {
    Random random(127);
    std::size_t independent = 0;
    for (int i = 0; i < 300; ++i) {
        const SparsePolynomial base = sparse_polynomial(random, 5, 6, Size::small);
        const std::size_t n = random.below(6);
        const auto all = powers(base, n);
        REQUIRE(all.size() == n + 1);
        SparsePolynomial product = 1;
        for (std::size_t k = 0; k <= n; ++k) {
            CAPTURE(base, k);
            CHECK(all[k] == product);
            CHECK(pow(base, k) == product);
            product *= base;
        }
        if (base.size() > 2 && has_independent_terms(base)) {
            ++independent;
            CHECK(Integer(all[n].size()) == binomial(n + base.size() - 1, n));
        }
    }
    CHECK(independent > 30);
}
