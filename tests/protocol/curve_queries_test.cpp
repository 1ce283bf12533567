#include <string>

#include "answered.hpp"

namespace {

const std::string parabola = R"("map": {"kind": "polynomial", "text": ["t", "t^2"]})";
/// Semicircles around (0, 0) and (4, 0), joined smoothly at (2, 0) in opposite bends.
const std::string wave =
    R"("map": {"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2], "control_points": [[0, 0], [1, 1], [3, -1], [4, 0]]})";

}  // namespace

TEST_CASE("extrema at the ends, at knots and in constant parts are told apart") {
    CHECK(
        result_text(
            R"("op": "extrema", "map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 2], "control_points": [0, 1, 0]})") ==
        R"({"interval": ["0", "2"], "extrema": [{"kind": "minimum", "parameter": {"value": "0", "double": 0}, "value": {"value": "0", "double": 0}}, {"kind": "maximum", "parameter": {"value": "1", "double": 1}, "value": {"value": "1", "double": 1}}, {"kind": "minimum", "parameter": {"value": "2", "double": 2}, "value": {"value": "0", "double": 0}}], "least": {"value": {"value": "0", "double": 0}, "parameters": [{"value": "0", "double": 0}, {"value": "2", "double": 2}]}, "greatest": {"value": {"value": "1", "double": 1}, "parameters": [{"value": "1", "double": 1}]}})");
    CHECK(
        result_text(R"("op": "extrema", "map": {"kind": "polynomial", "text": "3"})") ==
        R"({"interval": ["-inf", "inf"], "extrema": [], "constant": [["-inf", "inf"]], "least": {"value": {"value": "3", "double": 3}, "parameters": [], "constant": [["-inf", "inf"]]}, "greatest": {"value": {"value": "3", "double": 3}, "parameters": [], "constant": [["-inf", "inf"]]}})");
    // 1 / (1 + t^2) comes near to 0 but does not take it.
    CHECK(
        result_text(
            R"("op": "extrema", "map": {"kind": "polynomial", "text": "1", "denominator": "1 + t^2"})") ==
        R"({"interval": ["-inf", "inf"], "extrema": [{"kind": "maximum", "parameter": {"value": "0", "double": 0}, "value": {"value": "1", "double": 1}}], "greatest": {"value": {"value": "1", "double": 1}, "parameters": [{"value": "0", "double": 0}]}})");
    CHECK(
        refusal_text(R"("op": "extrema", "map": {"kind": "polynomial", "text": "1", "denominator": "t"})") ==
        "zero_weight /map");
    CHECK(refusal_text(R"("op": "extrema", )" + parabola) == "mismatched_dimensions /map");
    CHECK(refusal_text(R"("op": "extrema", "direction": [1], )" + parabola) ==
          "mismatched_dimensions /direction");
}

TEST_CASE("all nearest points are found, and arcs of them") {
    const std::string arc =
        R"("map": {"kind": "bezier", "control_points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]})";
    CHECK(
        result_text(R"("op": "nearest", "point": [0, 0], )" + arc) ==
        R"({"interval": ["0", "1"], "squared_distance": {"value": "1", "double": 1}, "nearest": [], "constant": [["0", "1"]]})");
    CHECK(
        result_text(R"("op": "nearest", "point": [2, 0], )" + arc) ==
        R"({"interval": ["0", "1"], "squared_distance": {"value": "1", "double": 1}, "nearest": [{"parameter": {"value": "0", "double": 0}, "point": [{"value": "1", "double": 1}, {"value": "0", "double": 0}]}]})");
    CHECK(refusal_text(R"("op": "nearest", "point": [0, 0, 0], )" + parabola) ==
          "mismatched_dimensions /point");
}

TEST_CASE("inflections are zeros of the curvature or its jumps between signs") {
    CHECK(
        result_text(R"("op": "inflections", )" + wave) ==
        R"({"interval": ["0", "2"], "inflections": [{"kind": "inflection", "parameter": {"value": "1", "double": 1}, "multiplicity": 0}]})");
    CHECK(
        result_text(R"("op": "inflections", "map": {"kind": "polynomial", "text": ["t", "t^4"]})") ==
        R"({"interval": ["-inf", "inf"], "inflections": [{"kind": "flat", "parameter": {"value": "0", "double": 0}, "multiplicity": 2}]})");
    CHECK(
        result_text(R"("op": "inflections", "map": {"kind": "polynomial", "text": ["t^3", "t^5"]})") ==
        R"({"interval": ["-inf", "inf"], "inflections": [{"kind": "singular", "parameter": {"value": "0", "double": 0}, "multiplicity": 5}]})");
    CHECK(refusal_text(R"("op": "inflections", "map": {"kind": "polynomial", "text": "t"})") ==
          "mismatched_dimensions /map");
}

TEST_CASE("a line is cut where the curve is finite, and may hold parts of it") {
    // The hyperbola (t, 1 / t) meets y = 0 at infinity only.
    CHECK(
        result_text(
            R"("op": "intersections", "line": [0, 1, 0], "map": {"kind": "polynomial", "text": ["t^2", "1"], "denominator": "t"})") ==
        R"({"interval": ["-inf", "inf"], "intersections": []})");
    CHECK(refusal_text(R"("op": "intersections", "line": [1, 2], )" + parabola) ==
          "mismatched_dimensions /line");
}

TEST_CASE("common roots are those of the greatest common divisor") {
    CHECK(
        result_text(
            R"("op": "roots", "map": {"kind": "polynomial", "text": "0"}, "with": [{"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 2], "control_points": [1, 0, 0]}])") ==
        R"({"interval": ["-inf", "inf"], "roots": [], "zeros": [["1", "2"]]})");
    CHECK(
        refusal_text(
            R"("op": "roots", "map": {"kind": "polynomial", "text": "t"}, "with": [{"kind": "polynomial", "text": ["t", "t"]}])") ==
        "wrong_kind /with/0");
}

TEST_CASE("two curves meet in points with their contact, or have parts in common") {
    CHECK(
        result_text(R"("op": "intersections", "with": {"kind": "polynomial", "text": ["t", "t^4"]}, )" +
                    parabola) ==
        R"({"interval": ["-inf", "inf"], "with_interval": ["-inf", "inf"], "intersections": [{"parameters": [{"value": "-1", "double": -1}, {"value": "-1", "double": -1}], "point": [{"value": "-1", "double": -1}, {"value": "1", "double": 1}], "multiplicity": 1}, {"parameters": [{"value": "0", "double": 0}, {"value": "0", "double": 0}], "point": [{"value": "0", "double": 0}, {"value": "0", "double": 0}], "multiplicity": 2}, {"parameters": [{"value": "1", "double": 1}, {"value": "1", "double": 1}], "point": [{"value": "1", "double": 1}, {"value": "1", "double": 1}], "multiplicity": 1}]})");
    // Two parts of one line that meet at their ends have a point in common, but no order of contact.
    CHECK(
        result_text(
            R"("op": "intersections", "map": {"kind": "bezier", "control_points": [[0, 0], [1, 1]]}, "with": {"kind": "bezier", "control_points": [[1, 1], [2, 2]]})") ==
        R"({"interval": ["0", "1"], "with_interval": ["0", "1"], "intersections": [{"parameters": [{"value": "1", "double": 1}, {"value": "0", "double": 0}], "point": [{"value": "1", "double": 1}, {"value": "1", "double": 1}]}]})");
    CHECK(
        result_text(
            R"("op": "intersections", "map": {"kind": "bezier", "control_points": [[0, 0], [2, 2]]}, "with": {"kind": "bezier", "control_points": [[3, 3], [1, 1]]})") ==
        R"({"interval": ["0", "1"], "with_interval": ["0", "1"], "intersections": [], "overlaps": [{"intervals": [[{"value": "1/2", "double": 0.5}, {"value": "1", "double": 1}], [{"value": "1/2", "double": 0.5}, {"value": "1", "double": 1}]], "reversed": true}]})");
    // A parabola above a line.
    CHECK(result_text(R"("op": "intersections", "with": {"kind": "polynomial", "text": ["t", "t - 1"]}, )" +
                      parabola) ==
          R"({"interval": ["-inf", "inf"], "with_interval": ["-inf", "inf"], "intersections": []})");
    CHECK(refusal_text(R"("op": "intersections", )" + parabola) == "missing_field /with");
    CHECK(
        refusal_text(
            R"("op": "intersections", "line": [1, 1, 1], "with": {"kind": "polynomial", "text": ["t", "t"]}, )" +
            parabola) == "wrong_kind /line");
    CHECK(refusal_text(R"("op": "intersections", "with": {"kind": "polynomial", "text": "t"}, )" +
                       parabola) == "mismatched_dimensions /with");
}

TEST_CASE("a spline that crosses another one at a knot has one intersection there") {
    CHECK(
        result_text(
            R"("op": "intersections", "map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 2], "control_points": [[0, 0], [1, 1], [2, 0]]}, "with": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 2], "control_points": [[1, 0], [1, 1], [1, 2]]})") ==
        R"({"interval": ["0", "2"], "with_interval": ["0", "2"], "intersections": [{"parameters": [{"value": "1", "double": 1}, {"value": "1", "double": 1}], "point": [{"value": "1", "double": 1}, {"value": "1", "double": 1}], "multiplicity": 1}]})");
}

TEST_CASE("self-intersections, closed ends and cusps are told apart") {
    CHECK(
        result_text(
            R"("op": "self-intersections", "map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 2, 3, 4, 4], "control_points": [[0, 0], [2, 2], [2, 0], [0, 2], [0, 0]]})") ==
        R"({"interval": ["0", "4"], "intersections": [{"kind": "closed", "parameters": [{"value": "0", "double": 0}, {"value": "4", "double": 4}], "point": [{"value": "0", "double": 0}, {"value": "0", "double": 0}], "multiplicity": 1}, {"kind": "double", "parameters": [{"value": "1/2", "double": 0.5}, {"value": "5/2", "double": 2.5}], "point": [{"value": "1", "double": 1}, {"value": "1", "double": 1}], "multiplicity": 1}], "cusps": []})");
    CHECK(
        result_text(R"("op": "self-intersections", "map": {"kind": "polynomial", "text": ["t^2", "t^3"]})") ==
        R"({"interval": ["-inf", "inf"], "intersections": [], "cusps": [{"value": "0", "double": 0}]})");
}
