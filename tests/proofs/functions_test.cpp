#include "decided.hpp"

// Sets, partitions, permutations, choices, splines, nets, derivatives of expressions: statements that are
// true by known theorems.

namespace {

/// The verdicts of all cases of the only line.
std::string letters(const std::string& text) { return by_case(decided(text).at(0)); }

}  // namespace

TEST_CASE("subsets of a set") {
    CHECK(letters("for n in 2..4\nclaim sum(S, subsets(n, 2), sum(T, subsets(S, 1), sum(i, T, x_i))) == "
                  "(n - 1)*sum(i, 1, n, x_i)") == "ppp");
    CHECK(letters("for n in 0..4\nclaim sum(k, 0, n, sum(S, subsets(n, k), sum(T, subsets(S, 1), 1))) == "
                  "if(n == 0, 0, n*2^(n-1))") == "ppppp");
    CHECK(letters("for k in -1..4\nclaim sum(S, subsets(3, k), 1) == binomial(3, k)") == "pppppp");
    CHECK(verdicts("claim sum(S, subsets(3, 2), sum(i, without(3, S), i)) == 6") == "proved");
    CHECK(verdicts("claim sum(S, subsets(4, 2), sum(T, subsets(without(4, S), 2), prod(i, T, i))) == 35") ==
          "proved");
    CHECK(verdicts("claim sum(S, subsets(2, 1), if(1 in S, 1, 10)) == 11\n"
                   "claim sum(S, subsets(2, 1), if(1 not in S, 1, 10)) == 11\n"
                   "claim sum(S, subsets(2, 1), if(1 in S, 2, 1)) == 4") == "proved proved refuted");
    CHECK(verdicts("claim mean(i, 1, 4, x_i) == (x_1 + x_2 + x_3 + x_4)/4") == "proved");
    CHECK(verdicts("claim sum(S, subsets(3, 2), size(S)) == 6") == "proved");
}

TEST_CASE("partitions: Bell numbers, Stirling numbers, and Faa di Bruno's formula") {
    for (const auto& [n, bell] : {std::pair{0, 1}, {1, 1}, {2, 2}, {3, 5}, {4, 15}, {5, 52}}) {
        CHECK(verdicts("claim sum(P, partitions(" + std::to_string(n) + "), 1) == " + std::to_string(bell)) ==
              "proved");
    }
    CHECK(verdicts("claim sum(P, partitions(4), if(size(P) == 2, 1, 0)) == 7") == "proved");
    CHECK(verdicts("claim sum(P, partitions(3), prod(B, P, x_{size(B)})) == x_1^3 + 3*x_1*x_2 + x_3") ==
          "proved");
    CHECK(verdicts("claim sum(S, subsets(4, 3), sum(P, partitions(S), 1)) == 20") == "proved");
    CHECK(
        letters(
            "for n in 1..4\nmap f degree 4\nmap g degree 2\npoly h(t) degree 8 = f(g(t))\n"
            "claim D(h, n)(t) == sum(P, partitions(n), D(f, size(P))(g(t))*prod(B, P, D(g, size(B))(t)))") ==
        "pppp");
    CHECK(letters("for n in 1..3\nmap f degree 3\nmap g degree 2\n"
                  "claim D(f(g(t)), t, n) == sum(P, partitions(n), D(f, size(P))(g(t))*prod(B, P, D(g, "
                  "size(B))(t)))") == "ppp");
    CHECK(
        letters(
            "for n in 2..3\nmap f degree 3\nmap g degree 2\n"
            "claim D(f(g(t)), t, n) == sum(P, partitions(n), D(f, size(P))(g(t))*prod(B, P, D(g, 1)(t)))") ==
        "rr");
}

TEST_CASE("permutations: Leibniz' formula is the determinant") {
    const std::string line = "for n in 0..4\nclaim determinant(i, j, n, a_{i,j}) == ";
    CHECK(letters(line + "sum(P, permutations(n), sign(P)*prod(i, 1, n, a_{i, P(i)}))") == "ppppp");
    CHECK(letters(line + "sum(P, permutations(n), sign(P)*prod(i, 1, n, a_{P(i), i}))") == "ppppp");
    CHECK(letters(line + "sum(P, permutations(n), prod(i, 1, n, a_{i, P(i)}))") == "pprrr");
    CHECK(letters("for n in 0..4\nclaim sum(P, permutations(n), 1) == factorial(n)") == "ppppp");
    CHECK(letters("for n in 1..4\nclaim determinant(i, j, n, x_i^(j-1)) == "
                  "prod(i, 1, n, prod(j, i + 1, n, x_j - x_i))") == "pppp");
    CHECK(verdicts("claim determinant(i, j, 2, a_{i,j}) == a_{1,1}*a_{2,2} - a_{1,2}*a_{2,1}") == "proved");
    CHECK(verdicts("claim sum(P, permutations(3), if(P(1) == 2, 1, 0)) == 2") == "proved");
}

TEST_CASE("choices: duality of Bernstein's polynomials") {
    const std::string line =
        "for n in 0..3\nfor i in 0..n\nfor j in 0..n\npoly B(t) degree n = bernstein(i, n, t)\n";
    CHECK(decided(line + "claim B[0{n-j}, 1{j}] == if(i == j, 1, 0)").at(0).as_expected());
    CHECK_FALSE(decided(line + "claim B[0{n-j}, 1{j}] == if(i != j, 1, 0)").at(0).as_expected());
    CHECK(verdicts("claim bernstein(-1, 2, t) + bernstein(3, 2, t) == 0\nclaim sum(i, 0, 5, bernstein(i, 5, "
                   "t)) == 1") == "proved proved");
    for (const auto& [sign, sum] :
         {std::pair{"<", 3}, {"<=", 6}, {">", 4}, {">=", 7}, {"==", 3}, {"!=", 7}}) {
        INFO(sign);
        CHECK(verdicts("claim sum(i, 1, 4, if(i " + std::string(sign) +
                       " 3, i, 0)) == " + std::to_string(sum)) == "proved");
    }
    CHECK(verdicts("claim sum(i, 0, 2, if(i == 0, 0, 1/i)) == 3/2") == "proved");
    CHECK(verdicts("map b degree 1\nclaim b(if(1 < 2, t, 1) + if(1 > 2, delta, 0*delta)) == b(t)") ==
          "proved");
}

TEST_CASE("splines on one span: partition of unity, Marsden's identity, derivatives") {
    CHECK(letters("for d in 0..3\nclaim sum(j, 4-d, 4, bspline(j, d, x, 4, t)) == 1") == "pppp");
    CHECK(letters("for d in 1..3\nclaim sum(j, 4-d, 4, prod(k, 1, d, x_{j+k} - y)*bspline(j, d, x, 4, t)) == "
                  "(t - y)^d") == "ppp");
    CHECK(letters("for d in 0..3\nclaim sum(j, 5-d, 4, bspline(j, d, x, 4, t)) == 1") == "rrrr");
    CHECK(letters("for j in 0..5\nclaim bspline(j, 1, x, 3, t) == if(j == 3, (x_4 - t)/(x_4 - x_3), "
                  "if(j == 2, (x_4 - t)/(x_4 - x_3), 0))") == "ppprpp");
    CHECK(verdicts("claim bspline(3, 1, x, 3, t) == (t - x_3)/(x_4 - x_3)\nclaim bspline(2, 1, x, 3, t) == "
                   "(x_4 - t)/(x_4 - x_3)") == "proved proved");
    CHECK(letters("for d in 1..3\nclaim D(bspline(4, d, x, 4, t), t) == d*bspline(4, d - 1, x, 4, "
                  "t)/(x_{4+d} - x_4)") == "ppp");
    // A term whose index makes it zero is omitted with its divisor: x_5 == x_6 is allowed on the span of 3.
    CHECK(conditions(decided("claim bspline(3, 1, x, 3, t) == 1").at(0)).find("x_5") == std::string::npos);
}

TEST_CASE("nets over frames and over points") {
    CHECK(letters("for n in 0..4\nmap p degree n net c over a, b\n"
                  "claim p(t) == sum(i, 0, n, c_i*bernstein(i, n, (t - a)/(b - a)))") == "ppppp");
    CHECK(letters("for n in 1..4\nmap p degree n net c over a, b\nclaim p[a{n-1}, b] == c_1") == "pppp");
    CHECK(letters("for n in 2..4\nmap p degree n net c over a, b\nclaim p[a, b{n-1}] == c_1") == "prr");
    CHECK(verdicts("frame r, s, t in 2\nmap q degree 2 on simplex 2 net c over r, s, t\n"
                   "claim q((x, y)) == (1-x-y)^2*c_{2,0,0} + 2*x*(1-x-y)*c_{1,1,0} + 2*y*(1-x-y)*c_{1,0,1} + "
                   "x^2*c_{0,2,0} + 2*x*y*c_{0,1,1} + y^2*c_{0,0,2}\nclaim q[r, t] == c_{1,0,1}\nclaim q[r, "
                   "t] == c_{1,1,0}") == "proved proved refuted");
    CHECK(verdicts(
              "point P, Q, R in 2\nmap q degree 2 on simplex 2 net c over P, Q, R\n"
              "claim 9*q((P + Q + R)/3) == c_{2,0,0} + c_{0,2,0} + c_{0,0,2} + 2*c_{1,1,0} + 2*c_{1,0,1} + "
              "2*c_{0,1,1}") == "proved");
    CHECK(verdicts("let c_{i,j,k} = i\npoint P, Q, R in 2\nmap q degree 2 on simplex 2 net c over P, Q, R\n"
                   "claim q[P, R] == 1\nclaim q(P) == 2") == "proved proved");
    CHECK(complaint("map p degree 1 net c over 2, 2\nclaim 1 == 1") ==
          "1:27 the points of the frame are affinely dependent");
    CHECK(complaint("map p degree 1 net c over a, a\nclaim p(t) == p(t)").find("zero") != std::string::npos);
    CHECK(verdicts("map p degree 1 net c over 0, delta\nclaim 1 == 1").find("mass 1") != std::string::npos);
    CHECK(verdicts("map p degree 2 net c over 0, 1\nraise p to 3 as q\nclaim q[0, 0, 1] == (c_0 + 2*c_1)/3\n"
                   "claim q(t) == p(t)") == "proved proved");
}

TEST_CASE("derivatives of expressions, and along directions") {
    CHECK(verdicts(
              "map f degree 3\nclaim D(f(2*t + 1), t) == 2*f'(2*t + 1)\nclaim D(t^5, t, 3) == 60*t^2\n"
              "claim D(1/t, t) == -1/t^2\nclaim D(x_1^2*x_2, x_1) == 2*x_1*x_2\nclaim D(t*u, t, 0) == t*u\n"
              "claim D(f[t, t, s], t) == 2*f[t, s, delta]\nclaim D(t*u, t) == t") ==
          "proved proved proved proved proved proved refuted");
    CHECK(verdicts("let w = t^2 + a\nclaim D(w, t) == 2*t\nclaim D(w, a) == 1") == "proved proved");
    CHECK(verdicts("map f degree 2\ngiven D(f(t), t) == 2*t for all t\nclaim f(x) == f(0) + x^2") ==
          "proved");
    CHECK(complaint("let w = 1\nclaim D(x, w) == 1") ==
          "2:12 a derivative is taken with respect to a variable");
    CHECK(complaint("for n in 1..1\nclaim D(n*x, n) == 1") ==
          "2:14 a derivative is taken with respect to a variable");
    CHECK(verdicts(
              "map q degree 2 on simplex 2\npoint u in 2\nvector d, e in 2\nclaim D(q, d)(u) == 2*q[u, d]\n"
              "claim D(q, d, e)(u) == 2*q[d, e]\nclaim D(q, d, d, e)(u) == 0\nclaim D(q, d)(u) == q[u, d]") ==
          "proved proved proved refuted");
    CHECK(verdicts("map f degrees 2, 3\nclaim D(f, 1, 2)(u, v) == 12*f[u, delta; v, delta{2}]\n"
                   "claim D(f, 3, 0)(u, v) == 0\nclaim D(f, 1, 2)(u, v) == 6*f[u, delta; v, delta{2}]") ==
          "proved proved refuted");
}

TEST_CASE("raised tensors and nets, and points by their coordinates") {
    CHECK(verdicts("map q degree 2 on simplex 2\n"
                   "claim q[((1,0) + (0,1))/2, (0,0)] == (q[(1,0), (0,0)] + q[(0,1), (0,0)])/2\n"
                   "claim q[2*(1,0) - (0,1), (0,0)] == 2*q[(1,0), (0,0)] - q[(0,1), (0,0)]\n"
                   "claim q[((1,0) + (0,1))/2, (0,0)] == q[(1,0), (0,0)]") == "proved proved refuted");
    CHECK(verdicts(
              "map f degrees 1, 2\nraise f to 2, 2 as g\nclaim g[a, b; c, d] == (f[a; c, d] + f[b; c, d])/2\n"
              "claim g(u, v) == f(u, v)\nclaim g[a, b; c, d] == f[a; c, d]") == "proved proved refuted");
    CHECK(verdicts("point P, Q, R in 2\nmap q degree 1 on simplex 2 net c over P, Q, R\nraise q to 2 as g\n"
                   "claim g[P, Q] == (c_{1,0,0} + c_{0,1,0})/2\nclaim g(P + Q) == 2*q(P + Q)") ==
          "proved proved");
    CHECK(verdicts("map q degree 2 on simplex 2\nclaim q[(a, b), (c, d)] == q[(c, d), (a, b)]\n"
                   "claim q((a, b)) == q(a, b)\nclaim q((a, b) + (c, d)) == q((a + c, b + d))") ==
          "proved proved refuted");
    CHECK(complaint("map f degree 2\nraise f to 1 as g\nclaim 1 == 1").find("lower") != std::string::npos);
}
