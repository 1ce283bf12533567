#include "answered.hpp"

// Patches in other forms, derived rational patches, and contact of patches with weights or of B-splines.

namespace {

const std::string triangle = R"("map": {"kind": "simplex", "degree": 2, "vertices": [[0, 0], [2, 0], [0, 1]],
    "control_net": [[[2, 0, 0], -2], [[1, 1, 0], -2], [[1, 0, 1], -2], [[0, 2, 0], 2], [[0, 1, 1], 1], [[0, 0, 2], -2]]})";
// x^2 + 3 x y - 2, the same.
const std::string polynomial =
    R"("map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x^2 + 3x*y - 2"})";
const std::string box = R"("map": {"kind": "tensor", "degrees": [2, 1], "intervals": [[0, 1], [0, 2]],
    "control_net": [[-2, -2], [-2, 1], [-1, 5]]})";
const std::string at = R"("at": [["1/2", 3], [-1, "2/7"]])";

std::string map_of_result(const std::string& request) {
    return served_at("/result/map", "{" + request + "}");
}

std::string values_of(const std::string& map) {
    return result_text(R"("op": "evaluate", )" + at + ", " + map);
}

}  // namespace

TEST_CASE("a patch in every other form has the same values") {
    for (const std::string& map : {triangle, polynomial, box}) {
        for (const std::string form : {"monomial", "bernstein", "tensor", "simplex"}) {
            const std::string converted = map_of_result(R"("op": "convert", "to": ")" + form + "\", " + map);
            CAPTURE(converted);
            CHECK(values_of(R"("map": )" + converted) == values_of(polynomial));
            const std::string kind = form == "monomial"    ? "polynomial"
                                     : form == "bernstein" ? (map == box ? "tensor" : "simplex")
                                                           : form;
            CHECK(converted.starts_with(R"({"kind": ")" + kind + '"'));
        }
    }
    CHECK(map_of_result(R"("op": "convert", "to": "monomial", )" + triangle)
              .find(R"("variables": ["x", "y"])") != std::string::npos);
    // The least box around the triangle, and the triangle at the first corner of the box.
    CHECK(map_of_result(R"("op": "convert", "to": "tensor", )" + triangle)
              .find(R"("intervals": [["0", "2"], ["0", "1"]])") != std::string::npos);
    CHECK(map_of_result(R"("op": "convert", "to": "simplex", )" + box)
              .find(R"("vertices": [["0", "0"], ["1", "0"], ["0", "2"]])") != std::string::npos);
    CHECK(map_of_result(
              R"("op": "convert", "to": "tensor", "intervals": [[1, 2], [3, 4]], "degrees": [2, 3], )" +
              triangle)
              .starts_with(R"({"kind": "tensor", "degrees": [2, 3], "intervals": [["1", "2"], ["3", "4"]])"));
}

TEST_CASE("a box becomes B-splines of one span, and B-splines become polynomials by segments") {
    const std::string spline = map_of_result(R"("op": "convert", "to": "bspline", )" + box);
    CHECK(
        spline ==
        R"({"kind": "bspline", "degrees": [2, 1], "knots": [["0", "0", "0", "1", "1", "1"], ["0", "0", "2", "2"]], )"
        R"("control_net": [["-2", "-2"], ["-2", "1"], ["-1", "5"]]})");
    CHECK(map_of_result(R"("op": "convert", "to": "bspline", "map": )" + spline) == spline);
    CHECK(values_of(R"("map": )" + map_of_result(R"("op": "convert", "to": "monomial", "map": )" + spline)) ==
          values_of(polynomial));
    const std::string refined =
        R"("map": )" + map_of_result(R"("op": "insert-knots", "knots": [["1/2"], []], "map": )" + spline);
    CHECK(refusal_text(R"("op": "convert", "to": "monomial", )" + refined) == "outside_domain /segment");
    CHECK(values_of(R"("map": )" + map_of_result(R"("op": "convert", "to": "simplex", "segment": [3, 1], )" +
                                                 refined)) == values_of(polynomial));
}

TEST_CASE("forms that a patch does not have are refused") {
    CHECK(refusal_text(R"("op": "convert", "to": "hermite", )" + box) == "wrong_kind /to");
    CHECK(refusal_text(R"("op": "convert", "to": "bspline", )" + triangle) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "convert", "to": "tensor", "degrees": [1, 1], )" + triangle) ==
          "degree_too_low /degrees");
    CHECK(refusal_text(R"("op": "convert", "to": "tensor", "vertices": [[0, 0], [1, 0], [0, 1]], )" + box) ==
          "wrong_kind /vertices");
    CHECK(refusal_text(R"("op": "convert", "to": "simplex", "intervals": [[0, 1], [0, 1]], )" + box) ==
          "wrong_kind /intervals");
    const std::string barycentric =
        R"("map": {"kind": "simplex", "degree": 1, "control_net": [[[1, 0], 0], [[0, 1], 1]]})";
    CHECK(refusal_text(R"("op": "convert", "to": "monomial", )" + barycentric) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "convert", "to": "tensor", )" + barycentric) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "convert", "to": "tensor", "map": {"kind": "polynomial", "text": "t"})") ==
          "wrong_kind /to");
}

TEST_CASE("the derived map of a rational patch has the values of the derivative") {
    const std::string rational =
        R"("map": {"kind": "polynomial", "variables": ["x", "y"], "text": ["x*y", "x"], "denominator": "5 + x + y^2")";
    const std::string net = R"("map": )" + map_of_result(R"("op": "control-points", )" + rational + "}");
    const std::string boxed =
        R"("map": )" + map_of_result(R"("op": "convert", "to": "tensor", )" + rational + "}");
    for (const std::string& map : {rational + "}", rational + R"(, "degrees": [1, 2]})", net, boxed}) {
        for (const std::string direction :
             {R"("direction": [1, 0])", R"("direction": [2, "1/3"], "order": 2)",
              R"("directions": [[1, 0], [0, 1], [1, 1]])", R"("direction": [1, 1], "order": 0)"}) {
            const std::string request = R"("op": "derivative", )" + direction + ", ";
            CAPTURE(map, direction);
            CHECK(values_of(R"("map": )" + map_of_result(request + map)) ==
                  result_text(request + at + ", " + map));
        }
    }
    CHECK(
        map_of_result(R"("op": "derivative", "direction": [1, 0], )" + rational + "}").find("denominator") !=
        std::string::npos);
    Limits limits;
    limits.numbers = 100;
    CHECK(refusal_text(R"("op": "derivative", "direction": [1, 0], "order": 3, )" + rational + "}", limits)
              .starts_with("limit_exceeded"));
}

TEST_CASE("rational patches meet as the maps that they are, polynomial ones as maps of weight 1") {
    const std::string left = R"({"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 0], [1, 2]])";
    const std::string right =
        R"({"kind": "tensor", "degrees": [1, 1], "intervals": [[1, 2], [0, 1]], "control_net": [[1, 2], [2, 4]])";
    const auto order = [&](const std::string& first, const std::string& second) {
        return served_at("/result/order", R"({"op": "continuity", "maps": [)" + first + ", " + second + "]}");
    };
    CHECK(order(left + "}", right + "}") == R"("infinite")");
    // Multiplied by 2 in all coordinates.
    const std::string twice = R"(, "weights": [[2, 2], [2, 2]]})";
    CHECK(order(left + "}", right + twice) == R"("infinite")");
    CHECK(order(left + twice, right + "}") == R"("infinite")");
    CHECK(order(left + R"(, "weights": [[1, 1], [2, 2]]})", right + "}") == "0");
    CHECK(
        result_text(R"("op": "continuity", "maps": [)" + left + twice + ", " + right +
                    R"(, "weights": [[1, 1], [1, 3]]}])") ==
        R"({"order": 0, "first_difference": {"arguments": [["0", "1"], ["0", "1"]], "left": "1/2", "right": "-5/2"}, )"
        R"("reason": "The patches meet with order 0 along the face: of the points of each multiplied by the )"
        R"(weight of the other, the blossom values at [0, 1; 0, 1] are 1/2 and -5/2"})");
    CHECK(
        refusal_text(R"("op": "continuity", "maps": [)" + left + "}, " + right + R"(, "homogeneous": true}])")
            .starts_with("mismatched_dimensions"));
}

TEST_CASE("B-splines in two directions are as smooth at a knot as their least smooth row") {
    const std::string surface = R"("map": {"kind": "bspline", "degrees": [2, 1],
        "knots": [[0, 0, 0, 1, 2, 2, 2], [0, 0, 1, 1]], "control_net": [[0, 0], [0, 0], [0, 0], [0, 1]]})";
    const auto order = [&](const std::string& place) {
        return served_at("/result/order", R"({"op": "continuity", "at": )" + place + ", " + surface + "}");
    };
    CHECK(order("[1, null]") == "1");
    CHECK(order(R"(["1/2", null])") == R"("infinite")");
    CHECK(
        result_text(R"("op": "continuity", "at": [1, null], )" + surface) ==
        R"({"order": 1, "first_difference": {"arguments": [["0", "0"], ["1"]], "left": "0", "right": "1"}, )"
        R"("reason": "The patches meet with order 1 along the face: the blossom values at [0, 0; 1] are 0 and 1"})");
    CHECK(refusal_text(R"("op": "continuity", "at": [1, 0], )" + surface) == "wrong_arity /at");
    CHECK(refusal_text(R"("op": "continuity", "at": [2, null], )" + surface) == "outside_domain /at/0");
    CHECK(refusal_text(R"("op": "continuity", "at": 1, )" + surface) == "wrong_kind /at");
}
