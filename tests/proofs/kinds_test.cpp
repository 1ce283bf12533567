#include "decided.hpp"

// Numbers, points, vectors, pairs and sets are distinguished before anything is computed.

namespace {

/// The error of one claim after lines that declare something of every kind.
std::string about(const std::string& claim) {
    static const std::string lines =
        "map b degree 2\nmap q degree 2 on simplex 2\npoint r, s in 2\nvector d in 2\npoint z in 3\n";
    const std::string found = complaint(lines + "claim " + claim);
    REQUIRE(found.starts_with("6:"));
    return found.substr(2);
}

}  // namespace

TEST_CASE("operands that cannot be added, multiplied or divided are refused at their places") {
    CHECK(about("q(r + 1) == 0") == "9 a point of dimension 2 and a point of dimension 1 cannot be added");
    CHECK(about("q(r + z) == 0") == "9 a point of dimension 2 and a point of dimension 3 cannot be added");
    CHECK(about("q(r*s) == 0") == "9 two points or vectors cannot be multiplied");
    CHECK(about("q(r/s) == 0") == "11 a point of dimension 2 cannot divide");
    CHECK(about("1/delta == 0") == "9 a vector of dimension 1 cannot divide");
    CHECK(about("b(delta^2) == 0") == "9 a vector of dimension 1 found, expected a number");
    CHECK(about("2^x == 0") == "9 an expression with variables found, expected an integer");
    CHECK(about("prod(i, 1, 2, delta) == 0") == "21 points and vectors cannot be multiplied");
    CHECK(about("determinant(i, j, 2, delta) == 0") == "28 a vector of dimension 1 found, expected a number");
    CHECK(about("b(<delta, 1>) == 0") == "10 a vector of dimension 1 found, expected a number");
    CHECK(about("b((x, y)) == 0") == "9 a point of dimension 2 found, expected an argument of dimension 1");
    CHECK(about("q((x, delta)) == 0") == "13 a vector of dimension 1 found, expected a number");
}

TEST_CASE("sides are numbers, and arguments lie in the space of the map") {
    CHECK(about("r == s") == "7 a point of dimension 2 found, expected a number");
    CHECK(about("1 == r - s") == "12 a vector of dimension 2 found, expected a number");
    CHECK(about("delta == delta") == "7 a vector of dimension 1 found, expected a number");
    CHECK(about("<1, 2> == 0") == "7 a pair of dimension 1 found, expected a number");
    CHECK(about("b(r) == 0") == "9 a point of dimension 2 found, expected an argument of dimension 1");
    CHECK(about("q(1) == 0") == "9 an integer found, expected an argument of dimension 2");
    CHECK(about("q[r, x] == 0") == "12 a number found, expected an argument of dimension 2");
    CHECK(about("q[r, z] == 0") == "12 a point of dimension 3 found, expected an argument of dimension 2");
    CHECK(about("q[r{x}] == 0") == "11 an expression with variables found, expected an integer");
    CHECK(about("D(q, r)(s) == 0") ==
          "12 a point of dimension 2 found, expected a vector of dimension 2, the direction of a derivative");
    CHECK(
        about("D(q, delta)(s) == 0") ==
        "12 a vector of dimension 1 found, expected a vector of dimension 2, the direction of a derivative");
    CHECK(about("D(b, x)(t) == 0") == "12 an expression with variables found, expected an integer");
    CHECK(about("b'(<t, w>) == 0") == "7 a derivative is taken at a number or at a point, of mass 1");
}

TEST_CASE("sets, permutations and integers are required where they are expected") {
    CHECK(about("size(3) == 0") == "12 an integer found, expected a set");
    CHECK(about("sum(S, 3, 1) == 0") == "14 an integer found, expected a set");
    CHECK(about("sum(S, subsets(2, 1), S) == 0") ==
          "29 a set found, expected a number, point, vector or pair");
    CHECK(about("sum(P, permutations(2), sum(i, P, 1)) == 0") == "38 a permutation found, expected a set");
    CHECK(about("sum(P, permutations(2), P(x)) == 0") ==
          "33 an expression with variables found, expected an integer");
    CHECK(about("sum(P, permutations(2), P(3)) == 0").starts_with("33 3 is not among 1..2"));
    CHECK(about("sum(S, subsets(2, 1), sign(S)) == 0") == "34 a set found, expected a permutation");
    CHECK(about("sum(P, partitions(2), size(P) + sum(i, P, i)) == 0").find("a set found") !=
          std::string::npos);
    CHECK(about("binomial(x, 1) == 0") == "16 an expression with variables found, expected an integer");
    CHECK(about("if(x == 1, 1, 2) == 0") == "10 an expression with variables found, expected an integer");
    CHECK(about("if(1 == 1, 1, delta) == 0") ==
          "7 the two choices are an integer and a vector of dimension 1");
    CHECK(about("t_{x} == 0") == "10 an expression with variables found, expected an integer");
    CHECK(about("t_{1/2} == 0").find("expected an integer") != std::string::npos);
    CHECK(about("bspline(0, 1, x_1, 0, t) == 0")
              .find("the third argument of bspline is the name of the knots") != std::string::npos);
    CHECK(about("bspline(0, 1, r, 0, t) == 0").find("the knots of bspline are numbers") != std::string::npos);
}

TEST_CASE("the sum over nothing is the zero of the kind of its summand") {
    const std::string b = "map b degree 2\n";
    const std::string q = "map q degree 2 on simplex 2\npoint r, u in 2\nvector d in 2\n";
    CHECK(verdicts(b + "claim sum(i, 1, 0, t_i) == 0\nclaim b(sum(i, 1, 0, t_i)) == b(0)\n"
                       "claim b(sum(i, 1, 0, i)) == b(0)\nclaim b(sum(i, 1, 0, t_i)) == 0") ==
          "proved proved proved refuted");
    CHECK(
        verdicts(b +
                 "claim b(sum(i, 1, 0, delta)) == 0\nclaim b[t, sum(i, 1, 0, t + delta)] == 0\n"
                 "claim b[t, t + sum(i, 1, 0, delta)] == b(t)\nclaim b[t, sum(i, 1, 0, delta)] == b[t, 0]") ==
        "proved proved proved refuted");
    CHECK(verdicts(q + "claim q(sum(i, 1, 0, r)) == 0\nclaim q(u + sum(i, 1, 0, d)) == q(u)\n"
                       "claim q(u + sum(i, 1, 0, r)) == q(u)\nclaim q(sum(i, 1, 0, u_i)) == q((0, 0))") ==
          "proved proved proved refuted");
    CHECK(verdicts("claim prod(i, 1, 0, t_i) == 1\nclaim determinant(i, j, 0, t_{i,j}) == 1") ==
          "proved proved");
    CHECK(complaint("claim mean(i, 1, 0, t_i) == 0").starts_with("1:7 "));
}

TEST_CASE("coordinates and masses add, and numbers are points of the line beside vectors") {
    const std::string b = "map b degree 2\n";
    CHECK(verdicts(b + "claim b(t + delta) == b(t + 1)\nclaim b[t + 2*delta, s] == b[t, s] + 2*b[delta, s]\n"
                       "claim b(3*delta) == 9*b(delta)\nclaim b(1 - delta) == b(0)\n"
                       "claim b(<1, 0> - 1) == b(<0, -1>)\nclaim b(-delta) == b(delta)") ==
          "proved proved proved proved proved proved");
    CHECK(verdicts(b + "claim b(<t, w>/w) == b(t/w)") == "proved");
    CHECK(verdicts(
              "map q degree 2 on simplex 2\npoint r, s in 2\nclaim q((r + s)/2) == q(r/2 + s/2)\n"
              "claim q(r + s) == 4*q((r + s)/2)\nclaim q(x, y) == q((x, y))\nclaim q((1, 2)) == q((2, 1))") ==
          "proved proved proved refuted");
    CHECK(verdicts("map c degree 1 on simplex 3\nclaim c((x, y, z)) == x*c((1, 0, 0)) + y*c((0, 1, 0)) + "
                   "z*c((0, 0, 1)) + (1 - x - y - z)*c((0, 0, 0))") == "proved");
}

TEST_CASE("all clauses of an abbreviation have one kind") {
    CHECK(complaint("let w_0 = 1\nlet w_i = delta\nclaim 1 == 1")
              .starts_with(
                  "2:11 this line makes w_i a vector of dimension 1, another one makes it an integer"));
    CHECK(
        complaint("point r in 2\npoint s in 3\nlet w_0 = r\nlet w_1 = s\nclaim 1 == 1").starts_with("4:11 "));
    CHECK(complaint("number w_0..w_3\nlet w_5 = delta\nclaim 1 == 1") ==
          "2:11 w_i is declared as a number, and abbreviates a vector of dimension 1");
    const std::string points = "point u_1, u_2, w_1 in 2\n";
    CHECK(complaint(points + "let w_5 = sum(i, 1, 2, u_i)\nclaim 1 == 1") ==
          "2:11 w_i is declared as a point of dimension 2, and abbreviates a pair of dimension 2");
    CHECK(complaint(points + "let w_5 = u_1 - u_2\nclaim 1 == 1") ==
          "2:11 w_i is declared as a point of dimension 2, and abbreviates a vector of dimension 2");
    CHECK(verdicts(points + "let w_5 = mean(i, 1, 2, u_i)\nmap q degree 1 on simplex 2\n"
                            "claim q(w_5) == (q(u_1) + q(u_2))/2") == "proved");
    CHECK(complaint("let S = subsets(3, 1)\nclaim 1 == 1").starts_with("1:9 a collection of sets found"));
    CHECK(verdicts("map b degree 1\nlet w_0 = 1 + delta\nlet w_1 = delta\nclaim b(w_0 - w_1) == b(1)") ==
          "proved");
}
