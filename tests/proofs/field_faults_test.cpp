#include "decided.hpp"

// Small statements on which the prover was once wrong, each with a similar statement that is false or true.

namespace {

const std::string chain = "for n in 1..4\nmap f degree n\npoly g(t) degree n = f(2*t/w + 1)\n";
const std::string scopes = "let w = t\npoly P(t) degree 2 = w\npoly R(t) degree 2 = w\n";

}  // namespace

TEST_CASE("true-chain: the chain rule holds where w does not vanish") {
    const auto decisions = decided(chain + "claim g'(t) == 2*f'(2*t/w + 1)/w");
    CHECK(by_case(decisions.at(0)) == "pppp");
    CHECK(conditions(decisions.at(0)) == "w != 0");
}

TEST_CASE("false-chain: without the factor 1/w it is refuted in every case") {
    CHECK(by_case(decided(chain + "claim g'(t) == 2*f'(2*t/w + 1)").at(0)) == "rrrr");
}

TEST_CASE("true-scope: an abbreviation in a poly sees its variable, and R is the identity") {
    CHECK(verdicts(scopes + "claim w == t") == "proved");
    CHECK(verdicts(scopes + "claim R[x, y] == (x + y)/2") == "proved");
    CHECK(verdicts(scopes + "claim w == t\nclaim R[x, y] == (x + y)/2") == "proved proved");
}

TEST_CASE("false-scope: R is not zero, nor t") {
    CHECK(verdicts(scopes + "claim R[x, y] == 0") == "refuted");
    CHECK(verdicts(scopes + "claim R[x, y] == t") == "refuted");
    CHECK(verdicts(scopes + "claim w == t\nclaim R[x, y] == 0") == "proved refuted");
}

TEST_CASE("false-redeclared: p is declared twice") {
    CHECK(complaint("poly L(x, y) degree 1 = 3\nvector p in 2\npoint p in 2\nclaim L(p) == 0") ==
          "3:7 \"p\" is declared already");
    CHECK(verdicts("poly L(x, y) degree 1 = 3\nvector p in 2\nclaim L(p) == 0") == "proved");
    CHECK(verdicts("poly L(x, y) degree 1 = 3\npoint p in 2\nclaim L(p) == 0") == "refuted");
}

TEST_CASE("true-empty: the empty sum of vectors is the vector 0") {
    CHECK(by_case(decided("for n in 0..3\nmap p degree 2\n"
                          "claim p[s, sum(i, 1, n, h_i*delta)] == sum(i, 1, n, h_i)*p[s, delta]")
                      .at(0)) == "pppp");
}

TEST_CASE("false-empty: the empty sum of pairs is no point") {
    CHECK(verdicts("map p degree 2\nclaim p[s, sum(i, 1, 0, <x_i, y_i>)] == p[s, 0]") == "refuted");
    CHECK(verdicts("map p degree 2\nclaim p[s, sum(i, 1, 0, <x_i, y_i>)] == 0") == "proved");
}

TEST_CASE("true-quantified: what vanishes at all points vanishes at one") {
    const std::string lines = "map q degree 2 on simplex 2\npoint r, s in 2\n";
    CHECK(verdicts(lines + "given q(r) == 0 for all r\nclaim q(s) == 0") == "proved");
    CHECK(verdicts(lines + "given q(r) == 0\nclaim q(s) == 0") == "refuted");
}

TEST_CASE("true-subsets: signs over all subsets, the empty one too") {
    const std::string lines =
        "for n in 1..3\nmap f degree n\nclaim factorial(n)*f[<u_i, m_i> : i in 1..n] == ";
    const std::string summand = ", n, sum(S, subsets(n, k), (-1)^(n-k)*f(sum(i, S, <u_i, m_i>))))";
    CHECK(by_case(decided(lines + "sum(k, 0" + summand).at(0)) == "ppp");
    CHECK(by_case(decided(lines + "sum(k, 1" + summand).at(0)) == "ppp");
    CHECK(by_case(decided(lines + "sum(k, 2" + summand).at(0)) == "rrr");
}

TEST_CASE("false-conditions: a power 0 keeps the condition of its base") {
    const auto decisions = decided("claim (1/x)^0 == x/x");
    CHECK(by_case(decisions.at(0)) == "p");
    CHECK(conditions(decisions.at(0)) == "x != 0");
    CHECK(conditions(decided("claim (1/x)^0 == 1").at(0)) == "x != 0");
    CHECK(conditions(decided("claim 0*(1/x) == 0").at(0)) == "x != 0");
}

TEST_CASE("false-hypotheses: a = 0, b = 5") {
    const auto decisions = decided("given a*b == 0\ngiven a == 0\nclaim b == 1");
    CHECK(by_case(decisions.at(0)) == "r");
    const auto& variables = decisions.at(0).counterexample()->variables;
    REQUIRE(variables.size() == 2);
    CHECK(variables[0] == std::pair<std::string, Rational>{"a", 0});
    CHECK(variables[1].second != Rational(1));
    CHECK(verdicts("given a*b == 0\ngiven a == 0\nclaim a == 0") == "proved");
}
