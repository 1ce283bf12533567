#include "answered.hpp"

// Least degrees, fields that exclude each other, and the conventions of knots.

namespace {

std::string result_at(const std::string& pointer, const std::string& request) {
    return served_at("/result" + pointer, "{" + request + "}");
}

}  // namespace

TEST_CASE("a segment of degree 0 keeps the interval of its span") {
    const std::string steps =
        R"(, "segment": 1, "map": {"kind": "bspline", "degree": 0, "knots": [0, 2, 5], "control_points": [1, 2]})";
    const auto converted = [&](const std::string& to) {
        return result_at("/map", R"("op": "convert", "to": )" + to + steps);
    };
    CHECK(converted(R"("bernstein")") ==
          R"({"kind": "bezier", "degree": 0, "interval": ["2", "5"], "control_points": ["2"]})");
    CHECK(converted(R"("hermite")") ==
          R"({"kind": "hermite", "degree": 0, "interval": ["2", "5"], "left": ["2"], "right": []})");
    CHECK(converted(R"("bspline")") ==
          R"({"kind": "bspline", "degree": 0, "knots": ["2", "5"], "control_points": ["2"]})");
    CHECK(converted(R"("bernstein", "interval": [3, 4])") ==
          R"({"kind": "bezier", "degree": 0, "interval": ["3", "4"], "control_points": ["2"]})");
    CHECK(result_at("/map/intervals", R"("op": "convert", "to": "bernstein", "segment": [1, 0], "map": {
        "kind": "bspline", "degrees": [0, 0], "knots": [[0, 2, 5], [1, 7]], "control_net": [[1], [2]]})") ==
          R"([["2", "5"], ["1", "7"]])");
}

TEST_CASE("a segment of any degree is converted over its span") {
    CHECK(result_at("/map/interval", R"("op": "convert", "to": "bernstein", "segment": 3, "map": {
        "kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 4, 4, 4], "control_points": [0, 1, 3, 4]})") ==
          R"(["1", "4"])");
}

TEST_CASE("a taylor map has the formal degree that a polynomial with the same coefficients has") {
    for (const std::string fields : {
             R"("coefficients": [1, 2, 0])",
             R"("coefficients": [0])",
             R"("coefficients": [0, 0, 0])",
             R"("coefficients": [[1, 0], [2, 0], [0, 3], [0, 0]])",
             R"("coefficients": [1, 2, 0], "degree": 2)",
             R"("coefficients": [1, 2, 0], "degree": 1)",
             R"("coefficients": [1, 2, 0], "degree": 5)",
             R"("coefficients": [1, 2, 0], "denominator": [1, 0, 0, 0])",
             R"("coefficients": [1, 0, 0], "denominator": [1, 1, 0, 0])",
             R"("coefficients": [1], "denominator": [1], "degree": 2)",
             R"("coefficients": [[1, 1], [0, 2], [0, 0]], "homogeneous": true)",
             R"("coefficients": [1, 2, 3], "degree": 1)",
             R"("coefficients": [1, 2, 3], "denominator": [0, 0])",
         }) {
        CAPTURE(fields);
        const auto of = [&](const std::string& kind) {
            return R"("op": "control-points", "map": {"kind": )" + kind + ", " + fields + "}";
        };
        CHECK(result_text(of(R"("taylor", "center": 0)")) == result_text(of(R"("polynomial")")));
    }
    CHECK(result_at("/map", R"("op": "elevate", "by": 0, "map": {"kind": "taylor", "center": 3,
        "coefficients": [1, 2, 0], "degree": 2})") ==
          R"({"kind": "taylor", "degree": 2, "center": "3", "coefficients": ["1", "2", "0"]})");
}

TEST_CASE("fields that exclude each other are refused together") {
    CHECK(
        refusal_text(R"("op": "inverse-formula", "degree": 1, "interval": [0, 1], "vertices": [[0], [1]])") ==
        "wrong_kind /interval");
    CHECK(refusal_text(
              R"("op": "control-points", "vertices": [[0, 0], [1, 0], [0, 1]], "intervals": [[0, 1], [0, 1]],
        "map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x"})") == "wrong_kind /intervals");
    CHECK(refusal_text(
              R"("op": "export", "format": "geomdl", "map": {"kind": "bezier", "control_points": [[0]]},
        "maps": [])") == "unknown_field /map");
}

TEST_CASE("knots without the two outermost ones are exported with them") {
    const auto knots = [](const std::string& map) {
        return result_at("/document/knots", R"("op": "export", "format": "tinyspline", "map": )" + map);
    };
    CHECK(
        knots(
            R"({"kind": "bspline", "degree": 3, "knots": [0, 1, 2, 3, 4, 5], "control_points": [[1], [2], [3], [4]]})") ==
        "[0, 0, 1, 2, 3, 4, 5, 5]");
    CHECK(
        knots(
            R"({"kind": "bspline", "degree": 2, "knots": [0, 0, 1, 1], "control_points": [[1], [2], [3]]})") ==
        "[0, 0, 0, 1, 1, 1]");
    // No knot occurs more than degree + 1 times: the outermost knots, on which the curve does not depend,
    // differ.
    CHECK(
        knots(
            R"({"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 1], "control_points": [[1], [2], [3], [4]]})") ==
        "[-1, 0, 0, 1, 1, 2]");
    CHECK(
        knots(
            R"({"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 1], "control_points": [[1], [2], [3], [4]]})") ==
        "[-1, 0, 0, 0, 1, 1, 1]");
}

TEST_CASE("a spline with the two outermost knots is the spline without them") {
    for (
        const char* polar : {
            R"({"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 1], "control_points": [[1], [2], [3], [4]]})",
            R"({"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 1, 1], "control_points": [[1], [2], [3], [4], [5]]})",
            R"({"kind": "bspline", "degree": 3, "knots": [0, 1, 2, 3, 4, 5], "control_points": [[1], [2], [3], [4]]})",
        }) {
        const std::string spline = std::string(R"("map": )") + polar;
        const std::string document =
            result_at("/document", R"("op": "export", "format": "geomdl", )" + spline);
        const std::string textbook =
            result_at("/maps/0", R"("op": "import", "format": "geomdl", "document": )" + document);
        CAPTURE(document);
        CHECK(result_text(R"("op": "segments", "map": )" + textbook) ==
              result_text(R"("op": "segments", )" + spline));
        CHECK(result_at("/not_nearest", R"("op": "audit", "format": "geomdl", "document": )" + document +
                                            ", " + spline) == "0");
    }
}

TEST_CASE("an underflow keeps its sign in both roundings") {
    const auto rounded = [](const std::string& number, const std::string& rounding) {
        const std::string member = rounding == "double" ? "/values_double" : "/values_hex";
        return result_at(
            member, R"("op": "evaluate", "at": ["0"], "map": {"kind": "polynomial", "coefficients": [")" +
                        number + R"("]}, "numbers": ")" + rounding + "\"");
    };
    CHECK(rounded("-1e-400", "double") == "[-0.0]");
    CHECK(rounded("-1e-400", "hexfloat") == R"(["-0x0p+0"])");
    CHECK(rounded("1e-400", "double") == "[0]");
    CHECK(rounded("1e-400", "hexfloat") == R"(["0x0p+0"])");
    CHECK(rounded("0", "double") == "[0]");
    CHECK(result_at("/document/control_points",
                    R"("op": "export", "format": "tinyspline", "map": {"kind": "bezier",
        "control_points": [["-1e-400"], ["1"]]})") == "[-0.0, 1]");
}

TEST_CASE("the power 0 of a polynomial does not hide a division by zero") {
    const auto evaluated = [](const std::string& text) {
        return refusal_text(R"("op": "evaluate", "at": ["1"], "map": {"kind": "polynomial", "text": ")" +
                            text + "\"}");
    };
    CHECK(evaluated("(1/0)^0") == "zero_denominator /map/text");
    CHECK(evaluated("(1/(t - t))^0") == "zero_denominator /map/text");
    CHECK(evaluated("(1/t)^0") == "syntax /map/text");
    CHECK(evaluated("1/(t/t)^0") == "syntax /map/text");
    CHECK(evaluated("1/0^0").starts_with(R"({"ok": true)"));
}

TEST_CASE("the least machine word among the numbers of a map has a size like any other") {
    const std::string least = "\"-9223372036854775808\"";
    for (const std::string construction : {"symmetric", "casteljau", "polarization"}) {
        const auto value = [&](const std::string& map, const std::string& arguments) {
            return result_at("/value", R"("op": "blossom", "construction": ")" + construction +
                                           R"(", "map": )" + map + R"(, "arguments": )" + arguments);
        };
        CAPTURE(construction);
        const std::string line = R"({"kind": "polynomial", "coefficients": ["0", )" + least + "]}";
        CHECK(value(line, R"([{"vector": -1}])") == R"("9223372036854775808")");
        CHECK(value(line, R"([{"vector": 1}])") == least);
        CHECK(value(line, R"([{"homogeneous": ["-1", "7"]}])") == R"("9223372036854775808")");
        const std::string third =
            R"({"kind": "polynomial", "degree": 1, "coefficients": ["-9223372036854775808/3"]})";
        CHECK(value(third, R"([{"homogeneous": ["5", "-1"]}])") == R"("9223372036854775808/3")");
        const std::string polygon = R"({"kind": "bezier", "control_points": [)" + least + ", " + least + "]}";
        CHECK(value(polygon, R"(["0"])") == least);
        CHECK(value(polygon, R"([{"homogeneous": ["0", "-1"]}])") == R"("9223372036854775808")");
    }
}

TEST_CASE("a map of a kind that is not taken is refused at its place") {
    const std::string samples = R"({"kind": "samples", "degree": 0, "values": [["0", "1"]]})";
    const std::string line = R"({"kind": "bezier", "control_points": [["0"], ["1"]]})";
    CHECK(refusal_text(R"("op": "graph", "map": )" + samples) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "export", "format": "geomdl", "map": )" + samples) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "export", "format": "geomdl", "maps": [)" + line + ", " + samples + "]") ==
          "wrong_kind /maps/1");
    const std::string arc = R"({"kind": "polynomial", "text": ["1"], "denominator": "t"})";
    CHECK(refusal_text(R"("op": "export", "format": "geomdl", "map": )" + arc) == "zero_weight /map");
    CHECK(refusal_text(R"("op": "audit", "format": "geomdl", "document": {"shape": {"type": "curve", "data": [
        {"degree": 0, "knotvector": [0, 1], "control_points": {"points": [[1]]}}]}}, "map": )" +
                       arc) == "zero_weight /map");
}

TEST_CASE("an error in what a request leaves out is at what leaves it out") {
    const std::string line = R"({"kind": "bezier", "control_points": ["0", "1"]})";
    const std::string later = R"({"kind": "bezier", "control_points": ["0", "1"], "interval": [2, 3]})";
    CHECK(refusal_text(R"("op": "join", "maps": [)" + line + ", " + line + "]") == "not_adjacent /maps/1");
    CHECK(refusal_text(R"("op": "join", "maps": [)" + line + ", " + later + "]") ==
          "not_adjacent /maps/1/interval");
    CHECK(refusal_text(R"("op": "basis-functions", "degree": 2, "knots": ["0", "1", "1"])") ==
          "bad_knots /knots");
    CHECK(refusal_text(
              R"("op": "basis-functions", "degree": 2, "convention": "polar", "knots": ["0", "1", "2"])") ==
          "bad_knots /knots");
}

TEST_CASE("the symbolic arguments have different names whatever the variables are called") {
    Limits limits;
    limits.expansion_work = 100'000;  // without the constructions that need more
    CHECK(served_at("/result/expansion", R"({"op": "agree", "map": {"kind": "polynomial",
        "variables": ["x", "x1"], "text": "x^11*x1", "degrees": [11, 1]}})",
                    limits) == R"("x_1*x_2*x_3*x_4*x_5*x_6*x_7*x_8*x_9*x_10*x_11*x1_1")");
}

TEST_CASE("a derivative keeps the degrees of the other directions where it vanishes") {
    const std::string map =
        R"(, "map": {"kind": "tensor", "degrees": [3, 1], "control_net": [[0, 1], [2, 5], [1, 1], [4, 0]]})";
    const auto degrees = [&](const std::string& direction, const std::string& order) {
        return result_at("/map/degrees",
                         R"("op": "derivative", "direction": )" + direction + R"(, "order": )" + order + map);
    };
    CHECK(degrees("[0, 1]", "1") == "[3, 0]");
    CHECK(degrees("[0, 1]", "2") == "[3, 0]");
    CHECK(degrees("[1, 0]", "5") == "[0, 1]");
}

TEST_CASE("boxes are compared along the common part of their sides, which the answer names") {
    // u v over [0, 1]^2 beside 14 v and u v over [1, 2] x [0, 1/2].
    const auto contact = [](const std::string& net, const std::string& pointer) {
        return result_at(pointer, R"("op": "continuity", "maps": [
            {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 0], [0, 1]]},
            {"kind": "tensor", "degrees": [1, 1], "control_net": )" +
                                      net + R"(, "intervals": [[1, 2], [0, "1/2"]]}])");
    };
    CHECK(contact("[[0, 7], [0, 7]]", "/order") == "-1");
    CHECK(contact("[[0, 7], [0, 7]]", "/face") == R"([["1"], ["0", "1/2"]])");
    CHECK(contact(R"([[0, "1/2"], [0, 1]])", "/order") == R"("infinite")");
    CHECK(contact(R"([[0, "1/2"], [0, 0]])", "/order") == "0");
    CHECK(refusal_text(R"("op": "continuity", "maps": [
        {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 0], [0, 1]]},
        {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 0], [0, 1]], "intervals": [[0, 1], [2, 3]]}])") ==
          "not_adjacent /maps");
}
