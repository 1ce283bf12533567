#include "decided.hpp"

// The verdict on a line whose cases have different results.

using proofs::Expectation;
using proofs::Verdict;

TEST_CASE("a claim is proved when it is proved in every case") {
    const auto mixed = decided("for n in 1..4\nclaim (n - 2)*(n - 3) == 0");
    CHECK(by_case(mixed.at(0)) == "rppr");
    CHECK(mixed[0].verdict() == Verdict::refuted);
    CHECK_FALSE(mixed[0].as_expected());
    CHECK(mixed[0].counterexample()->parameters == proofs::Parameters{{"n", 1}});
    CHECK(mixed[0].cases.at(1).parameters == proofs::Parameters{{"n", 2}});
    CHECK(decided("for n in 2..3\nclaim (n - 2)*(n - 3) == 0").at(0).as_expected());
    CHECK(by_case(decided("for n in 1..2\nclaim i == n for i in 1..n").at(0)) == "prp");
}

TEST_CASE("refute wants a refutation in every case, refute some in one") {
    const auto of = [](const std::string& line) { return decided("for n in 1..3\n" + line).at(0); };
    CHECK(of("refute n == 2").expectation == Expectation::refutation);
    CHECK(by_case(of("refute n == 2")) == "rpr");
    CHECK(of("refute n == 2").verdict() == Verdict::refuted);
    CHECK_FALSE(of("refute n == 2").as_expected());
    CHECK(of("refute n == 4").as_expected());
    CHECK_FALSE(of("refute n == n").as_expected());
    CHECK(of("refute some n == 2").expectation == Expectation::some_refutation);
    CHECK(of("refute some n == 2").as_expected());
    CHECK(of("refute some n == 4").as_expected());
    CHECK_FALSE(of("refute some n == n").as_expected());
    CHECK_FALSE(of("refute n*x == 0 for x in 0..0").as_expected());
    CHECK(by_case(of("refute some i == n for i in 1..n")) == "prprrp");
}

TEST_CASE("what cannot be decided in one case leaves the others") {
    Limits small;
    small.expansion_terms = 1000;
    const auto decisions =
        decided("for n in 1..3\nclaim (a + b + c + d)^(10*n) == (d + c + b + a)^(10*n)", small);
    CHECK(by_case(decisions.at(0)) == "puu");
    CHECK(decisions[0].verdict() == Verdict::undecided);
    CHECK(decisions[0].error()->message().find("expansion_terms") != std::string::npos);
    const auto worse = decided("for n in 1..3\nclaim (a + b + c + d)^(10*n) == 1", small);
    CHECK(by_case(worse.at(0)) == "ruu");
    CHECK(worse[0].verdict() == Verdict::refuted);
    CHECK(verdicts("for n in 1..3\nclaim (a + b + c + d)^(10*n) == 1", small) == "refuted");
    // An error in one case: a blossom with the wrong number of arguments.
    const auto arity = decided("for n in 1..3\nmap b degree n\nclaim b[s, t] == b[t, s]");
    CHECK(by_case(arity.at(0)) == "upu");
    CHECK(arity[0].error()->code() == ErrorCode::wrong_arity);
    const auto refuted = decided("for n in 1..3\nmap b degree n\nrefute b[s, t] == 1");
    CHECK(by_case(refuted.at(0)) == "uru");
    CHECK_FALSE(refuted[0].as_expected());
}

TEST_CASE("an error in one claim leaves the other lines of the block") {
    CHECK(by_case(decided("claim delta == 1\nclaim 1 == 1").at(1)) == "p");
    CHECK(by_case(decided("claim delta == 1\nclaim 1 == 1").at(0)) == "u");
    CHECK(by_case(decided("claim 1 == 1\nclaim f(x) == 1\nrefute 1 == 2").at(2)) == "r");
    // An error in a declaration is an error of every line.
    for (const auto& decision : decided("let x = delta*delta\nclaim 1 == 1\nclaim 2 == 2"))
        CHECK(by_case(decision) == "u");
}

TEST_CASE("long sums and products are decided, and long quotients refused") {
    const auto repeated = [](std::size_t count, const std::string& first, const std::string& next) {
        std::string text = "claim " + first;
        for (std::size_t i = 1; i < count; ++i) text += next;
        return text;
    };
    CHECK(verdicts(repeated(50'000, "1", "+1") + " == 50000") == "proved");
    CHECK(verdicts(repeated(50'000, "1", "+1") + " == 50001") == "refuted");
    CHECK(verdicts(repeated(50'000, "x", "-x") + " == -49998*x") == "proved");
    CHECK(verdicts(repeated(5'000, "x", "*x") + " == x^5000") == "proved");
    CHECK(verdicts(repeated(900, "x", "/y") + " == x/y^899") == "proved");
    CHECK(verdicts(repeated(50'000, "x", "/y") + " == 1").find("the depth of the expression") !=
          std::string::npos);
}

TEST_CASE("numbers and marks are read as people write them") {
    for (const char* claim : {"(x+1)² == x^2 + 2*x + 1", "x**2 == x^2", "3·x == 3 × x", "½*x == x/2",
                              "x \u2212 y == -(y \u2212 x)", ".5*x + 0.*y == x/2", "1½*x == 3*x\u20442",
                              "x¹² == (x³)⁴", "x⁻¹ == 1/x", "2.*x == 2*x", "x⁺² == x²"}) {
        CAPTURE(claim);
        CHECK(verdicts(std::string("claim ") + claim).starts_with("proved"));
    }
    CHECK(verdicts("claim x² == x").starts_with("refuted"));
    CHECK(verdicts("claim ½ == 1/3").starts_with("refuted"));
    CHECK(verdicts("for n in 1..3\nclaim x**n == x^n").find("refuted") == std::string::npos);
}

TEST_CASE("numbers before a point are one point with their sum as coordinate") {
    const std::string lines = "map b degree 1\npoint P, Q in 1\n";
    CHECK(verdicts(lines + "claim b(1 + 2 + P - Q) == b(3 + P - Q)") == "proved");
    CHECK(verdicts(lines + "claim b(x - y + P - 5) == b((x - y) + P - 5)") == "proved");
    CHECK(verdicts(lines + "claim b(P - Q + 2) == b(2 + (P - Q))") == "proved");
    CHECK(verdicts(lines + "claim b(2*x/3*P*y/2*3) == x*y*b(P)") == "proved");
    CHECK(verdicts(lines + "claim b(P/2/3*6) == b(P)") == "proved");
}

TEST_CASE("a limit of time ends one case, not the others") {
    const auto document =
        proofs::parse("for n in 0..1\nclaim sum(i, 1, 1000000*n, (a + b + c + i*d)^10) == 0");
    REQUIRE(document.errors.empty());
    Limits limits;
    limits.expansion_terms = 100'000'000;
    limits.expansion_work = 100'000'000'000;
    limits.numbers = 100'000'000;
    limits.timeout = 1;
    const auto decisions = proofs::decide(document.blocks.at(0), limits);
    CHECK(by_case(decisions.at(0)) == "pu");
    CHECK(decisions[0].cases.at(1).error->message().find("the limit timeout") != std::string::npos);
}

TEST_CASE("a line without a case is undecided") {
    CHECK(complaint("for n in 3..2\nclaim 1 == 1").ends_with("there is no case to decide: a range is empty"));
    CHECK(complaint("claim 1 == 1 for i in 2..1").ends_with("there is no case to decide: a range is empty"));
    CHECK_FALSE(decided("refute 1 == 2 for i in 2..1").at(0).as_expected());
    CHECK(verdicts("given 1 == 2\nclaim 1 == 1").find("contradict") != std::string::npos);
    CHECK(verdicts("given 1 == 2\nrefute 1 == 2").find("contradict") != std::string::npos);
    CHECK(verdicts("given a == 1 for i in 1..0\nclaim a == 1") == "refuted");
    CHECK(verdicts("given a_i == i for i in 1..2\nclaim a_1 + a_2 == 3\nclaim a_3 == 3") == "proved refuted");
}

TEST_CASE("a line with a hypothesis for each case takes those of its own parameters") {
    CHECK(by_case(decided("for n in 1..2\ngiven a == n\nclaim a == 1").at(0)) == "pr");
    CHECK(by_case(decided("for n in 0..2\nassume n*a != 0\nclaim 1 == 1").at(0)) == "upp");
    CHECK(by_case(decided("for n in 0..2\nclaim 1/n == 1").at(0)) == "upr");
}
