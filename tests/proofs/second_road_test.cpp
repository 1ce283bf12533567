#include "certificates/points/point_comparison.hpp"
#include "decided.hpp"

// The second road alone: it reads the text again, and contradicts false statements about it.

using proofs::second::Case;
using proofs::second::Comparison;
using proofs::second::Reading;

namespace {

using Values = std::vector<std::pair<std::string, Rational>>;

const char* name_of(const Comparison& compared) {
    const char* names[] = {"agree", "differ", "no point"};
    return names[static_cast<std::size_t>(compared.result)];
}

/// The result of comparing the sides of the first case.
std::string compared(const std::string& text, const std::vector<proofs::second::Step>& hint = {}) {
    const Reading reading(text);
    return name_of(proofs::second::compare(reading, reading.cases().at(0), hint, 2, 7));
}

std::string confirmed(const std::string& text, const Values& values,
                      const std::vector<std::string>& algebraic = {}) {
    const Reading reading(text);
    return name_of(proofs::second::confirm(reading, reading.cases().at(0), values, algebraic, {}));
}

std::vector<std::string> false_claims() {
    return {
        "claim x == y\n",
        "claim (x + y)^2 == x^2 + y^2\n",
        "map b degree 2\nclaim b[s, t] == (b(s) + b(t))/2\n",
        "map a degree 2\nclaim a'(t) == 2*a[t, 1]\n",
        "map f degrees 2, 1\nclaim f[0, 1; v] == f[0, 0; v]\n",
        "map q degree 2 on simplex 2\npoint r, s in 2\nclaim q[r, s] == q(r)\n",
        "map p degree 2\nclaim p[s, sum(i, 1, 0, <x_i, y_i>)] == p[s, 0]\n",
        "map p degree 2 net c over a, b\nclaim p[a, b] == c_0\n",
        "poly P(t) degree 2 = t^2\nclaim P(x) == x\n",
        "map p degree 2\nraise p to 3 as q\nclaim q[a, b, c] == p[a, b]\n",
        "let w = t\npoly R(t) degree 2 = w\nclaim R[x, y] == 0\n",
        "claim determinant(i, j, 2, a_{i,j}) == a_{1,1}*a_{2,2}\n",
        "claim bspline(3, 1, x, 3, t) == 1\n",
        "claim D(t^3, t) == 2*t^2\n",
        "given w^2 == 1/2\nclaim w^3 == w\n",
        "given x^2 == x\nclaim x == 0\n",
        "map f degree 1\ngiven f(x) == x for all x\nclaim f(2) == 3\n",
    };
}

}  // namespace

TEST_CASE("evaluation at points contradicts false claims") {
    for (const std::string& text : false_claims()) {
        INFO(text);
        CHECK(compared(text) == "differ");
    }
}

TEST_CASE("evaluation at points agrees with true claims") {
    for (const std::string& text : {
             std::string("map b degree 2\nclaim b[s, t] == (4*b((s + t)/2) - b(s) - b(t))/2\n"),
             std::string("given w^2 == 1/2\nclaim w^4 == 1/4\n"),
             std::string("given w^2 == -1\nclaim (a + w*b)*(a - w*b) == a^2 + b^2\n"),
             std::string("given c^2 + s^2 == 1\nclaim (c^2 - s^2)^2 + (2*c*s)^2 == 1\n"),
             std::string("given x^2 == x\ngiven x*y == 1\nclaim x == 1\n"),
             std::string("map f degree 1\ngiven f(x) == x for all x\nclaim f(2) == 2\n"),
             std::string("assume a != b\nclaim (a - b)/(a - b) == 1\n"),
         }) {
        INFO(text);
        CHECK(compared(text) == "agree");
    }
    CHECK(compared("given a == b\nclaim (a - b)/(a - b) == 1\n") == "no point");
    CHECK(compared("given 1 == 2\nclaim 1 == 1\n") == "no point");
    CHECK(compared("assume a != b\ngiven a == b\nclaim 1 == 1\n") == "no point");
}

TEST_CASE("a hint that is a lie changes nothing") {
    const std::string text = "given a == 2*b\nclaim a == 2*b\n";
    CHECK(compared(text, {{"a", 1, {{1, {{"a", 1}}}, {-2, {{"b", 1}}}}}}) == "agree");
    CHECK(compared(text, {{"b", 1, {{1, {{"b", 1}}}, {-7, {{"c", 1}}}}}, {"d", 3, {}}}) == "agree");
    const std::vector<proofs::second::Step> zeros{{"a", 1, {{1, {{"a", 1}}}}}, {"b", 1, {{1, {{"b", 1}}}}}};
    CHECK(compared("given a == 2*b\nclaim a == b\n", zeros) == "differ");
    CHECK(compared("claim a == b\n", zeros) == "differ");
}

TEST_CASE("the steps of a tower lead to a point that no single hypothesis gives") {
    const std::string text = "given x^3 == y\ngiven y^2 == 2\n";
    const std::vector<proofs::second::Step> steps{{"y", 1, {{1, {{"y", 1}}}, {-1, {{"x", 3}}}}},
                                                  {"x", 6, {{1, {{"x", 6}}}, {-2, {}}}}};
    CHECK(compared(text + "claim x^6 == 2\n", steps) == "agree");
    CHECK(compared(text + "claim x^6 == 3\n", steps) == "differ");
    // Each depends on the other.
    const std::vector<proofs::second::Step> around{{"x", 1, {{1, {{"x", 1}}}, {-1, {{"y", 1}}}}},
                                                   {"y", 1, {{1, {{"y", 1}}}, {-1, {{"x", 1}}}}}};
    CHECK(compared(text + "claim x^6 == 2\n", around) == "no point");
    // The steps lead to a point where the second hypothesis does not hold.
    const std::vector<proofs::second::Step> elsewhere{{"y", 1, {{1, {{"y", 1}}}, {-1, {{"x", 3}}}}},
                                                      {"x", 6, {{1, {{"x", 6}}}, {-3, {}}}}};
    CHECK(compared(text + "claim x^6 == 3\n", elsewhere) == "no point");
    CHECK(compared("assume a != b\n" + text + "claim x^6 == 2\n", steps) == "agree");
    CHECK(compared("assume y^2 != 2\n" + text + "claim x^6 == 2\n", steps) == "no point");
}

TEST_CASE("a counterexample that is none is told") {
    CHECK(confirmed("claim x == y\n", {{"x", 1}, {"y", 2}}) == "differ");
    CHECK(confirmed("claim x == y\n", {{"x", 1}, {"y", 1}}) == "agree");
    CHECK(confirmed("claim (x + y)^2 == x^2 + y^2\n", {{"x", 0}, {"y", 5}}) == "agree");
    CHECK(confirmed("claim (x + y)^2 == x^2 + y^2\n", {{"x", 1}, {"y", 1}}) == "differ");
    CHECK(confirmed("map b degree 1\nclaim b(t) == b(0)\n", {{"b.0", 1}, {"b.1", 1}, {"t", 1}}) == "differ");
    CHECK(confirmed("map b degree 1\nclaim b(t) == b(0)\n", {{"b.0", 1}, {"b.1", 0}, {"t", 1}}) == "agree");
    // An assumption, a hypothesis or a divisor does not hold there.
    CHECK(confirmed("assume x != 1\nclaim x == y\n", {{"x", 1}, {"y", 2}}) != "differ");
    CHECK(confirmed("given x == 0\nclaim x == y\n", {{"x", 1}, {"y", 2}}) != "differ");
    CHECK(confirmed("given x^2 == y\nclaim x == y\n", {{"x", 2}, {"y", 4}}) == "differ");
    CHECK(confirmed("claim x/(x - 1) == y\n", {{"x", 1}, {"y", 2}}) != "differ");
    CHECK(confirmed("claim (1/x)^0 == 2\n", {{"x", 0}}) != "differ");
    CHECK(confirmed("claim (1/x)^0 == 2\n", {{"x", 1}}) == "differ");
    // A number is missing.
    CHECK(confirmed("claim x == y\n", {{"x", 1}}) != "differ");
}

TEST_CASE("a counterexample at roots of hypotheses is held against them") {
    const std::string root = "given w^2 == 1/2\n";
    CHECK(confirmed(root + "claim w == 1\n", {}, {"w"}) == "differ");
    CHECK(confirmed(root + "claim w^2 == 1/2\n", {}, {"w"}) != "differ");
    CHECK(confirmed(root + "claim w == x\n", {{"x", 3}}, {"w"}) == "differ");
    CHECK(confirmed(root + "claim w == 1\n", {{"w", 1}}) != "differ");
    CHECK(confirmed(root + "claim 1/(w^2 - 1/2) == 1\n", {}, {"w"}) != "differ");
}

TEST_CASE("cases are listed as the ranges say, and no others") {
    const Reading reading("for n in 0..2\nclaim 1 == 1 for i in 1..n\nrefute 1 == 2\n");
    const std::vector<Case> cases = reading.cases();
    CHECK(cases.size() == 6);
    std::size_t of_claim = 0;
    for (const Case& which : cases) of_claim += which.line == 0 ? 1 : 0;
    CHECK(of_claim == 3);
    CHECK_THROWS_AS(Reading("claim 1 ==\n"), Error);
    CHECK_THROWS_AS(Reading("strict\nclaim x == x\n"), Error);
    CHECK_THROWS_AS(Reading("point p in 2\nvector p in 2\nclaim 1 == 1\n"), Error);
    CHECK_THROWS_AS(Reading("claim delta == 1\n"), Error);
    CHECK_THROWS_AS(Reading("claim f(x) == 1\n"), Error);
    CHECK_THROWS_AS(
        Reading(std::string("claim ") + std::string(5000, '(') + "1" + std::string(5000, ')') + " == 1\n"),
        Error);
}
