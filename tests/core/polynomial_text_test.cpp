#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/rational/utf8.hpp>
#include "core_test.hpp"

namespace {

const Polynomial t = Polynomial::monomial(1);
const SparsePolynomial x = SparsePolynomial::variable(0);
const SparsePolynomial y = SparsePolynomial::variable(1);

Polynomial read(const std::string& text) { return parse_univariate(text).polynomial; }

SparsePolynomial read_xy(const std::string& text) {
    const std::vector<std::string> names{"x", "y"};
    return parse_polynomial(text, names).polynomial;
}

SparsePolynomial fraction(int p, int q) { return SparsePolynomial(Rational(p, q)); }

}  // namespace

TEST_CASE("polynomials in one variable are read as people write them", "[polynomial_text]") {
    CHECK(read("1 + 2t + 4t^2 - t^3") == t * 2 + 1 + pow(t, 2) * 4 - pow(t, 3));
    CHECK(read("(t-1/2)^3") == pow(t - Polynomial(Rational(1, 2)), 3));
    CHECK(read("1/2t") == t * Polynomial(Rational(1, 2)));
    CHECK(read("1/2*t") == t * Polynomial(Rational(1, 2)));
    CHECK(read("t/2/3") == t * Polynomial(Rational(1, 6)));
    CHECK(read("6/4") == Polynomial(Rational(3, 2)));
    CHECK(read("2t/4t") == t * t * Polynomial(Rational(1, 2)));
    CHECK(read("t/(1/2)") == t * 2);
    CHECK(read("t/2^3") == t * Polynomial(Rational(1, 8)));
    CHECK(read("0.5t + 1.5e-3") == t * Polynomial(Rational(1, 2)) + Polynomial(Rational(3, 2000)));
    CHECK(read("2(t+1)(t-1)") == (t * t - 1) * 2);
    CHECK(read("-t^2") == -(t * t));
    CHECK(read("-t^2 + t^2").is_zero());
    CHECK(read("+t") == t);
    CHECK(read("1 - -t") == t + 1);
    CHECK(read("1 + -t") == Polynomial(1) - t);
    CHECK(read("2^10") == Polynomial(1024));
    CHECK(read("0^0") == Polynomial(1));
    CHECK(read("t^0") == Polynomial(1));
    CHECK(read("t^007") == pow(t, 7));
    CHECK(read("  t\t+\n1\r ") == t + 1);
    CHECK(read("t*t*t") == pow(t, 3));
    CHECK(read("t t") == t * t);
    CHECK(read("((((t))))") == t);
    CHECK(read("(t)") == t);
    CHECK(read("3") == Polynomial(3));
    CHECK(read("9223372036854775808t") == t * Polynomial(Rational(-Integer(INT64_MIN))));
}

TEST_CASE("the name of the variable is free", "[polynomial_text]") {
    CHECK(parse_univariate("1 + x").name == "x");
    CHECK(parse_univariate("1 + x_1^2").name == "x_1");
    CHECK(parse_univariate("_ + 1").name == "_");
    CHECK(parse_univariate("e^2").name == "e");
    CHECK(parse_univariate("2e").name == "e");
    CHECK(parse_univariate("2e2").name == "t");
    CHECK(parse_univariate("7").name == "t");
    CHECK(parse_univariate("u10 + 1").polynomial == t + 1);
    CHECK(failure_code([] { parse_univariate("x + y"); }) == ErrorCode::syntax);
    CHECK(failure_code([] { parse_univariate("xy + x"); }) == ErrorCode::syntax);
}

TEST_CASE("polynomials in several variables", "[polynomial_text]") {
    CHECK(read_xy("-3/4 x^2*y") == fraction(-3, 4) * x * x * y);
    CHECK(read_xy("-3/4x^2 y") == fraction(-3, 4) * x * x * y);
    CHECK(read_xy("(x+y)^2 - (x-y)^2") == SparsePolynomial(4) * x * y);
    CHECK(read_xy("x(x+y)y") == x * x * y + x * y * y);
    const NamedPolynomial free = parse_polynomial("b*a + c");
    CHECK(free.names == std::vector<std::string>{"b", "a", "c"});
    CHECK(free.polynomial == x * y + SparsePolynomial::variable(2));
    const NamedPolynomial given = parse_polynomial("y", std::vector<std::string>{"x", "y"});
    CHECK(given.names == std::vector<std::string>{"x", "y"});
    CHECK(given.polynomial == y);
}

TEST_CASE("an invalid polynomial is refused at its place", "[polynomial_text]") {
    struct Example {
        const char* text;
        std::size_t offset;
        ErrorCode code = ErrorCode::syntax;
    };
    const Example examples[] = {
        {"", 0},
        {"   ", 3},
        {"1 +", 3},
        {"1 + )", 4},
        {"(t", 2},
        {"t)", 1},
        {"2 3", 2},
        {"t 3", 2},
        {"(t+1)2t", 5},
        {"t^", 2},
        {"t^-1", 2},
        {"t^(2)", 2},
        {"t^2^3", 3},
        {"t^t", 2},
        {"t^1.5", 3},
        {"1 + 2$", 5},
        {"1..", 1},
        {".", 0},
        {"x.5", 1},
        {"x½", 1},
        {"1_000x", 1},
        {"t²³^2", 5},
        {"t⁻²", 1},
        {"t²^3", 3},
        {"²", 0},
        {"t**", 3},
        {"t//2", 2},
        {"t***2", 3},
        {"1/t", 2},
        {"1/(t+1)", 2},
        {"1 + 1/0", 5, ErrorCode::zero_denominator},
        {"t/(1-1)", 1, ErrorCode::zero_denominator},
        {"- - t", 2},
        {"()", 1},
        {"t=1", 1},
        {"\xC2\xB6t", 0},
        {"t,2", 1},
    };
    for (const Example& example : examples) {
        CAPTURE(example.text);
        const auto error = failure([&] { parse_polynomial(example.text); });
        REQUIRE(error);
        CHECK(failure_code([&] { parse_polynomial(example.text); }) == example.code);
        CHECK(error->offset() == example.offset);
        const std::size_t column =
            count_characters(std::string_view(example.text).substr(0, example.offset)) + 1;
        CHECK(error->message().starts_with("column " + std::to_string(column) + ": "));
    }
    const auto unknown = failure([] { read_xy("x + z"); });
    REQUIRE(unknown);
    CHECK(unknown->code() == ErrorCode::syntax);
    CHECK(unknown->offset() == 4U);
    CHECK(unknown->message().find("\"z\"") != std::string::npos);
    CHECK(failure_code([] { parse_polynomial(std::string_view("t\0", 2)); }) == ErrorCode::syntax);
}

TEST_CASE("polynomials are read as people write them", "[polynomial_text]") {
    struct Example {
        const char* text;
        const char* plain;
    };
    for (const Example& example :
         {Example{"x²+2x+1", "x^2+2x+1"}, Example{"\u2212x", "-x"}, Example{"x**2", "x^2"},
          Example{"3·x", "3x"}, Example{"3 × x", "3x"}, Example{"3\u22C5x", "3x"}, Example{"½x", "1/2x"},
          Example{"1½x²", "3/2 x^2"}, Example{".5x", "1/2 x"}, Example{"0.x", "0"}, Example{"2.x", "2x"},
          Example{"x\u20442", "x/2"}, Example{"x¹⁰ \u2212 \u2212x", "x^10 + x"}, Example{"(x+1)²", "(x+1)^2"},
          Example{"0x1.8p-3x", "3/16 x"}, Example{"2¹⁰x", "1024x"}, Example{"x²y", "x^2*y"},
          Example{"x^2\t", "x²"}}) {
        CAPTURE(example.text);
        CHECK(parse_polynomial(example.text).polynomial == parse_polynomial(example.plain).polynomial);
    }
}

TEST_CASE("polynomials are written by rising degree", "[polynomial_text]") {
    CHECK(to_text(t * 2 + 1 + pow(t, 2) * 4 - pow(t, 3)) == "1 + 2t + 4t^2 - t^3");
    CHECK(to_text(Polynomial()) == "0");
    CHECK(to_text(-t) == "-t");
    CHECK(to_text(Polynomial(-1)) == "-1");
    CHECK(to_text(t * Polynomial(Rational(2, 3)), "u1") == "2/3 u1");
    CHECK(to_text(t * 3, "t1") == "3 t1");
    CHECK(to_text(t * Polynomial(Rational(-1, 2)) + 1) == "1 - 1/2 t");
    const std::vector<std::string> names{"x", "y"};
    CHECK(to_text(x * x + SparsePolynomial(3) * x * y - SparsePolynomial(2), names) == "-2 + x^2 + 3x*y");
    CHECK(to_text(fraction(-3, 4) * x * x * y, names) == "-3/4 x^2*y");
    CHECK(to_text(SparsePolynomial(), names) == "0");
    CHECK(numbered_names("u", 3) == std::vector<std::string>{"u1", "u2", "u3"});
    CHECK(numbered_names("u", 0).empty());
}

TEST_CASE("what is written is read back", "[polynomial_text]") {
    Random random(131);
    const std::vector<std::vector<std::string>> alphabets{
        {"x", "y", "z"}, {"u1", "u2", "u3"}, {"e", "e1", "E"}, {"_", "__", "a_b"}};
    for (int i = 0; i < 1500; ++i) {
        const Polynomial dense_one = polynomial(random, 6, i % 3 == 0 ? Size::any : Size::small);
        const auto& names = alphabets[random.below(alphabets.size())];
        CHECK(parse_univariate(to_text(dense_one, names[1])).polynomial == dense_one);
        SparsePolynomial several;
        for (std::uint64_t k = random.below(6); k > 0; --k) {
            const std::vector<std::size_t> exponents{random.below(3), random.below(4), random.below(2)};
            several +=
                SparsePolynomial::term(number(random, i % 3 == 0 ? Size::any : Size::small), exponents);
        }
        const std::string text = to_text(several, names);
        CAPTURE(text);
        CHECK(parse_polynomial(text, names).polynomial == several);
    }
}

TEST_CASE("dense and sparse forms are the same polynomial", "[polynomial_text]") {
    Random random(132);
    for (int i = 0; i < 500; ++i) {
        const Polynomial chosen = polynomial(random, 7, Size::any);
        CHECK(dense(sparse(chosen)) == chosen);
        const std::vector<Rational> point{number(random, Size::small)};
        CHECK(sparse(chosen)(point) == chosen(point[0]));
    }
    CHECK(sparse(Polynomial()).is_zero());
    CHECK(dense(SparsePolynomial()).is_zero());
}
