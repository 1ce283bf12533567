#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/parser.hpp>

#include <string>

#include "support/catch.hpp"

using namespace blossom;
using namespace blossom::proofs;

namespace {

std::string first_diagnostic(const std::string& text, const Limits& limits = {}) {
    const Document document = parse(text, limits);
    return document.errors.empty() ? "" : diagnostic("text", text, document.errors.front());
}

std::string canonical(const std::string& text) { return formatted(parse(text)); }

}  // namespace

TEST_CASE("an error of the language shows file, line, column, a caret and what was expected") {
    CHECK(first_diagnostic("claim a == (b + ") ==
          "text:1:16: the end of the line found, expected an expression\n"
          "  claim a == (b + \n"
          "                 ^\n");
    CHECK(first_diagnostic("map b degree 2\nclaim b[s,, t] == 1") ==
          "text:2:11: \",\" found, expected an expression\n"
          "  claim b[s,, t] == 1\n"
          "            ^\n");
    CHECK(first_diagnostic("theorem x\nfor n in 1.5\n") ==
          "text:2:13: the end of the line found, expected \"..\" between the bounds\n"
          "  for n in 1.5\n"
          "              ^\n");
    CHECK(first_diagnostic("claim é == 1") ==
          "text:1:7: the character \"é\" found, expected an expression\n"
          "  claim é == 1\n"
          "        ^\n");
}

TEST_CASE("each kind of line says what it lacks") {
    const auto message = [](const std::string& text) {
        const Document document = parse(text);
        REQUIRE(document.errors.size() == 1);
        return document.errors[0].message();
    };
    CHECK(message("lemma x").find("expected a line that begins with theorem, for, map") != std::string::npos);
    CHECK(message("theorem").find("expected the id of the theorem") != std::string::npos);
    CHECK(message("theorem x \"open\n").find("a string that is not closed") != std::string::npos);
    CHECK(message("for n 1..2").find("expected \"in\"") != std::string::npos);
    CHECK(message("map b 2").find("expected \"degree\" or \"degrees\"") != std::string::npos);
    CHECK(message("map b degree 2 on triangle").find("expected \"simplex\"") != std::string::npos);
    CHECK(message("poly P degree 2 = t").find("expected \"(\" before the variables") != std::string::npos);
    CHECK(message("raise p as q").find("expected \"to\"") != std::string::npos);
    CHECK(message("let x == 2").find("expected \"=\"") != std::string::npos);
    CHECK(message("assume a == b").find("expected \"!=\"") != std::string::npos);
    CHECK(message("claim a = b").find("expected \"==\"") != std::string::npos);
    CHECK(message("claim a == b c").find("expected an operator or the end of the line") != std::string::npos);
    CHECK(message("claim a == b for all x").find("belongs to hypotheses") != std::string::npos);
    CHECK(message("claim <1> == 1").find("between the two entries of a pair") != std::string::npos);
    CHECK(message("claim b[t_i : k] == 1").find("expected \"in\"") != std::string::npos);
    CHECK(message("claim b' == 1").find("expected \"(\" after the mark of a derivative") !=
          std::string::npos);
    CHECK(message("claim b_1(t) == 1").find("a map has no indices") != std::string::npos);
}

TEST_CASE("an error in one block leaves the others alone") {
    const Document document = parse(
        "theorem first\nclaim 1 == 1\n"
        "theorem second\nclaim (1 == \n  [ \n"
        "theorem third\nclaim 2 == 2\n");
    REQUIRE(document.blocks.size() == 2);
    CHECK(document.blocks[0].id == "first");
    CHECK(document.blocks[1].id == "third");
    CHECK(document.errors.size() == 1);
}

TEST_CASE("a text that decides nothing is an error") {
    for (const char* text :
         {"", "# a comment\n", "number x\ngiven x == 1\n", "theorem first\nmap b degree 2\n"})
        CHECK_THROWS_AS(require_claim(parse(text)), Error);
    CHECK_NOTHROW(require_claim(parse("theorem first\nmap b degree 2\ntheorem second\nrefute 1 == 2\n")));
}

TEST_CASE("brackets nest up to the limit") {
    const std::size_t depth = Limits{}.nesting;
    const auto nested = [](std::size_t n) {
        return "claim " + std::string(n, '(') + "1" + std::string(n, ')') + " == 1";
    };
    CHECK(first_diagnostic(nested(depth - 1)).empty());
    CHECK(first_diagnostic(nested(depth)).find("limit nesting = 200") != std::string::npos);
    CHECK(first_diagnostic("claim " + std::string(100'000, '-') + "1 == 1").find("nesting") !=
          std::string::npos);
}

TEST_CASE("a sum or a product is a list, whatever stands in parentheses on its left") {
    const auto side = [](const std::string& text) {
        return parse("claim " + text + " == 0").blocks.at(0).statements.at(0).sides.at(0);
    };
    CHECK(side("a + b - c").children.size() == 3);
    CHECK(side("a + b - c").name == "+-");
    CHECK(side("a*b/c*d").children.size() == 4);
    CHECK(side("(a + b) - c") == side("a + b - c"));
    CHECK(side("(a/b)*c") == side("a/b*c"));
    CHECK(side("a - (b + c)") != side("a - b + c"));
    CHECK(side("a/(b*c)") != side("a/b*c"));
    std::string sum = "1";
    for (int i = 1; i < 50'000; ++i) sum += "+1";
    CHECK(side(sum).children.size() == 50'000);
}

TEST_CASE("the canonical form") {
    CHECK(canonical("claim  a+b*c - (d-e)/ -f^2==(a^b)^c") == "claim a + b*c - (d - e)/-f^2 == (a^b)^c\n");
    CHECK(canonical("claim b[t_1 .. t_n,delta { k } ; <u , v>,t_{i+1}] == D(b,1)(t)+b''(t) + D(b,3)(t)") ==
          "claim b[t_1..t_n, delta{k}; <u, v>, t_{i+1}] == b'(t) + b''(t) + D(b, 3)(t)\n");
    CHECK(canonical("claim q[t_i:i in 1..n,i!=k,i not in S,s] == t_{1}+t_{a,b}") ==
          "claim q[t_i : i in 1..n, i != k, i not in S, s] == t_1 + t_{a,b}\n");
    CHECK(canonical(
              "# head\ntheorem x \"title\"   # why\n\nfor n in 1 .. 3\n  map f,g degrees m , n\n# before\n"
              "given f(s,t) == 0 for i in 0..k for all s,t_1..t_n\n\n\ntheorem y\nclaim 1==1\n# end") ==
          "# head\ntheorem x \"title\"  # why\nfor n in 1..3\nmap f, g degrees m, n\n# before\n"
          "given f(s, t) == 0 for i in 0..k for all s, t_1..t_n\n\ntheorem y\nclaim 1 == 1\n# end\n");
    CHECK(canonical("point r,s in 2\nvector d in 2\nraise p to n+1 as q\npoly P(t) degree n=(t-a)^n\nlet "
                    "a_{0,i}=c_i\n"
                    "assume a!=b\nmap q degree 3 on simplex 2") ==
          "point r, s in 2\nvector d in 2\nraise p to n + 1 as q\npoly P(t) degree n = (t - a)^n\n"
          "let a_{0,i} = c_i\nassume a != b\nmap q degree 3 on simplex 2\n");
}

TEST_CASE("a line goes on within brackets and behind an operator") {
    CHECK(canonical("claim (a\n + b) ==\n c *\n d\nclaim 1 == 1") == "claim a + b == c*d\nclaim 1 == 1\n");
}
