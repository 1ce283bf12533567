#include <blossom/proofs/doubtful_names.hpp>
#include "decided.hpp"

// The meaning of a name, depending on the line in which it occurs.

namespace {

std::string warnings(const std::string& text) {
    std::string result;
    for (const proofs::Block& block : proofs::parse(text).blocks) {
        for (const proofs::Warning& warning : proofs::doubtful_names(block)) {
            const proofs::LineAndColumn place = proofs::line_and_column(text, warning.offset);
            result += std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
                      warning.message + "\n";
        }
    }
    return result;
}

}  // namespace

TEST_CASE("no name is declared twice, whatever the two declarations are") {
    const std::string declarations[] = {"for x in 1..2",
                                        "map x degree 2",
                                        "map x degree 1 on simplex 2",
                                        "point x in 2",
                                        "vector x in 2",
                                        "frame x, y, z in 2",
                                        "number x",
                                        "poly x(t) degree 1 = t",
                                        "raise m to 3 as x",
                                        "let x = 1",
                                        "map x degree 1 net c over 0, 1"};
    for (const std::string& first : declarations) {
        for (const std::string& second : declarations) {
            std::string other = second;
            // Avoids the other names of a frame, which are not tested here.
            if (second.starts_with("frame") && first.starts_with("frame")) other = "frame x, v, w in 2";
            const std::string text = "map m degree 2\n" + first + "\n" + other + "\nclaim 1 == 1";
            INFO(text);
            const std::string found = complaint(text);
            CHECK(found.starts_with("3:"));
            CHECK(found.ends_with("\"x\" is declared already"));
        }
    }
    for (const std::string word : {"delta", "sum", "binomial", "if"}) {
        for (const std::string& line :
             {"number " + word, "let " + word + " = 1", "for " + word + " in 1..2"}) {
            const auto document = proofs::parse(line + "\nclaim 1 == 1");
            INFO(line);
            if (document.errors.empty())
                CHECK(complaint(line + "\nclaim 1 == 1").find("word of the language") != std::string::npos);
        }
    }
}

TEST_CASE("a family has nothing to do with a map, a parameter or an abbreviation of its name") {
    CHECK(verdicts("map b degree 1\nclaim b_1*x == x*b_1\nclaim b_1 == b(1)") == "proved refuted");
    CHECK(verdicts("let a = 3\nclaim a_1 == a_1\nclaim a_1 == 3") == "proved refuted");
    CHECK(verdicts("for n in 2..2\nclaim x^n == x*x\nclaim n_1 == 2") == "proved refuted");
    CHECK(complaint("strict\nfor n in 1..2\nclaim n_1 == n_1").find("\"n\"_i is not declared") !=
          std::string::npos);
    CHECK(complaint("strict\nlet a = 3\nclaim a_1 == a_1").find("\"a\"_i is not declared") !=
          std::string::npos);
}

TEST_CASE("members of families are declared once, of one kind and dimension") {
    CHECK(complaint("point u_1 in 2\nvector u_2 in 2\nclaim 1 == 1") ==
          "2:8 the members of u_i are declared already, as something else");
    CHECK(complaint("point u_1 in 2\npoint u_2 in 3\nclaim 1 == 1").starts_with("2:7 "));
    CHECK(complaint("number u_1\nnumber u_1\nclaim 1 == 1") ==
          "2:8 \"u\" with these indices is declared already");
    CHECK(complaint("let u_i = 1\nlet u_j = 2\nclaim 1 == 1") ==
          "2:5 \"u\" with these indices is declared already");
    CHECK(
        verdicts("point u_1 in 2\npoint u_2 in 2\nlet w_i = 2\nlet w_{i,j} = 3\nclaim w_5 + w_{1,1} == 5") ==
        "proved");
    CHECK(verdicts("number u, v_1\npoint v in 2\nmap q degree 1 on simplex 2\nclaim q(v) + v_1 + u_3 == u_3 "
                   "+ v_1 + q(v)") == "proved");
}

TEST_CASE("clauses: the first that fits counts, a name stands for any integer, a parameter for its value") {
    CHECK(verdicts("let w_0 = 10\nlet w_i = i\nclaim w_0 == 10\nclaim w_3 == 3\nclaim w_{-2} == -2") ==
          "proved proved proved");
    CHECK(verdicts("let w_i = i\nlet w_0 = 10\nclaim w_0 == 0") == "proved");
    CHECK(by_case(decided("for n in 1..3\nlet w_n = 1\nlet w_i = 0\nclaim w_2 == 1").at(0)) == "rpr");
    for (const std::string value : {"1", "x"}) {
        CHECK(complaint("for n in 1..1\nlet w_n = " + value + "\nclaim w_2 == 0")
                  .ends_with("no line \"let\" fits w_2; n is a parameter of the block there, and stands for "
                             "its value"));
    }
    CHECK(verdicts("let b_2 = x\nclaim b_2 == x\nclaim b_3 == x") == "proved refuted");
    CHECK(verdicts("let v_{0,l} = v_l\nclaim v_{0,3} == v_3\nclaim v_3 == 0") == "proved refuted");
    CHECK(
        complaint("let v_{0,l} = v_l\nclaim v_{1,3} == v_3").starts_with("2:7 no line \"let\" fits v_{1,3}"));
    CHECK(complaint("let v_{0,l} = x*l\nclaim v_{1,3} == x").starts_with("2:7 no line \"let\" fits v_{1,3}"));
    CHECK(complaint("strict\nnumber x\nlet b_2 = x\nclaim b_3 == x")
              .starts_with("4:7 \"b\"_i is not declared"));
    CHECK(verdicts("number w_{1,1}..w_{1,9}\nlet w_{i,i} = i\nclaim w_{2,2} == 2\nclaim w_{2,3} == 3") ==
          "proved refuted");
    CHECK(verdicts("let w_{i,i} = 1\nlet w_{i,j} = 0\nclaim w_{2,2} == 1\nclaim w_{2,3} == 0") ==
          "proved proved");
    CHECK(complaint("let w_{i,i} = 1\nlet w_{j,j} = 0\nclaim w_{2,2} == 1").starts_with("2:5 "));
    CHECK(complaint("let w_{i,j} = 1\nlet w_{k,l} = 0\nclaim w_{2,2} == 1").starts_with("2:5 "));
    CHECK(complaint("let w_{i,i} = i\nclaim w_{2,3} == 3").starts_with("2:7 no line \"let\" fits w_{2,3}"));
    CHECK(verdicts("let b_2 = 3\nclaim b_2 + b_1 == b_1 + 3\nclaim b_1 == 3") == "proved refuted");
    CHECK(complaint("let b_2 = delta\nmap f degree 1\nclaim f[b_3] == 0")
              .starts_with("3:9 no line \"let\" fits b_3"));
    CHECK(verdicts("let k_1 = 2\nclaim x^k_1 == x*x") == "proved");
    CHECK(complaint("let k_1 = 2\nclaim x^k_2 == x*x").starts_with("2:9 an expression with variables found"));
    CHECK(verdicts("number w_0..w_4\nlet w_2 = 5\nclaim w_2 == 5\nclaim w_1 == w_1\nclaim w_1 == 5") ==
          "proved proved refuted");
}

TEST_CASE("a member of a family is an integer where its clause says so, and a number where no clause fits") {
    const std::string family = "let k_1 = 2\n";
    const std::string integers =
        "claim x^k_{2-1} == x*x\nclaim x^(2*k_{2-1} - 1) == x^3\nclaim binomial(4, k_{2-1}) == 6\n"
        "map f degree 2\nclaim D(f, k_{2-1})(0) == D(f, 2)(0)\n";
    for (const std::string declared : {"", "number k\n", "number k_0..k_3\n"}) {
        INFO(declared);
        CHECK(verdicts(declared + family + integers) == "proved proved proved proved");
        CHECK(verdicts(declared + family + "claim k_{1+1} == k_2\nclaim sum(i, 1, 2, k_i) == 4") ==
              "proved refuted");
        CHECK(complaint(declared + family + "claim x^k_{1+1} == x*x")
                  .starts_with(declared.empty() ? "2:9 an expression with variables found"
                                                : "3:9 an expression with variables found"));
    }
    CHECK(verdicts("let k_1 = 2\nlet k_2 = 3\nclaim sum(i, 1, 2, x^k_i) == x^2 + x^3") == "proved");
    CHECK(verdicts("let k_j = 3\nlet k_{1,1} = 2\nclaim k_{2,2} == 3") == "refuted");
    CHECK(complaint("strict\nlet b_2 = 3\nclaim b_{1+2} == b_{1+2}") ==
          "3:7 b_3 is not declared, and no line \"let\" fits it");
}

TEST_CASE("binders hide the names around them, and nothing beyond their expression") {
    CHECK(verdicts("claim sum(x, 1, 3, x)*x == 6*x") == "proved");
    CHECK(by_case(decided("for n in 1..3\nclaim sum(n, 1, 2, n) + n == 3 + n").at(0)) == "ppp");
    CHECK(verdicts("let w = 5\nclaim sum(w, 1, 3, w) + w == 11") == "proved");
    CHECK(verdicts("let w = x\nclaim sum(x, 1, 3, w) == 3*x") == "proved");
    CHECK(verdicts("let w_i = x_i\nclaim sum(i, 1, 2, w_{3-i}) == x_1 + x_2") == "proved");
    CHECK(verdicts("claim sum(n, 1, 2, sum(n, 1, n, n)) == 4") == "proved");
    CHECK(by_case(decided("for n in 1..2\nclaim n == 5 for n in 5..6").at(0)) == "prpr");
    CHECK(verdicts("map b degree 2\npoint t in 2\nclaim sum(t, 1, 2, b(t)) == b(1) + b(2)") == "proved");
    CHECK(verdicts("map b degree 2\nnumber i\nclaim b[x_i : i in 1..2] == b[x_1, x_2]") == "proved");
}

TEST_CASE("the variable of a poly is its own, and abbreviations in it see it") {
    CHECK(verdicts("poly P(t) degree 1 = t + a\nclaim P(2) + t == 2 + a + t") == "proved");
    CHECK(verdicts("let w = t^2\npoly P(t) degree 2 = w + t\nclaim P(x) == x^2 + x\nclaim w == t^2") ==
          "proved proved");
    CHECK(verdicts("let w = a\npoly P(t) degree 2 = w\nclaim P(x) == a") == "proved");
    CHECK(verdicts("let w_i = t^i\npoly P(t) degree 3 = w_3\nclaim P(x) == x^3\nclaim P(x) == w_3") ==
          "proved refuted");
    CHECK(complaint("let x = 1\npoly P(x) degree 1 = x\nclaim 1 == 1")
              .starts_with("2:1 \"x\" is declared already"));
    CHECK(complaint("poly P(x, x) degree 1 = x\nclaim 1 == 1").starts_with("1:1 \"x\" is declared already"));
    CHECK(complaint("let w = P(1)\npoly P(t) degree 1 = Q(t)\npoly Q(t) degree 1 = t\nclaim w == 1")
              .starts_with("2:"));
    CHECK(complaint("poly P(t) degree 1 = 1/t\nclaim 1 == 1").find("not a polynomial") != std::string::npos);
    CHECK(complaint("poly P(t) degree 1 = t^2\nclaim 1 == 1").find("higher degree") != std::string::npos);
    CHECK(verdicts("poly P(t) degree 1 = (t^2 - 1)/(t - 1)*1\nclaim P(3) == 4") == "proved");
}

TEST_CASE("what an abbreviation was outside of a poly is forgotten in it, and the other way round") {
    CHECK(verdicts("let L = t + 1\nassume L != 0\npoly P(t) degree 1 = L\nclaim P(3) == 4\nclaim L == 4") ==
          "proved refuted");
    CHECK(verdicts(
              "let L = t + 1\npoly P(t) degree 1 = L\nclaim P(3) == 4\nclaim L == t + 1\nclaim P(3) == L") ==
          "proved proved refuted");
}

TEST_CASE("for all binds the names of its line alone, in abbreviations too") {
    CHECK(verdicts("map f degree 1\ngiven f(x) == x for all x\nclaim f(2) == 2\nclaim x == 0") ==
          "proved refuted");
    CHECK(verdicts("map f degree 1\nlet w = x\ngiven f(x) == w for all x\nclaim f(2) == 2") == "proved");
    CHECK(verdicts("map f degree 2\ngiven f[x_1, x_2] == x_1*x_2 for all x_1..x_2\nclaim f(3) == 9") ==
          "proved");
    CHECK(verdicts("given a*x + c == 0 for all x\nclaim a == 0\nclaim c == 0") == "proved proved");
    for (const std::string name : {"n", "f", "w", "r", "delta"}) {
        INFO(name);
        const std::string text =
            "for n in 1..1\nmap f degree 1\nlet w = 1\nframe r, s in 1\ngiven 1 == 1 for all " + name +
            "\nclaim 1 == 1";
        CHECK(complaint(text).find("\"for all\" takes variables") != std::string::npos);
    }
    CHECK(verdicts("given 1 == 1 for all x, x\nclaim 1 == 1").find("twice") != std::string::npos);
}

TEST_CASE("a strict text declares every name, and warns of none") {
    CHECK(complaint("strict\nclaim x == x") == "2:7 \"x\" is not declared; in a strict text every name is");
    CHECK(complaint("strict\nclaim x_1 == x_1") ==
          "2:7 \"x\"_i is not declared; in a strict text every name is");
    CHECK(verdicts("strict\nnumber x\nclaim x == x\nclaim x_7 == x_7") == "proved proved");
    CHECK(verdicts("strict\nnumber x_1..x_3\nclaim x_3 == x_3") == "proved");
    CHECK(complaint("strict\nnumber x_1..x_3\nclaim x_4 == x_4") ==
          "3:7 x_4 is not declared; in a strict text every name is");
    CHECK(verdicts("number x_1..x_3\nclaim x_4 == x_4") == "proved");
    CHECK(verdicts("strict\nmap f degree 1\ngiven f(x) == x for all x\nclaim sum(i, 1, 2, f(i)) == 3") ==
          "proved");
    CHECK(warnings("strict\nclaim x == x") == "");
    CHECK(proofs::parse("claim 1 == 1\nstrict\n").errors.size() == 1);
    CHECK(verdicts("# why\nstrict\ntheorem a\nclaim 1 == 1\ntheorem b\nclaim x == x").find("not declared") !=
          std::string::npos);
}

TEST_CASE("names that occur once, or nearly are others, are warned of") {
    CHECK(warnings("claim x + y == y") ==
          "1:7 \"x\" is not declared and occurs once; it stands for any number\n");
    CHECK(warnings("claim x == x") == "");
    CHECK(warnings("number x\nclaim x == 1") == "");
    CHECK(warnings("number gamma\nclaim gamma + gamme + gamme == 0") ==
          "2:15 \"gamme\" is not declared and therefore stands for any number; did you mean \"gamma\"?\n");
    CHECK(warnings("claim detla + detla == 0").find("did you mean \"delta\"?") != std::string::npos);
    CHECK(warnings("number abc\nclaim abd + abd == 0") == "");
    CHECK(warnings("claim sum(i, 1, 3, i) + t_i + i == 0") ==
          "1:25 \"t\" is not declared and occurs once; it stands for any number\n");
    CHECK(warnings("poly P(t) degree 1 = t\ngiven P(x) == x for all x\nclaim P(1) == 1") == "");
}
