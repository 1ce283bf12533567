#include <blossom/worked/formula.hpp>
#include <blossom/worked/notation.hpp>

#include "support/catch.hpp"

using namespace blossom;
using namespace blossom::worked;

namespace {

const Formula t = symbol("t");
const Formula delta_symbol = symbol("delta");

Formula third(int numerator) { return number(Rational(numerator, 3)); }

}  // namespace

TEST_CASE("formulas read as a teacher writes them") {
    CHECK(to_text(sum({number(1), product({number(2), t}), product({number(-1), power(t, number(3))})})) ==
          "1 + 2t − t³");
    CHECK(to_text(product({third(2), index(symbol("e"), number(1))})) == "2/3 e₁");
    CHECK(to_text(product({number(2), third(5)})) == "2·5/3");
    CHECK(to_text(product({number(3), number(-2)})) == "3(−2)");
    CHECK(to_text(product({number(-3), number(2)})) == "−3·2");
    CHECK(to_text(power(number(Rational(1, 2)), number(2))) == "(1/2)²");
    CHECK(to_text(power(t, sum({symbol("n"), product({number(-1), symbol("k")})}))) == "t^(n − k)");
    CHECK(to_text(fraction(sum({number(1), number(2)}), number(2))) == "(1 + 2)/2");
    CHECK(to_text(sum({number(1), sum({number(-2), t})})) == "1 + (−2 + t)");
    CHECK(to_text(derivative_of("P", 2, number(5))) == "P″(5)");
    CHECK(to_text(derivative_of("P", 4, t)) == "P⁽⁴⁾(t)");
    CHECK(to_text(equation({blossom_of("p", {number(1), delta_symbol}), third(-8)})) == "p(1, δ) = −8/3");
    CHECK(to_text(symbol("u12")) == "u₁₂");
    CHECK(to_text(set_of({number(1), number(2)})) == "{1, 2}");
}

TEST_CASE("a blossom value in each notation") {
    const Formula letters = blossom_of("p", {symbol("u"), symbol("v"), symbol("v")});
    const Formula numbers = blossom_of("b", {number(0), number(0), number(Rational(1, 2))});
    const Notation brackets{BlossomStyle::brackets, false};
    const Notation multiplicative{BlossomStyle::multiplicative, false};
    const Notation counted{BlossomStyle::parentheses, true};
    CHECK(to_text(letters) == "p(u, v, v)");
    CHECK(to_text(letters, brackets) == "p[u, v, v]");
    CHECK(to_text(letters, multiplicative) == "u v v");
    CHECK(to_text(numbers, multiplicative) == "(0)(0)(1/2)");
    CHECK(to_text(numbers, counted) == "b(0^<2>, 1/2)");
    CHECK(to_latex(numbers, counted) == "b({0}^{\\langle 2\\rangle}, \\tfrac{1}{2})");
    // After a factor, the product of arguments needs parentheses.
    CHECK(to_text(product({number(2), numbers}), multiplicative) == "2((0)(0)(1/2))");
}

TEST_CASE("LaTeX and MathML come from the same tree") {
    const Formula formula =
        equation({call("P", {t}), sum({third(1), product({number(-1), power(t, number(2))})})});
    CHECK(to_latex(formula) == "P(t) = \\tfrac{1}{3} - {t}^{2}");
    CHECK(to_mathml(t) == "<math><mi>t</mi></math>");
    CHECK(to_mathml(third(1), {}, true) ==
          "<math displaystyle=\"true\"><mfrac><mn>1</mn><mn>3</mn></mfrac></math>");
    CHECK(to_mathml(power(t, number(2))) == "<math><msup><mi>t</mi><mn>2</mn></msup></math>");
    CHECK(to_latex(symbol("delta")) == "\\delta");
    CHECK(to_latex(symbol("a_b")) == "\\mathit{a\\_b}");
    CHECK(to_mathml(words("a < b & c")) == "<math><mtext>a &lt; b &amp; c</mtext></math>");
}
