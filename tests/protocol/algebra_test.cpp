#include <string>

#include "answered.hpp"

namespace {

const std::string line = R"({"kind": "bezier", "control_points": [["0", "0"], ["1", "2"]]})";
const std::string number = R"({"kind": "bezier", "control_points": ["1", "3"]})";
const std::string hat =
    R"({"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 2], "control_points": [0, 1, 0]})";
const std::string square = R"({"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 1], [2, 3]]})";
const std::string triangle = R"({"kind": "simplex", "degree": 1,
    "vertices": [[0, 0], [1, 0], [0, 1]], "control_net": [[[1, 0, 0], 1], [[0, 1, 0], 2], [[0, 0, 1], 3]]})";

std::string maps(const std::string& one, const std::string& other) {
    return R"("maps": [)" + one + ", " + other + "]";
}

}  // namespace

TEST_CASE("a request that no algebra of maps has an answer for is refused where it is wrong") {
    CHECK(refusal_text(R"("op": "sum", "maps": [])") == "wrong_arity /maps");
    CHECK(refusal_text(R"("op": "sum", )" + maps(line, number)) == "mismatched_dimensions /maps/1");
    CHECK(refusal_text(R"("op": "sum", )" + maps(number, hat)) == "outside_domain /maps/0");
    CHECK(refusal_text(R"("op": "sum", )" + maps(hat, square)) == "mismatched_dimensions /maps/1");
    CHECK(refusal_text(R"("op": "sum", )" + maps(square, triangle)) == "mismatched_dimensions /maps/1");
    CHECK(refusal_text(R"("op": "sum", "factors": [1], )" + maps(number, number)) == "wrong_arity /factors");
    CHECK(refusal_text(R"("op": "product", )" + maps(line, line)) == "mismatched_dimensions /maps/1");
    CHECK(refusal_text(R"("op": "product", "as": "cross", )" + maps(line, line)) == "wrong_arity /maps");
    CHECK(refusal_text(R"("op": "product", "as": "wedge", )" + maps(line, line)) == "wrong_kind /as");
    CHECK(refusal_text(R"("op": "quotient", )" + maps(number, line)) == "mismatched_dimensions /maps/1");
    CHECK(refusal_text(R"("op": "quotient", "maps": [)" + number + "]") == "wrong_arity /maps");
    CHECK(refusal_text(R"("op": "quotient", )" +
                       maps(number, R"({"kind": "bezier", "control_points": [0, 0]})")) ==
          "zero_weight /maps/1");
    CHECK(refusal_text(R"("op": "transform", "map": )" + line) == "missing_field /matrix");
    CHECK(refusal_text(R"("op": "transform", "matrix": [[1, 2], [1]], "map": )" + line) ==
          "mismatched_dimensions /matrix/1");
    CHECK(refusal_text(R"("op": "transform", "matrix": [1, 2], "translation": [1, 2], "map": )" + line) ==
          "mismatched_dimensions /translation");
}

TEST_CASE("a determinant with too many products is refused before they are made") {
    std::string zeros;
    for (int i = 0; i < 10; ++i) zeros += (i == 0 ? "" : ", ") + std::string("0");
    const std::string constant = R"({"kind": "bezier", "control_points": [[)" + zeros + "]]}";
    std::string ten = constant;
    for (int i = 1; i < 10; ++i) ten += ", " + constant;
    CHECK(refusal_text(R"("op": "product", "as": "determinant", "maps": [)" + ten + "]") ==
          "limit_exceeded /maps");
}

TEST_CASE("a request for a polar, a restriction or a composition is refused where it is wrong") {
    const std::string cubic = R"("map": {"kind": "polynomial", "text": "t^3"})";
    const std::string of_square = R"("map": )" + square;
    CHECK(refusal_text(R"("op": "polar", "arguments": [1, 2, 3, 4], )" + cubic) == "wrong_arity /arguments");
    CHECK(refusal_text(R"("op": "polar", "arguments": [[1, 2], []], )" + of_square) ==
          "wrong_arity /arguments/0");
    CHECK(refusal_text(R"("op": "polar", "arguments": [[0, 0], [1, 1]], "map": )" + triangle) ==
          "wrong_arity /arguments");
    CHECK(refusal_text(R"("op": "restrict", "vertices": [[0, 0]], )" + of_square) == "wrong_arity /vertices");
    CHECK(refusal_text(R"("op": "restrict", "vertices": [[0, 0], [1]], )" + of_square) ==
          "mismatched_dimensions /vertices/1");
    CHECK(refusal_text(R"("op": "restrict", "vertices": [[0, 0], [1, 0], [0, 1]], "interval": [0, 1], )" +
                       of_square) == "wrong_kind /interval");
    CHECK(refusal_text(R"("op": "restrict", "at": [1, 2], )" + of_square) == "wrong_arity /at");
    CHECK(refusal_text(R"("op": "restrict", "at": [1, null], "map": )" + triangle) == "wrong_kind /at");
    CHECK(refusal_text(R"("op": "restrict", "vertices": [0, 3], "map": )" + hat) ==
          "outside_domain /vertices/1/0");
    CHECK(refusal_text(R"("op": "compose", )" + maps(square, number)) == "mismatched_dimensions /maps/1");
    CHECK(refusal_text(R"("op": "compose", )" + maps(hat, number)) == "outside_domain /maps/1");
    CHECK(refusal_text(R"("op": "compose", )" + maps(hat, R"({"kind": "polynomial", "text": "t"})")) ==
          "outside_domain /maps/1");
    CHECK(refusal_text(R"("op": "compose", )" +
                       maps(R"({"kind": "simplex", "degree": 0, "control_net": [[[0, 0, 0], 1]]})", line)) ==
          "wrong_kind /maps/0");
}

TEST_CASE("a request for a Jacobian, bounds or a resultant is refused where it is wrong") {
    const std::string barycentric =
        R"("map": {"kind": "simplex", "degree": 0, "control_net": [[[0, 0], 1]]})";
    CHECK(refusal_text(R"("op": "jacobian", "map": )" + square) == "mismatched_dimensions /map");
    CHECK(refusal_text(R"("op": "normal", "map": )" + number) == "mismatched_dimensions /map");
    CHECK(refusal_text(R"("op": "jacobian", )" + barycentric) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "bounds", "map": )" + line) == "mismatched_dimensions /map");
    CHECK(refusal_text(R"("op": "gcd", )" + maps(line, number)) == "mismatched_dimensions /maps/0");
    CHECK(refusal_text(R"("op": "gcd", )" + maps(square, square)) == "wrong_kind /maps/0");
    CHECK(refusal_text(R"("op": "gcd", )" + maps(hat, number)) == "wrong_kind /maps/0");
    const std::string xy = R"({"kind": "polynomial", "variables": ["x", "y"], "text": "x*y"})";
    CHECK(refusal_text(R"("op": "resultant", )" + maps(xy, xy)) == "missing_field /variable");
    CHECK(refusal_text(R"("op": "resultant", "variable": "z", )" + maps(xy, xy)) == "wrong_kind /variable");
    CHECK(refusal_text(R"("op": "resultant", )" + maps(xy, number)) == "mismatched_dimensions /maps/1");
    CHECK(refusal_text(R"("op": "resultant", "maps": [)" + number + "]") == "wrong_arity /maps");
}
