#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/rational/error.hpp>
#include "core_test.hpp"

using blossom::testing::Random;

namespace {

const std::vector<std::string> names{"x", "y", "z"};

SparsePolynomial read(const std::string& text) { return parse_polynomial(text, names).polynomial; }

std::string text(const SparsePolynomial& polynomial) { return to_text(polynomial, names); }

template <class Call>
ErrorCode code_of(Call call) {
    try {
        call();
    } catch (const Error& error) {
        return error.code();
    }
    FAIL("no error");
    return ErrorCode::syntax;
}

}  // namespace

TEST_CASE("substitute composes in all variables at once") {
    const std::vector<SparsePolynomial> swap{read("y"), read("x")};
    CHECK(text(substitute(read("x^2 - 3y + z"), swap)) == "-3x + z + y^2");
    const std::vector<SparsePolynomial> values{read("y + 1"), read("x - y"), read("2")};
    CHECK(substitute(read("x*y*z + 1/2 x^2"), values) == read("2(y+1)(x-y) + 1/2(y+1)^2"));
    CHECK(substitute(read("0"), values).is_zero());
    CHECK(substitute(read("z^3"), std::vector<SparsePolynomial>{}) == read("z^3"));
}

TEST_CASE("the partial derivative of a sparse polynomial obeys the product rule") {
    CHECK(derivative(read("5/2 x^2*y - y^3 + 7"), 0) == read("5x*y"));
    CHECK(derivative(read("5/2 x^2*y - y^3 + 7"), 1) == read("5/2 x^2 - 3y^2"));
    CHECK(derivative(read("x + y"), 9).is_zero());
    const SparsePolynomial f = read("x^2*y - 1/3 z + 2");
    const SparsePolynomial g = read("y^2*z + x - 5");
    for (std::size_t variable = 0; variable < 3; ++variable) {
        CHECK(derivative(f * g, variable) == derivative(f, variable) * g + f * derivative(g, variable));
    }
}

TEST_CASE("exact division undoes multiplication and refuses a remainder") {
    const SparsePolynomial f = read("x^2*y - 1/3 z + 2");
    const SparsePolynomial g = read("y^2*z + x - 5");
    CHECK(divide_exactly(f * g, g) == f);
    CHECK(divide_exactly(f * g, f) == g);
    CHECK(divide_exactly(read("0"), f).is_zero());
    CHECK(divide_exactly(f, read("3/2")) == read("2/3 x^2*y - 2/9 z + 4/3"));
    CHECK(code_of([&] { return divide_exactly(f * g + 1, g); }) == ErrorCode::inexact_division);
    CHECK(code_of([&] { return divide_exactly(read("x"), read("z")); }) == ErrorCode::inexact_division);
    CHECK(code_of([&] { return divide_exactly(f, SparsePolynomial()); }) == ErrorCode::division_by_zero);
}

TEST_CASE("division by few and many terms is undone by multiplication, and a remainder is seen") {
    Random random(71);
    std::size_t refused = 0;
    for (int i = 0; i < 400; ++i) {
        const auto polynomial = [&](std::size_t terms, std::size_t greatest) {
            SparsePolynomial result;
            while (result.size() < terms) {
                std::vector<std::size_t> exponents(6);
                for (std::size_t& exponent : exponents)
                    exponent = random.one_in(2) ? 0 : random.below(greatest);
                result += SparsePolynomial::term(
                    Rational(Integer(random.between(1, 9)), Integer(random.between(1, 4))), exponents);
            }
            return result;
        };
        // Exponents of all three widths.
        const std::size_t greatest = i % 3 == 0 ? 3 : i % 3 == 1 ? 40 : 4000;
        const SparsePolynomial f = polynomial(1 + random.below(8), greatest);
        const SparsePolynomial g = polynomial(1 + random.below(5), greatest);
        const SparsePolynomial r = polynomial(1, greatest);
        const Division division = divide(f * g, g);
        REQUIRE(division.quotient);
        CHECK(*division.quotient == f);
        const Division other = divide(f * g + r, g);
        if (other.quotient) {
            CHECK(*other.quotient * g == f * g + r);
        } else {
            ++refused;
        }
        const auto coefficients = coefficients_by_powers(f, 2);
        CHECK(coefficients.size() == f.degree_in(2) + 1);
        CHECK(polynomial_value(coefficients, SparsePolynomial::variable(2)) == f);
    }
    CHECK(refused > 200);
    CHECK(coefficients_by_powers(SparsePolynomial(), 1).empty());
}

TEST_CASE("what has no repeated factor is seen from an image") {
    const SparsePolynomial f = read("x^2*y - 1/3 z + 2");
    const SparsePolynomial g = read("y^2*z + x - 5");
    for (std::size_t variable = 0; variable < 3; ++variable) {
        CHECK_FALSE(may_have_repeated_factor(f * g, variable));
        CHECK(may_have_repeated_factor(f * f * g, variable));
    }
    CHECK_FALSE(may_have_repeated_factor(read("(y+1)^2 (x^3 - z)"), 0));
    CHECK(may_have_repeated_factor(read("(y+1)^2 (x^3 - z)"), 1));
    CHECK_FALSE(may_have_repeated_factor(read("7"), 0));
    CHECK_FALSE(may_have_repeated_factor(read("x^1000 - y"), 0));
}

TEST_CASE("a division that is too much work is given up") {
    // The division would compute 1000 terms of a quotient before it finds that there is none.
    const SparsePolynomial f = read("x^1000 + y^1000*z");
    const SparsePolynomial g = read("x - y");
    CHECK_FALSE(divide(f, g).quotient);
    CHECK(divide(f, g).work > 1000);
    CHECK(divide(f, g, 100).work < 110);
    CHECK(divide(read("x^1000 - y^1000"), g).quotient->size() == 1000);
}

TEST_CASE("the gcd of sparse polynomials is monic and contains every common factor") {
    const SparsePolynomial f = read("x*y - 2z + 1");
    const SparsePolynomial g = read("x + y^2");
    const SparsePolynomial h = read("z^2 - 3x");
    CHECK(gcd(f * g, f * h) == f);
    CHECK(gcd(read("3") * pow(f, 2) * g, f * pow(g, 2)) == f * g);
    CHECK(gcd(g, h) == SparsePolynomial(1));
    CHECK(gcd(read("6"), read("4")) == SparsePolynomial(1));
    CHECK(gcd(SparsePolynomial(), read("-2 y + 4")) == read("y - 2"));
    CHECK(gcd(SparsePolynomial(), SparsePolynomial()).is_zero());
    CHECK(gcd(read("y*z"), read("z^2")) == read("z"));
}
