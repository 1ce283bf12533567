#include <blossom/core/algebra/polynomial_text.hpp>
#include "core_test.hpp"

// Texts that need too much memory are refused before it is allocated, with the position of the cause.

namespace {

void check_refused(const std::string& text, const std::string& limit, const Limits& limits = {}) {
    CAPTURE(text.substr(0, 60), limit);
    const auto error = failure([&] { parse_polynomial(text, {}, limits); });
    REQUIRE(error);
    CHECK(failure_code([&] { parse_polynomial(text, {}, limits); }) == ErrorCode::limit_exceeded);
    CHECK(error->message().find(limit + " = ") != std::string::npos);
    CHECK(error->message().size() < 300);
    CHECK(error->offset());
}

std::string repeated(const std::string& piece, std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i) text += piece;
    return text;
}

}  // namespace

TEST_CASE("exponents and degrees", "[polynomial_text][limits]") {
    check_refused("t^999999999999", "degree");
    check_refused("t^99999999999999999999999999", "degree");
    check_refused("1 + t^10001", "degree");
    check_refused("2^10001", "degree");
    check_refused("t^5001 * t^5000", "degree");
    check_refused("(t^101)^100", "degree");
    check_refused("((t^10000)^10000)^10000", "degree");
    check_refused("x^5000*y^5001", "degree");
    CHECK(parse_univariate("t^10000").polynomial.degree() == 10000);
    CHECK(parse_univariate("(t^100)^100").polynomial.degree() == 10000);
    Limits limits;
    limits.degree = 3;
    CHECK(parse_univariate("t^3", limits).polynomial.degree() == 3);
    check_refused("t^4", "degree", limits);
    check_refused("t*t*t*t", "degree", limits);
    check_refused("(1+t)^4", "degree", limits);
}

TEST_CASE("digits of numbers and of powers of numbers", "[polynomial_text][limits]") {
    check_refused(std::string(50'000'000, '7'), "digits");
    check_refused("1e999999999999", "digits");
    check_refused("t + 1e-999999999", "digits");
    check_refused("((9^9)^9999)^9999", "digits");
    check_refused("(((9^99)^99)^99)^99", "digits");
    check_refused("((1/9)^9999)^9999", "digits");
    check_refused("(9^9999 t)^9999", "digits");
    Limits limits;
    limits.digits = 20;
    CHECK(parse_univariate("9^12", limits).polynomial == pow(Polynomial(9), 12));
    check_refused(repeated("9^9*", 5) + "1", "digits", limits);
    check_refused(repeated("1", 1).append(repeated("/9^9", 5)), "digits", limits);
    check_refused("9^40", "digits", limits);
    check_refused("123456789012345678901", "digits", limits);
}

TEST_CASE("sums of fractions with many denominators", "[polynomial_text][limits]") {
    Limits limits;
    limits.digits = 1000;
    std::string text = "1/2^900";
    for (const int prime : {3, 5, 7, 11, 13, 17, 19, 23, 29})
        text += " + 1/" + std::to_string(prime) + "^900";
    check_refused(text, "digits", limits);
}

TEST_CASE("brackets within brackets", "[polynomial_text][limits]") {
    check_refused(std::string(1'000'000, '('), "nesting");
    check_refused(std::string(1'000'000, '(') + "t" + std::string(1'000'000, ')'), "nesting");
    CHECK(parse_univariate(std::string(200, '(') + "t" + std::string(200, ')')).polynomial.degree() == 1);
    check_refused(std::string(201, '(') + "t" + std::string(201, ')'), "nesting");
    // Brackets one after another are not nested.
    CHECK(parse_univariate(repeated("(1)", 1000)).polynomial == Polynomial(1));
}

TEST_CASE("the number of terms and of term operations", "[polynomial_text][limits]") {
    check_refused("(a+b+c+d)^500", "expansion_terms");
    check_refused("(a+b+c+d+e+f+g+h)^20", "expansion_terms");
    check_refused("(1+a)^20(1+b)^20(1+c)^20(1+d)^20(1+e)^20", "expansion_terms");
    Limits few;
    few.expansion_terms = 10;
    CHECK(parse_polynomial("(a+b)^9", {}, few).polynomial.size() == 10);
    check_refused("(a+b)^10", "expansion_terms", few);
    check_refused("(a+b+c)^4", "expansion_terms", few);
    check_refused("a+b+c+d+e+f+g+h+i+j+k", "expansion_terms", few);
    Limits work;
    work.expansion_work = 100;
    CHECK(parse_polynomial("(1+t)^9 (1+t)^9", {}, work).polynomial.size() == 19);
    check_refused("(1+t)^9 (1+t)^9 (1+t)^9", "expansion_work", work);
    check_refused("(1+t+t^2)^40", "expansion_work", work);
}

TEST_CASE("the number of variables", "[polynomial_text][limits]") {
    std::string text = "x0";
    for (int i = 1; i < 256; ++i) text += "+x" + std::to_string(i);
    CHECK(parse_polynomial(text).names.size() == 256);
    check_refused(text + "+x256", "variables");
    CHECK(parse_polynomial("x0*x255", parse_polynomial(text).names).polynomial.total_degree() == 2);
}

TEST_CASE("no refusal takes much memory", "[polynomial_text][limits]") {
    const std::string number(50'000'000, '7');
    const std::string brackets(50'000'000, '(');
    const std::size_t before = peak_memory();
    for (const std::string_view text :
         {std::string_view(number), std::string_view(brackets), std::string_view("t^999999999999"),
          std::string_view("((9^9999)^9999)^9999"), std::string_view("(a+b+c+d)^500"),
          std::string_view("1e999999999")}) {
        CHECK(failure_code([&] { parse_polynomial(text); }) == ErrorCode::limit_exceeded);
    }
    CHECK(peak_memory() < before + 64);
}
