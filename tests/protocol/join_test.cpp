#include <string>

#include "answered.hpp"

namespace {

/// The result of `join` without its kind and braces.
std::string joined(const std::string& maps, const std::string& others = "") {
    return result_text(R"("op": "join", "maps": [)" + maps + "]" + others);
}

const std::string first_half =
    R"({"kind": "bezier", "control_points": [["1", "0"], ["1", "1/2"], ["3/5", "4/5"]],
        "weights": ["1", "1", "5/4"], "interval": ["0", "1/2"]})";
const std::string second_half =
    R"({"kind": "bezier", "control_points": [["3/5", "4/5"], ["1/3", "1"], ["0", "1"]],
        "weights": ["1", "6/5", "8/5"], "interval": ["1/2", "1"]})";
const std::string quarter =
    R"({"kind": "bezier", "control_points": [["1", "0"], ["1", "1"], ["0", "1"]], "weights": ["1", "1", "2"]})";
const std::string next_quarter =
    R"({"kind": "bezier", "control_points": [["0", "1"], ["-1", "1"], ["-1", "0"]], "weights": ["1", "1", "2"],
        "interval": ["1", "2"]})";

}  // namespace

TEST_CASE("two halves of one rational curve are joined without a knot, whatever their weights") {
    CHECK(
        joined(first_half + ", " + second_half) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1", "1", "1"], "control_points": [["1", "0"], ["1", "1"], ["0", "1"]], "weights": ["1", "1", "2"]}})");
    // The same circle behind the quarter, multiplied by 3 - t; and a curve of degree 1 multiplied likewise.
    const std::string circle =
        R"({"kind": "polynomial", "text": ["t^3 - 4t", "4 + 2t - 2t^2"], "denominator": "4 + 2t - t^3"})";
    CHECK(
        joined(quarter + ", " + circle, R"(, "chain": true)")
            .starts_with(
                R"({"map": {"kind": "bspline", "degree": 3, "knots": ["0", "0", "0", "0", "2", "2", "2", "2"], )"));
    const std::string line = R"({"kind": "bezier", "control_points": ["1", "2"], "weights": ["1", "3"]})";
    const std::string longer =
        R"({"kind": "polynomial", "text": "18 + 9t - 5t^2", "denominator": "9 + 3t - 2t^2"})";
    CHECK(joined(line + ", " + longer, R"(, "chain": true)")
              .starts_with(
                  R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "2", "2", "2"], )"));
}

TEST_CASE("a quarter circle has the weights of the one before it") {
    CHECK(
        joined(quarter + ", " + next_quarter) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1", "1", "2", "2", "2"], "control_points": [["1", "0"], ["1", "1"], ["0", "1"], ["-1", "1"], ["-1", "0"]], "weights": ["1", "1", "2", "2", "4"]}})");
}

TEST_CASE("knots that rational curves do not allow are refused with what continuity says of them") {
    const std::string maps = R"("maps": [)" + quarter + ", " + next_quarter + "]";
    const Json refused = served(R"({"op": "join", "knots": [0, 0, 0, 1, 2, 2, 2], )" + maps + "}");
    const Json contact = served(R"({"op": "continuity", "at": "1", )" + maps + "}");
    CHECK(at_pointer(contact, "/result/order")->number()->text == "0");
    CHECK(*at_pointer(refused, "/error/message")->text() ==
          "multiplicity 1 of the knot 1 in degree 2 needs order 1 of maps 0 and 1. The curves meet with "
          "order 0 at 1, "
          "sharing the point but not the tangent: the derivatives of order 1 are (-1, 0) and (-2, 0)");
    // One tangent, but weights whose quotient has a slope.
    const std::string smooth =
        R"("maps": [{"kind": "bezier", "control_points": ["0", "1"]}, {"kind": "polynomial", "text": "1 + 2t",
            "denominator": "1 + t"}], "chain": true)";
    const Json weights = served(R"({"op": "join", "knots": [0, 0, 2, 2], )" + smooth + "}");
    CHECK(*at_pointer(weights, "/error/message")->text() ==
          "multiplicity 0 of the knot 1 in degree 1 needs order 1 of maps 0 and 1. The curves meet with "
          "order 1 at 1, "
          "sharing the tangent but not the osculating parabola, but their homogeneous points, multiplied "
          "by any number, "
          "only with order 0: the blossom values at (2) are (2, 1) and (3, 2)");
}

TEST_CASE("curves of all kinds and splines are joined, with their own intervals or one after the other") {
    const std::string spline =
        R"({"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2], "control_points": [0, 1, 4, 5]})";
    const std::string line = R"({"kind": "bezier", "control_points": [5, 7], "interval": [2, 3]})";
    CHECK(
        joined(spline + ", " + line) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1", "2", "3", "3", "3"], "control_points": ["0", "1", "4", "6", "7"]}})");
    CHECK(
        joined(
            R"({"kind": "polynomial", "text": "t^2"}, {"kind": "bezier", "control_points": [1, 0], "interval": [7, 9]})",
            R"(, "chain": true)") ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1", "1", "3", "3", "3"], "control_points": ["0", "0", "1", "1/2", "0"]}})");
    CHECK(refusal_text(R"("op": "join", "maps": [)" + line + ", " + spline + "]") == "not_adjacent /maps/1");
    CHECK(refusal_text(R"("op": "join", "maps": [)" + spline + "], \"knots\": [0, 0, 0, 2, 2, 2]") ==
          "not_continuous /maps/0");
    CHECK(
        refusal_text(
            R"("op": "join", "maps": [{"kind": "simplex", "degree": 0, "control_net": [[[0, 0, 0], 1]]}])") ==
        "wrong_kind /maps/0");
}
