#include <string>

#include "answered.hpp"

namespace {

const std::string open_spline =
    R"("map": {"kind": "bspline", "degree": 2, "knots": [0, 1, 2, 3, 4, 5], "control_points": [0, 2, 4]})";
const std::string bent =
    R"("map": {"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 3, 3, 3], "control_points": [0, 1, 3, 0]})";
const std::string triangle =
    R"("map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 3, 3], "control_points": [[0, 0], [2, 0], [1, 2], [0, 0]]})";

}  // namespace

TEST_CASE("a clamped spline begins and ends with its control points, in its own convention") {
    CHECK(
        result_text(R"("op": "clamp", )" + open_spline) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["2", "2", "2", "3", "3", "3"], "control_points": ["1", "2", "3"]}})");
    CHECK(
        result_text(
            R"("op": "clamp", "map": {"kind": "bspline", "degree": 2, "knots": [1, 2, 3, 4], "control_points": [0, 2, 4]})") ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["2", "2", "3", "3"], "control_points": ["1", "2", "3"]}})");
    CHECK(refusal_text(R"("op": "clamp", "map": {"kind": "bezier", "control_points": [0]})") ==
          "wrong_kind /map");
}

TEST_CASE("a part of a curve is clamped, and lies in the domain of a spline") {
    CHECK(
        result_text(R"("op": "trim", "interval": [2, "5/2"], )" + open_spline) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["2", "2", "2", "5/2", "5/2", "5/2"], "control_points": ["1", "3/2", "2"]}})");
    CHECK(
        result_text(R"("op": "trim", "interval": [3, 1], "map": {"kind": "polynomial", "text": "t^2"})") ==
        R"({"map": {"kind": "bezier", "degree": 2, "interval": ["3", "1"], "control_points": ["9", "3", "1"]}})");
    CHECK(refusal_text(R"("op": "trim", "interval": [3, 2], )" + open_spline) == "outside_domain /interval");
    CHECK(refusal_text(R"("op": "trim", "interval": [0, 3], )" + open_spline) == "outside_domain /interval");
    CHECK(refusal_text(R"("op": "trim", )" + open_spline) == "missing_field /interval");
}

TEST_CASE("curves of every kind are reversed over their intervals and moved to others") {
    CHECK(
        result_text(R"("op": "reverse", )" + bent) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "2", "3", "3", "3"], "control_points": ["0", "3", "1", "0"]}})");
    CHECK(result_text(R"("op": "reverse", "map": {"kind": "polynomial", "text": "t^2"})") ==
          R"({"map": {"kind": "polynomial", "degree": 2, "coefficients": ["1", "-2", "1"]}})");
    CHECK(result_text(
              R"("op": "reverse", "map": {"kind": "taylor", "center": 3, "coefficients": [5, 1, 2]})") ==
          R"({"map": {"kind": "taylor", "degree": 2, "center": "-2", "coefficients": ["5", "-1", "2"]}})");
    CHECK(
        result_text(
            R"("op": "reverse", "map": {"kind": "bezier", "control_points": [1, 2, 5], "weights": [1, 2, 3], "interval": [4, 2]})") ==
        R"({"map": {"kind": "bezier", "degree": 2, "interval": ["4", "2"], "control_points": ["5", "2", "1"], "weights": ["3", "2", "1"]}})");
    CHECK(
        result_text(R"("op": "reparametrise", "interval": [6, 0], )" + bent) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "4", "6", "6", "6"], "control_points": ["0", "3", "1", "0"]}})");
    CHECK(
        result_text(
            R"("op": "reparametrise", "from": [0, 1], "interval": [3, 5], "map": {"kind": "taylor", "center": 1, "coefficients": [5, 1, 2]})") ==
        R"({"map": {"kind": "taylor", "degree": 2, "center": "5", "coefficients": ["5", "1/2", "1/2"]}})");
    CHECK(refusal_text(R"("op": "reparametrise", "interval": [1, 1], )" + bent) ==
          "empty_interval /interval");
    CHECK(refusal_text(R"("op": "reparametrise", "from": [1, 1], )" + bent) == "empty_interval /from");
}

TEST_CASE("a knot is raised to a multiplicity that it may have") {
    const std::string insert = R"("op": "insert-knots", )" + bent;
    CHECK(
        result_text(insert + R"(, "knots": [1, 1], "multiplicity": 2)") ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1", "1", "3", "3", "3"], "control_points": ["0", "1", "5/3", "3", "0"]}})");
    CHECK(
        result_text(insert + R"(, "knots": [0, 1, 3], "multiplicity": 1)") ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1", "3", "3", "3"], "control_points": ["0", "1", "3", "0"]}})");
    CHECK(refusal_text(insert + R"(, "knots": [1], "multiplicity": 4)") == "bad_knots /multiplicity");
    CHECK(refusal_text(insert + R"(, "knots": [1, 4], "multiplicity": 2)") == "outside_domain /knots/1");
    const std::string surface =
        R"("op": "insert-knots", "map": {"kind": "bspline", "degrees": [1, 2], "knots": [[0, 0, 1, 1], [0, 0, 0, 1, 1, 1]],
            "control_net": [[0, 1, 2], [2, 5, 6]]}, )";
    CHECK(served_at("/result/map/knots", "{" + surface + R"("knots": [["1/2"], []], "multiplicity": 2})") ==
          R"([["0", "0", "1/2", "1/2", "1", "1"], ["0", "0", "0", "1", "1", "1"]])");
    CHECK(refusal_text(surface + R"("knots": [["1/2"], []], "multiplicity": 3)") ==
          "bad_knots /multiplicity");
    CHECK(refusal_text(surface + R"("knots": [[], ["5"]], "multiplicity": 3)") ==
          "outside_domain /knots/1/0");
}

TEST_CASE("both parts of a spline are clamped where that is asked for") {
    const std::string split = R"("op": "subdivide", "at": "5/2", )" + open_spline;
    CHECK(
        result_text(split) ==
        R"({"maps": [{"kind": "bspline", "degree": 2, "knots": ["0", "1", "2", "5/2", "5/2", "5/2"], "control_points": ["0", "3/2", "2"]}, {"kind": "bspline", "degree": 2, "knots": ["5/2", "5/2", "5/2", "3", "4", "5"], "control_points": ["2", "5/2", "4"]}]})");
    CHECK(
        result_text(split + R"(, "clamped": true)") ==
        R"({"maps": [{"kind": "bspline", "degree": 2, "knots": ["2", "2", "2", "5/2", "5/2", "5/2"], "control_points": ["1", "3/2", "2"]}, {"kind": "bspline", "degree": 2, "knots": ["5/2", "5/2", "5/2", "3", "3", "3"], "control_points": ["2", "5/2", "3"]}]})");
    CHECK(
        refusal_text(
            R"("op": "subdivide", "at": 2, "clamped": true, "map": {"kind": "bezier", "control_points": [0]})") ==
        "unknown_field /clamped");
}

TEST_CASE("a closed spline has periodic knots and the order of contact at its seam") {
    CHECK(
        result_text(R"("op": "periodic", )" + triangle) ==
        R"({"map": {"kind": "bspline", "degree": 1, "knots": ["-1", "0", "1", "2", "3", "4"], "control_points": [["0", "0"], ["2", "0"], ["1", "2"], ["0", "0"]]}, "order": 0})");
    CHECK(served_at("/result/order", R"({"op": "continuity", "at": "seam", )" + triangle + "}") == "0");
    CHECK(served_at("/result/order", R"({"op": "continuity", "at": "seam", )" + open_spline + "}") == "-1");
    CHECK(
        result_text(
            R"("op": "periodic", "map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 1], "control_points": [7, 7]})") ==
        R"({"map": {"kind": "bspline", "degree": 1, "knots": ["-1", "0", "1", "2"], "control_points": ["7", "7"]}, "order": "infinite"})");
    const Json refused = served(R"({"op": "periodic", )" + open_spline + "}");
    CHECK(*at_pointer(refused, "/error/code")->text() == "not_continuous");
    CHECK(*at_pointer(refused, "/error/at")->text() == "/map");
    CHECK(at_pointer(refused, "/error/message")
              ->text()
              ->starts_with("the curve is not closed. The curves do not meet at 3"));
    CHECK(refusal_text(R"("op": "continuity", "at": "end", )" + triangle) == "not_a_number /at");
}

TEST_CASE("a circle of four arcs is closed, whatever the weights at its ends") {
    const std::string circle =
        R"("map": {"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], "control_points":
            [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]],
            "weights": [1, 1, 2, 2, 4, 4, 8, 8, 16]})";
    CHECK(
        result_text(R"("op": "periodic", )" + circle) ==
        R"({"map": {"kind": "bspline", "degree": 2, "knots": ["-1", "0", "0", "1", "1", "2", "2", "3", "3", "4", "4", "5"], "control_points": [["1", "0"], ["1", "1"], ["0", "1"], ["-1", "1"], ["-1", "0"], ["-1", "-1"], ["0", "-1"], ["1", "-1"], ["1", "0"]], "weights": ["1", "1", "2", "2", "4", "4", "8", "8", "16"]}, "order": 0})");
    CHECK(served_at("/result/order", R"({"op": "continuity", "at": "seam", )" + circle + "}") == "0");
}
