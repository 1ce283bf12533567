#include <string>

#include "answered.hpp"

namespace {

/// The roots of a map, and what else the result has.
std::string roots_of(const std::string& map, const std::string& others = "") {
    return result_text(R"("op": "roots", "map": )" + map + others);
}

/// A spline of degree 1 over the knots 0, 0, 1, ..., n, n.
std::string polygon(const std::string& knots, const std::string& values) {
    return R"({"kind": "bspline", "degree": 1, "knots": [)" + knots + R"(], "control_points": [)" + values +
           "]}";
}

}  // namespace

TEST_CASE("roots are found once, with their multiplicities, on splines and rational maps too") {
    CHECK(
        roots_of(R"({"kind": "polynomial", "text": "(t + 2)(t - 1)^2"})", R"(, "interval": [3, -3])") ==
        R"({"interval": ["-3", "3"], "roots": [{"value": "-2", "multiplicity": 1, "double": -2}, {"value": "1", "multiplicity": 2, "double": 1}]})");
    CHECK(roots_of(polygon("0, 0, 1, 2, 2", "1, 0, -1")) ==
          R"({"interval": ["0", "2"], "roots": [{"value": "1", "multiplicity": 1, "double": 1}]})");
    CHECK(
        roots_of(polygon("0, 0, 1, 2, 2", "1, -1, 0")) ==
        R"({"interval": ["0", "2"], "roots": [{"value": "1/2", "multiplicity": 1, "double": 0.5}, {"value": "2", "multiplicity": 1, "double": 2}]})");
    CHECK(roots_of(R"({"kind": "polynomial", "text": "t^2 - 1/4t", "denominator": "t"})") ==
          R"({"interval": ["-inf", "inf"], "roots": [{"value": "1/4", "multiplicity": 1, "double": 0.25}]})");
    CHECK(refusal_text(R"("op": "roots", "map": {"kind": "polynomial", "text": ["t", "t"]})") ==
          "wrong_kind /map");
    CHECK(refusal_text(R"("op": "roots", "width": 0, "map": {"kind": "polynomial", "text": "t"})") ==
          "wrong_kind /width");
}

TEST_CASE("where a spline is zero between two parameters, these are stated beside its roots") {
    CHECK(roots_of(polygon("0, 0, 1, 2, 3, 3", R"("-1", "0", "0", "1")")) ==
          R"({"interval": ["0", "3"], "roots": [], "zeros": [["1", "2"]]})");
    CHECK(roots_of(R"({"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 1, 2, 3, 4, 5, 5, 5],
                       "control_points": [0, 0, 0, 1, 0, 0, 0]})") ==
          R"({"interval": ["0", "5"], "roots": [], "zeros": [["0", "1"], ["4", "5"]]})");
    const std::string both = polygon("0, 0, 1, 2, 3, 4, 5, 5", "-1, 1, 0, 0, 0, 1");
    CHECK(
        roots_of(both) ==
        R"({"interval": ["0", "5"], "roots": [{"value": "1/2", "multiplicity": 1, "double": 0.5}], "zeros": [["2", "4"]]})");
    CHECK(roots_of(both, R"(, "interval": [3, 9])") ==
          R"({"interval": ["3", "5"], "roots": [], "zeros": [["3", "4"]]})");
    CHECK(roots_of(both, R"(, "interval": [1, 2])") ==
          R"({"interval": ["1", "2"], "roots": [], "zeros": [["2", "2"]]})");
    CHECK(roots_of(both, R"(, "interval": ["4", "inf"])") ==
          R"({"interval": ["4", "5"], "roots": [{"value": "4", "multiplicity": 1, "double": 4}]})");
    CHECK(roots_of(polygon("0, 0, 2, 2", "0, 0")) ==
          R"({"interval": ["0", "2"], "roots": [], "zeros": [["0", "2"]]})");
}

TEST_CASE("a jump has the value on its right, so that only this is a root") {
    const std::string from_zero = polygon("0, 0, 1, 1, 2, 2", "1, 0, 1, 1");
    CHECK(roots_of(from_zero) == R"({"interval": ["0", "2"], "roots": []})");
    CHECK(roots_of(from_zero, R"(, "interval": [0, 1])") == R"({"interval": ["0", "1"], "roots": []})");
    CHECK(roots_of(polygon("0, 0, 1, 1, 2, 2", "1, 1, 0, 1"), R"(, "interval": [0, 1])") ==
          R"({"interval": ["0", "1"], "roots": [{"value": "1", "multiplicity": 1, "double": 1}]})");
}

TEST_CASE("a map without an interval has all its real roots, which an interval may ask for too") {
    const std::string square = R"({"kind": "polynomial", "text": "t^2 - 4"})";
    const std::string all =
        R"("roots": [{"value": "-2", "multiplicity": 1, "double": -2}, {"value": "2", "multiplicity": 1, "double": 2}]})";
    CHECK(roots_of(square) == R"({"interval": ["-inf", "inf"], )" + all);
    CHECK(roots_of(square, R"(, "interval": ["inf", "-inf"])") == R"({"interval": ["-inf", "inf"], )" + all);
    CHECK(roots_of(square, R"(, "interval": [0, "inf"], "numbers": "double")") ==
          R"({"interval": ["0", "inf"], "interval_double": [0, "inf"], "roots": [{"value": "2", )"
          R"("value_double": 2, "multiplicity": 1, "double": 2}]})");
    CHECK(roots_of(R"({"kind": "bezier", "control_points": [-1, 0, 3]})") ==
          R"({"interval": ["0", "1"], "roots": [{"interval": ["1/4", "1/2"], "multiplicity": 1, )"
          R"("double": 0.36602540378443865}]})");
    CHECK(refusal_text(R"("op": "roots", "interval": ["inf", "inf"], "map": )" + square) ==
          "empty_interval /interval");
    CHECK(refusal_text(R"("op": "roots", "interval": ["inf"], "map": )" + square) == "wrong_arity /interval");
    CHECK(refusal_text(R"("op": "roots", "interval": [0, "infinity"], "map": )" + square) ==
          "not_a_number /interval/1");
}

TEST_CASE("the double of a root is the nearest, and left out beyond the doubles") {
    CHECK(roots_of(R"({"kind": "polynomial", "text": "t^2 - 2e800"})").find("double") == std::string::npos);
    const std::string tiny = roots_of(R"({"kind": "polynomial", "text": "t^2 - 2e-800"})");
    CHECK(tiny.find(R"("double": -0.0)") != std::string::npos);
    CHECK(tiny.find(R"("double": 0)") != std::string::npos);
    CHECK(roots_of(R"({"kind": "polynomial", "text": "t^3 - 2e-900"})")
              .find(R"("double": 1.2599210498948732e-300)") != std::string::npos);
}
