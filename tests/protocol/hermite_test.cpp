#include "answered.hpp"

// The kind hermite: how it is read and written; and every operation on curves takes it.

namespace {

// 1 + 2t + 4t^2 - t^3 has the derivatives 1, 2 at 0 and 13, 6 at 2, by hand.
const std::string text = R"("map": {"kind": "polynomial", "text": "1 + 2t + 4t^2 - t^3"})";
const std::string cubic =
    R"("map": {"kind": "hermite", "interval": [0, 2], "left": [1, 2], "right": [13, 6]})";
const std::string plane = R"("map": {"kind": "hermite", "left": [[0, 0], [1, 2]], "right": [[1, 0]]})";

std::string refusal_of_map(const std::string& map) {
    return refusal_text(R"("op": "evaluate", "at": [0], "map": {"kind": "hermite", )" + map + "}");
}

}  // namespace

TEST_CASE("a hermite map answers as the polynomial with these derivatives") {
    for (const std::string request :
         {R"("op": "evaluate", "at": [0, "1/3", -2, 7], )",
          R"("op": "blossom", "arguments": [1, {"vector": 1}, {"homogeneous": [3, 2]}], )",
          R"("op": "derivative", "order": 2, "at": [0, 2, 5], )", R"("op": "agree", )",
          R"("op": "agree", "arguments": [1, 2, 3], )", R"("op": "convert", "to": "monomial", )",
          R"("op": "convert", "to": "taylor", "center": 3, )",
          R"("op": "control-points", "interval": [-1, 1], )", R"("op": "roots", "interval": [4, 5], )",
          R"("op": "reduce", "to": 2, "interval": [0, 1], )"}) {
        CAPTURE(request);
        CHECK(result_text(request + cubic) == result_text(request + text));
        CHECK(result_text(request + cubic).starts_with(R"({")"));
    }
    CHECK(result_text(R"("op": "evaluate", "at": [0, 1, 2], )" + cubic) == R"({"values": ["1", "6", "13"]})");
}

TEST_CASE("the interval of a hermite map is the default of the operations") {
    const std::string points = R"("interval": ["0", "2"], "control_points": ["1", "7/3", "9", "13"]})";
    const std::string bezier = R"({"map": {"kind": "bezier", "degree": 3, )" + points + "}";
    CHECK(result_text(R"("op": "control-points", )" + cubic) == bezier);
    CHECK(result_text(R"("op": "convert", "to": "bernstein", )" + cubic) == bezier);
    CHECK(result_text(R"("op": "elevate", "by": 0, )" + cubic) == bezier);
    CHECK(served_at("/result/maps/0/interval", R"({"op": "subdivide", "at": 1, )" + cubic + "}") ==
          R"(["0", "1"])");
    CHECK(served_at("/result/map/knots", R"({"op": "convert", "to": "bspline", )" + cubic + "}") ==
          R"(["0", "0", "0", "0", "2", "2", "2", "2"])");
    CHECK(served_at("/result/order", R"({"op": "continuity", "at": 2, "maps": [)" + cubic.substr(7) + ", " +
                                         text.substr(7) + "]}") == R"("infinite")");
}

TEST_CASE("curves of every kind are converted to hermite") {
    const std::string to = R"("op": "convert", "to": "hermite", )";
    const std::string over = R"("interval": [0, 2], )";
    const std::string expected =
        R"({"map": {"kind": "hermite", "degree": 3, "interval": ["0", "2"], "left": ["1", "2"], )"
        R"("right": ["13", "6"]}})";
    CHECK(result_text(to + over + text) == expected);
    CHECK(result_text(to + cubic) == expected);
    CHECK(result_text(to + over +
                      R"("map": {"kind": "taylor", "center": 2, "coefficients": [13, 6, -2, -1]})") ==
          expected);
    CHECK(result_text(to + R"("map": {"kind": "bspline", "degree": 3, "knots": [0, 0, 0, 0, 2, 2, 2, 2],
                              "control_points": [1, "7/3", 9, 13]})") == expected);
    CHECK(
        result_text(to + R"("counts": [4, 0], )" + text) ==
        R"({"map": {"kind": "hermite", "degree": 3, "interval": ["0", "1"], "left": ["1", "2", "8", "-6"], )"
        R"("right": []}})");
    CHECK(result_text(to + R"("map": {"kind": "polynomial", "text": "t^2"})") ==
          R"({"map": {"kind": "hermite", "degree": 2, "interval": ["0", "1"], "left": ["0", "0"], )"
          R"("right": ["1"]}})");
    CHECK(result_text(to + R"("map": {"kind": "polynomial", "text": "5"})") ==
          R"({"map": {"kind": "hermite", "degree": 0, "interval": ["0", "1"], "left": ["5"], "right": []}})");
}

TEST_CASE("a rational hermite map is given by numerator and denominator, or with its weights") {
    // (1 + t) / (2 - t): numerator 1, 1 and 2; denominator 2, -1 and 1.
    const std::string divided = R"("map": {"kind": "hermite", "degree": 2, "interval": ["0", "1"], )"
                                R"("left": ["1", "1"], "right": ["2"], )"
                                R"("denominator": {"left": ["2", "-1"], "right": ["1"]}})";
    CHECK(result_text(R"("op": "evaluate", "at": [0, 1], )" + divided) == R"({"values": ["1/2", "2"]})");
    CHECK(result_text(R"("op": "convert", "to": "hermite", )" + divided) == "{" + divided + "}");
    const std::string weighted = R"("map": {"kind": "hermite", "degree": 2, "interval": ["0", "1"], )"
                                 R"("left": [["1", "2"], ["1", "-1"]], "right": [["2", "1"]], )"
                                 R"("homogeneous": true})";
    CHECK(result_text(R"("op": "evaluate", "at": [0, 1], )" + weighted) ==
          R"({"values": [["1", "2"], ["2", "1"]]})");
    CHECK(result_text(R"("op": "convert", "to": "hermite", )" + weighted) == "{" + weighted + "}");
    CHECK(refusal_of_map(R"("left": [1], "right": [], "denominator": {"left": [0], "right": []})") ==
          "zero_denominator /map/denominator");
    CHECK(refusal_of_map(R"("left": [1], "right": [], "denominator": {"left": [1, 2], "right": []})") ==
          "wrong_arity /map/denominator/left");
    CHECK(refusal_of_map(R"("left": [1], "right": [], "denominator": {"left": [1]})") ==
          "missing_field /map/denominator/right");
    CHECK(refusal_of_map(R"("left": [1], "right": [], "homogeneous": true)") ==
          "mismatched_dimensions /map/left");
}

TEST_CASE("hermite data are refused at the place that is wrong") {
    CHECK(refusal_of_map(R"("left": [1])") == "missing_field /map/right");
    CHECK(refusal_of_map(R"("left": [], "right": [])") == "wrong_arity /map/left");
    CHECK(refusal_of_map(R"("left": [1, 0.5], "right": [])") == "inexact_number /map/left/1");
    CHECK(refusal_of_map(R"("left": [1, [2]], "right": [])") == "mismatched_dimensions /map/left/1");
    CHECK(refusal_of_map(R"("left": [1], "right": [[1]])") == "mismatched_dimensions /map/right/0");
    CHECK(refusal_of_map(R"("left": [1], "right": [1], "interval": [2, 2])") ==
          "empty_interval /map/interval");
    CHECK(refusal_of_map(R"("left": [1], "right": [1], "degree": 3)") == "wrong_arity /map/degree");
    CHECK(refusal_of_map(R"("left": [1], "right": [1], "weights": [1])") == "unknown_field /map/weights");
    const std::string to = R"("op": "convert", "to": "hermite", )";
    CHECK(refusal_text(to + R"("counts": [2, 3], )" + text) == "wrong_arity /counts");
    CHECK(refusal_text(to + R"("counts": [4], )" + text) == "wrong_arity /counts");
    CHECK(refusal_text(R"("op": "convert", "to": "monomial", "counts": [2, 2], )" + text) ==
          "unknown_field /counts");
    CHECK(refusal_text(R"("op": "segments", )" + cubic) == "wrong_kind /map");
}

TEST_CASE("the picture of a hermite map has its control polygon") {
    const Json request = parse_json(R"({"op": "evaluate", "at": ["1/2"], )" + plane + "}", Limits{});
    const Answer answer = find_answer(request, Limits{});
    const std::string svg = find_operation("evaluate").plot({request, answer, Limits{}, Style()});
    // The curve and its control polygon.
    CHECK(svg.find("class=\"curve ") != std::string::npos);
    CHECK(svg.find("class=\"line ") != std::string::npos);
}

TEST_CASE("a hermite map is shown, explained, certified and rounded") {
    const Json given = parse_json("{" + plane + "}", Limits{});
    const Map map = read_map(*given.find("map"), Limits{});
    CHECK(description(map) ==
          "P: curve of degree 2 with the value and derivatives at 0: (0, 0), (1, 2); at 1: (1, 0)");
    CHECK(result_text(R"("op": "evaluate", "at": ["1/2"], "pyramid": true, )" + plane)
              .starts_with(R"({"values": [["1/2", "1/2"]], "pyramids": [[[["0", "0"], )"));
    CHECK(served_at("/ok", R"({"op": "explain", "request": {"op": "evaluate", "at": ["1/2"], )" + plane +
                               "}}") == "true");
    const std::string certificate = served_at(
        "/result/document",
        R"({"op": "certify", "requests": [{"op": "blossom", "arguments": [1, 2], )" + plane + "}]}");
    CHECK(certificate.find("given left derivative 1 = 2 p[0, delta] = (1, 2)") != std::string::npos);
    CHECK(certificate.find("given right derivative 0 = p[1 (2 times)] = (1, 0)") != std::string::npos);
    CHECK(served_at("/result/map/left_double", R"({"op": "convert", "to": "hermite", "numbers": "double", )" +
                                                   plane + "}") == "[[0, 0], [1, 2]]");
}
