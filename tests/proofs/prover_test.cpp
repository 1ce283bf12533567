#include "decided.hpp"

TEST_CASE("fj-eq20 for n = 1..8, with symbolic arguments and an arbitrary polynomial") {
    CHECK(verdicts("for n in 1..8\nmap b degree n\n"
                   "claim b[t_1..t_n] == sum(N, 1, n, (-1)^(n-N) * N^n * "
                   "sum(S, subsets(n, N), b(mean(i, S, t_i)))) / factorial(n)") == "proved");
}

TEST_CASE("goldman-thm9 for n = 1..10 and every order") {
    const auto decisions = decided(
        "for n in 1..10\nfor k in 0..n\nmap p degree n\n"
        "claim D(p, k)(t) == factorial(n)/factorial(n-k) * p[t{n-k}, delta{k}]");
    REQUIRE(decisions.size() == 1);
    CHECK(decisions[0].verdict() == proofs::Verdict::proved);
    CHECK(decisions[0].cases.size() == 65);
}

TEST_CASE("blog-derivative: the misprint is refuted by the least case, the correction proved") {
    const auto decisions = decided(
        "for n in 1..4\nmap a degree n\n"
        "refute a'(t) == n * a[t{n-1}, 1]\nclaim a'(t) == n * a[t{n-1}, delta]");
    REQUIRE(decisions.size() == 2);
    CHECK(decisions[0].verdict() == proofs::Verdict::refuted);
    REQUIRE(decisions[0].counterexample());
    const proofs::Counterexample& witness = *decisions[0].counterexample();
    CHECK(witness.parameters == std::vector<std::pair<std::string, long long>>{{"n", 1}});
    REQUIRE(witness.maps.size() == 1);
    CHECK(witness.maps[0].text == "1");
    CHECK(witness.left == "0");
    CHECK(witness.right == "1");
    CHECK(decisions[1].verdict() == proofs::Verdict::proved);
}

TEST_CASE("denominators are conditions, and a claim that fails only there is not refuted") {
    const auto decisions =
        decided("map p degree 2\nclaim p[s, u] == (b-u)/(b-a)*p[s, a] + (u-a)/(b-a)*p[s, b]");
    REQUIRE(decisions.size() == 1);
    CHECK(decisions[0].verdict() == proofs::Verdict::proved);
    CHECK(conditions(decisions[0]) == "b != a");
    CHECK(verdicts("claim x/x == 1") == "proved");
    CHECK(verdicts("claim (x^2 - y^2)/(x - y) == x + y") == "proved");
    const auto powers = decided("claim 1/(x^2*(x-y)^3*(1 + x^2)) == 0");
    CHECK(conditions(powers[0]) == "x != 0, x != y, 1 + x^2 != 0");
    CHECK(verdicts("claim 1/(x - x) == 1").find("the denominator is zero") != std::string::npos);
}

TEST_CASE("hypotheses are solved for the coefficients of maps") {
    CHECK(verdicts("map f degree 2\ngiven f[0,0] == v_0\ngiven f[0,1] == v_1\ngiven f[1,1] == v_2\n"
                   "claim f(t) == (1-t)^2*v_0 + 2*t*(1-t)*v_1 + t^2*v_2\n"
                   "claim f(t) == (1-t)^2*v_0 + 2*t*(1-t)*v_1 + t^2*v_1") == "proved refuted");
    CHECK(verdicts("for n in 1..4\nfor k in 0..n\nmap f, g degree n\n"
                   "given D(f, i)(s) == D(g, i)(s) for i in 0..k\n"
                   "claim f[x_1..x_k, s{n-k}] == g[x_1..x_k, s{n-k}]") == "proved");
    CHECK(verdicts("for n in 1..4\nfor k in 0..n\nmap f, g degree n\n"
                   "given f[x_1..x_k, s{n-k}] == g[x_1..x_k, s{n-k}] for all x_1..x_k\n"
                   "claim D(f, i)(s) == D(g, i)(s) for i in 0..k") == "proved");
    CHECK(verdicts("given a + b + c == 1\nclaim (a + b)^2 == (1 - c)^2\nclaim a == b") == "proved refuted");
    CHECK(verdicts("given 1 == 2\nclaim a == a").find("contradict") != std::string::npos);
    CHECK(verdicts("given a^2 == 2\nclaim a == a\nclaim a^4 == 4\nclaim a == 1") == "proved proved refuted");
    CHECK(verdicts("given x^2*y^2 + x*y^3 + x^3*y == 1\nclaim x == x").find("linear neither") !=
          std::string::npos);
}

TEST_CASE("side conditions") {
    CHECK(verdicts("assume a != b\nclaim a == b") == "refuted");
    CHECK(verdicts("assume a + b != b + a\nclaim a == b").find("can never hold") != std::string::npos);
    const auto decisions = decided("assume a != 0\nassume a != 1\nassume a != -1\nclaim a == 0");
    REQUIRE(decisions[0].counterexample());
    CHECK(decisions[0].counterexample()->left == "2");
}

TEST_CASE("tensor products, simplices, raised and particular maps, abbreviations") {
    CHECK(verdicts("map f degrees 2, 1\nclaim f(u, v) == f[u, u; v]\nclaim f[0, 1; v] == f[1, 0; v]\n"
                   "claim f[0, 1; v] == f[0, 0; v]") == "proved proved refuted");
    CHECK(verdicts("map q degree 2 on simplex 2\npoint r, s, t in 2\nlet a_3 = 1 - a_1 - a_2\n"
                   "let u = a_1*r + a_2*s + a_3*t\n"
                   "claim q[u, u] == a_1*q[r, u] + a_2*q[s, u] + a_3*q[t, u]\nclaim q(r) == q[r, r]\n"
                   "claim q[r, s] == q(r)") == "proved proved refuted");
    CHECK(verdicts("map p degree 2\nraise p to 3 as q\nclaim q[a,b,c] == (p[a,b] + p[a,c] + p[b,c])/3\n"
                   "claim q(t) == p(t)") == "proved proved");
    CHECK(verdicts("for n in 0..6\npoly P(t) degree n = (t - a)^n\n"
                   "claim P[u_1..u_n] == prod(i, 1, n, u_i - a)") == "proved");
    CHECK(verdicts("for n in 1..5\nmap p degree n\nlet v_{0,j} = p[0{n-j}, 1{j}]\n"
                   "let v_{i,j} = (1 - u_i)*v_{i-1,j} + u_i*v_{i-1,j+1}\nclaim v_{n,0} == p[u_1..u_n]") ==
          "proved");
    CHECK(verdicts("poly b(t) degree 1 = b_0 + b_1*t\nlet b_2 = b_0 + b_1\nclaim b(1) == b_2") == "proved");
    CHECK(verdicts("map p degree 3\nclaim p(<t, w>) == w^3*p(t/w)") == "proved");
}

TEST_CASE("an error in a statement has its place") {
    const auto message = [](const std::string& text) {
        const auto decisions = decided(text);
        REQUIRE(decisions.size() == 1);
        REQUIRE(decisions[0].error());
        return std::to_string(*decisions[0].error()->offset()) + " " + decisions[0].error()->message();
    };
    CHECK(message("claim c(t) == 1").starts_with("6 there is no map or function \"c\""));
    CHECK(message("map b degree 2\nclaim b[s] == 1") == "21 the blossom of b takes 2 arguments, found 1");
    CHECK(message("map b degree 2\nclaim b == 1").starts_with("21 \"b\" is a map"));
    CHECK(message("map b degree n\nclaim 1 == 1").starts_with("13 an expression with variables found"));
    CHECK(message("claim delta == 1") == "6 a vector of dimension 1 found, expected a number");
    CHECK(message("let x = x\nclaim x == 1") == "8 the abbreviation x refers to itself");
    CHECK(message("for n in 3..2\nclaim 1 == 1").ends_with("a range is empty"));
}

TEST_CASE("a claim for no case at all is not proved") {
    CHECK(verdicts("given a == b\nclaim (a - b)/(a - b) == 1").find("leave no case") != std::string::npos);
    CHECK(verdicts("assume a != b\ngiven a == b\nclaim a == b").find("leave no case") != std::string::npos);
    const auto decisions = decided("given x/(a - b) == 1\nclaim x == a - b");
    CHECK(decisions[0].verdict() == proofs::Verdict::proved);
    CHECK(conditions(decisions[0]) == "a != b");
}

TEST_CASE("what would take too long or too much is refused before it does") {
    Limits small;
    small.expansion_work = 1'000'000;
    small.expansion_terms = 10'000;
    const auto is_refused = [&](const std::string& text) {
        return verdicts(text, small).find("exceeds the limit") != std::string::npos;
    };
    CHECK(is_refused("for n in 1..1000000000000\nclaim 1 == 1"));
    CHECK(is_refused("claim 1 == 1 for i in 1..1000000000000"));
    CHECK(is_refused("claim sum(i, 1, 1000000000000, 1) == 1"));
    CHECK(is_refused("claim sum(i, 1, 10000, sum(j, 1, 10000, 1)) == 1"));
    CHECK(is_refused("claim sum(S, subsets(100, 50), 1) == 1"));
    CHECK(is_refused("claim (a + b + c + d)^1000 == 1"));
    CHECK(is_refused("claim factorial(1000000) == 1"));
    CHECK(is_refused("claim 2^100000000 == 1"));
    CHECK(is_refused("map b degree 1000\nclaim b(t) == 1"));
    CHECK(is_refused("map b degree 40\nclaim b[t_1..t_40] == 1"));
    CHECK(is_refused("let x_i = x_{i+1}\nclaim x_1 == 1"));
    CHECK(verdicts("claim t_{10000000000000000000} == 1").find("expected an integer") != std::string::npos);
}
