#include "answered.hpp"

// The operations on curves of every kind: their answers and their errors.

namespace {

const std::string cubic = R"("map": {"kind": "polynomial", "text": "1 + 2t + 4t^2 - t^3"})";
const std::string spline = R"("map": {"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 2, 3, 3, 3],
                                      "control_points": [0, 2, 3, 1, 4]})";
const std::string polar = R"("map": {"kind": "bspline", "degree": 2, "knots": [0, 0, 1, 2, 3, 3],
                                     "control_points": [0, 2, 3, 1, 4]})";
const std::string progressive =
    R"("map": {"kind": "progressive", "knots": [3, 0, 2, 1], "control_points": [0, 0, 2]})";
const std::string quarter = R"("map": {"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 1, 1],
                                "control_points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]})";

}  // namespace

TEST_CASE("every kind of curve is evaluated") {
    CHECK(result_text(R"("op": "evaluate", "at": [0, 3], )" + cubic) == R"({"values": ["1", "16"]})");
    CHECK(result_text(R"("op": "evaluate", "at": [0, 1, "3/2", 3], )" + spline) ==
          R"({"values": ["0", "5/2", "21/8", "4"]})");
    CHECK(result_text(R"("op": "evaluate", "at": [0, 1, "3/2", 3], )" + polar) ==
          R"({"values": ["0", "5/2", "21/8", "4"]})");
    // b(u, v) = u v - (u + v) / 2 + ... : the values at (3, 0), (0, 2) and (2, 1) are 0, 0 and 2.
    CHECK(result_text(R"("op": "blossom", "arguments": [3, 0], )" + progressive) == R"({"value": "0"})");
    CHECK(result_text(R"("op": "blossom", "arguments": [1, 2], )" + progressive) == R"({"value": "2"})");
    CHECK(result_text(R"("op": "evaluate", "at": [2], "map": {"kind": "taylor", "center": 1,
                    "coefficients": [5, 0, "1/2"]})") == R"({"values": ["11/2"]})");
    CHECK(result_text(R"("op": "evaluate", "at": ["1/2"], )" + quarter) == R"({"values": [["3/5", "4/5"]]})");
    CHECK(refusal_text(R"("op": "evaluate", "at": [1], "map": {"kind": "samples", "degree": 0,
                     "values": [["1/2", 1]]})") == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "evaluate", "at": [1, 4], )" + spline) == "outside_domain /at/1");
}

TEST_CASE("the pyramid is the triangle of de Casteljau or de Boor") {
    CHECK(result_text(R"("op": "evaluate", "pyramid": true, "at": ["1/2"],
                    "map": {"kind": "bezier", "control_points": [0, 2, 0]})") ==
          R"({"values": ["1"], "pyramids": [[["0", "2", "0"], ["1", "1"], ["1"]]]})");
    CHECK(result_text(R"("op": "evaluate", "pyramid": true, "at": ["3/2"], )" + spline) ==
          R"({"values": ["21/8"], "pyramids": [[["2", "3", "1"], ["11/4", "5/2"], ["21/8"]]]})");
    CHECK(result_text(R"("op": "evaluate", "pyramid": true, "at": ["1/2"], )" + quarter) ==
          R"({"values": [["3/5", "4/5"]], "pyramids": [[[["1", "0"], ["1", "1"], ["0", "1"]], )"
          R"([["1", "1/2"], ["1/3", "1"]], [["3/5", "4/5"]]]], )"
          R"("pyramid_weights": [[["1", "1", "2"], ["1", "3/2"], ["5/4"]]]})");
}

TEST_CASE("a segment of a spline is named where there are several") {
    CHECK(result_text(R"("op": "blossom", "segment": 3, "arguments": [1, 2], )" + spline) ==
          R"({"value": "3"})");
    CHECK(result_text(R"("op": "blossom", "segment": 2, "arguments": [1, 2], )" + polar) ==
          R"({"value": "3"})");
    CHECK(result_text(
              R"("op": "blossom", "segment": 3, "arguments": [1, 2], "construction": "polarization", )" +
              spline) == R"({"value": "3"})");
    CHECK(refusal_text(R"("op": "blossom", "arguments": [1, 2], )" + spline) == "outside_domain /segment");
    CHECK(refusal_text(R"("op": "blossom", "segment": 1, "arguments": [1, 2], )" + spline) ==
          "outside_domain /segment");
    CHECK(refusal_text(R"("op": "blossom", "segment": 1, "arguments": [1, 2, 3], )" + cubic) ==
          "unknown_field /segment");
    CHECK(refusal_text(R"("op": "blossom", "segment": 3, "arguments": [1], )" + spline) ==
          "wrong_arity /arguments");
}

TEST_CASE("both conventions of knots are kept") {
    CHECK(served_at("/result/map/knots", R"({"op": "insert-knots", "knots": [2], )" + spline + "}") ==
          R"(["0", "0", "0", "1", "2", "2", "3", "3", "3"])");
    CHECK(served_at("/result/map/knots", R"({"op": "insert-knots", "knots": [2], )" + polar + "}") ==
          R"(["0", "0", "1", "2", "2", "3", "3"])");
    CHECK(served_at("/result/map/knots", R"({"op": "elevate", "by": 1, )" + polar + "}") ==
          R"(["0", "0", "0", "1", "1", "2", "2", "3", "3", "3"])");
    CHECK(served_at("/result/map/knots", R"({"op": "derivative", )" + polar + "}") ==
          R"(["0", "1", "2", "3"])");
}

TEST_CASE("a spline reduced by as much as it was raised is itself, and nothing is lost") {
    const Json raised = served(R"({"op": "elevate", "by": 2, )" + spline + "}");
    const std::string reduced =
        served_at("/result", R"({"op": "reduce", "to": 2, "map": )" +
                                 protocol::to_text(*at_pointer(raised, "/result/map")) + "}");
    CHECK(reduced.find(R"("knots": ["0", "0", "0", "1", "2", "3", "3", "3"])") != std::string::npos);
    CHECK(reduced.find(R"("control_points": ["0", "2", "3", "1", "4"]}, "exact": true)") !=
          std::string::npos);
}

TEST_CASE("derivatives of rational maps follow the quotient rule, as values and as maps") {
    const std::string circle =
        R"("map": {"kind": "polynomial", "text": ["1 - t^2", "2t"], "denominator": "1 + t^2"})";
    // C' = (-4t, 2 - 2t^2) / (1 + t^2)^2
    CHECK(result_text(R"("op": "derivative", "at": [0, 1], )" + circle) ==
          R"({"values": [["0", "2"], ["-1", "0"]]})");
    CHECK(result_text(R"("op": "derivative", )" + circle) ==
          R"({"map": {"kind": "polynomial", "degree": 4, "coefficients": [["0", "2"], ["-4", "0"], )"
          R"(["0", "-2"], ["0", "0"], ["0", "0"]], "denominator": ["1", "0", "2", "0", "1"]}})");
    CHECK(result_text(R"("op": "derivative", "at": [0, 1], )" + quarter) ==
          R"({"values": [["0", "2"], ["-1", "0"]]})");
    const Json derived = served(R"({"op": "derivative", )" + quarter + "}");
    CHECK(result_text(R"("op": "evaluate", "at": [0, 1], "map": )" +
                      protocol::to_text(*at_pointer(derived, "/result/map"))) ==
          R"({"values": [["0", "2"], ["-1", "0"]]})");
}

TEST_CASE("an arc of the circle over any parameters stays on the circle") {
    const Json arc = served(
        R"({"op": "control-points", "interval": ["-1/3", "5/2"], "degree": 4,
            "map": {"kind": "polynomial", "text": ["1 - t^2", "2t"], "denominator": "1 + t^2"}})");
    CHECK(result_text(R"("op": "evaluate", "at": ["-1/3", "5/2"], "map": )" +
                      protocol::to_text(*at_pointer(arc, "/result/map"))) ==
          R"({"values": [["4/5", "-3/5"], ["-21/29", "20/29"]]})");
}

TEST_CASE("part of a spline is a Bezier curve on one span, a spline on several") {
    CHECK(
        result_text(R"("op": "control-points", "interval": [1, 2], )" + spline) ==
        R"({"map": {"kind": "bezier", "degree": 2, "interval": ["1", "2"], "control_points": ["5/2", "3", "2"]}})");
    CHECK(served_at("/result/map/knots", R"({"op": "control-points", "interval": ["1/2", 2], )" + spline +
                                             "}") == R"(["1/2", "1/2", "1/2", "1", "2", "2", "2"])");
    CHECK(refusal_text(R"("op": "control-points", "interval": [2, 4], )" + spline) ==
          "outside_domain /interval");
}

TEST_CASE("rational curves meet as the curves that they are, or as homogeneous ones") {
    // The same curve with its homogeneous points multiplied by t + 1.
    const std::string maps =
        R"("at": 1, "maps": [{"kind": "polynomial", "text": ["t"], "denominator": "1 + t^2"},
                             {"kind": "polynomial", "text": ["t + t^2"], "denominator": "(1 + t)^1(1 + t^2)^1"}])";
    CHECK(result_text(R"("op": "continuity", )" + maps) ==
          R"({"order": "infinite", "reason": "The curves are the same rational map at 1"})");
    const std::string plain =
        R"("at": 1, "maps": [{"kind": "polynomial", "text": "t", "denominator": "1"},
                             {"kind": "polynomial", "text": "t^2", "denominator": "t"}])";
    CHECK(served_at("/result/order", R"({"op": "continuity", )" + plain + "}") == R"("infinite")");
    const std::string different =
        R"("at": 1, "maps": [{"kind": "polynomial", "text": "t"},
                             {"kind": "polynomial", "text": "t^2", "denominator": "1"}])";
    CHECK(served_at("/result/first_difference", R"({"op": "continuity", )" + different + "}") ==
          R"({"derivative": 1, "left": "1", "right": "2"})");
    CHECK(refusal_text(R"("op": "continuity", "at": 1, "maps": [{"kind": "polynomial", "text": "t"}])") ==
          "wrong_arity /maps");
    CHECK(refusal_text(R"("op": "continuity", "at": 3, )" + spline) == "outside_domain /at");
}

TEST_CASE("weights of zero are refused unless the points carry their weights") {
    const std::string points = R"("op": "evaluate", "at": ["1/2"], "map": {"kind": "bspline", "degree": 1,
                                   "knots": [0, 0, 1, 1], "control_points": )";
    CHECK(refusal_text(points + R"([[1], [2]], "weights": [1, 0]})") == "zero_weight /map/weights/1");
    CHECK(result_text(points + R"([[1, 1], [2, 0]], "homogeneous": true})") ==
          R"({"values": [["3/2", "1/2"]]})");
    CHECK(refusal_text(R"("op": "evaluate", "at": ["1/2"], "map": {"kind": "bezier", "control_points": [1, 1],
                      "weights": [1, -1]})") == "zero_weight /at/0");
}

TEST_CASE("curves are refused where they are not taken, with the kinds that are") {
    const Json response = served(R"({"op": "segments", )" + cubic + "}");
    CHECK(*at_pointer(response, "/error/message")->text() ==
          "a map of kind polynomial is not accepted here; accepted are: bspline, bspline in several "
          "directions");
    for (const std::string op : {R"("agree")", R"("segments")"}) {
        CHECK(refusal_text(R"("op": )" + op +
                           R"(, "map": {"kind": "samples", "degree": 0, "values": [[0, 1]]})") ==
              "wrong_kind /map");
    }
    CHECK(refusal_text(R"("op": "insert-knots", "knots": [1], )" + progressive) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "join", "maps": [])") == "wrong_arity /maps");
}

TEST_CASE("every operation gives rounded numbers beside the exact ones") {
    for (const std::string& request : std::vector<std::string>{
             R"("op": "subdivide", "at": 1, )" + spline, R"("op": "segments", )" + spline,
             R"("op": "elevate", "by": 1, )" + progressive, R"("op": "reduce", "to": 1, )" + spline,
             R"("op": "inverse-formula", "degree": 2)", R"("op": "insert-knots", "knots": [1], )" + polar,
             R"("op": "remove-knot", "knot": 1, )" + spline, R"("op": "continuity", "at": 2, )" + spline,
             R"("op": "roots", )" + spline, R"("op": "basis-functions", "degree": 1, "knots": [0, 0, 1, 1])",
             R"("op": "graph", )" + spline, R"("op": "convert", "to": "taylor", )" + cubic}) {
        CAPTURE(request);
        CHECK(result_text(request + R"(, "numbers": "double")").find("_double\": ") != std::string::npos);
        CHECK(result_text(request + R"(, "numbers": "hexfloat")").find("_hex\": ") != std::string::npos);
    }
}
