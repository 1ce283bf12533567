#include <string>

#include "answered.hpp"

namespace {

const std::string box =
    R"("map": {"kind": "tensor", "degrees": [2, 1], "control_net": [[0, 1], [2, 0], [1, 3]]})";
const std::string triangle =
    R"("map": {"kind": "simplex", "degree": 1, "vertices": [[0, 0], [2, 0], [0, 2]],
        "control_net": [[[1, 0, 0], 0], [[0, 1, 0], 4], [[0, 0, 1], 8]]})";
const std::string barycentric =
    R"("map": {"kind": "simplex", "degree": 1, "control_net": [[[1, 0, 0], 0], [[0, 1, 0], 4], [[0, 0, 1], 8]]})";

/// A sheet over the unit square of space, which goes on from its edge u = 1 with these points.
std::string two_sheets(const std::string& last, const std::string& more) {
    return R"("op": "continuity", "maps": [
        {"kind": "tensor", "degrees": [1, 1], "control_net": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 1], [1, 1, 1]]]},
        {"kind": "tensor", "degrees": [1, 1], "control_net": [[[1, 0, 1], [1, 1, 1]], )" +
           last + "]}]" + more;
}

const std::string by_name = R"(, "faces": [[[1, 0], [1, 1]], [[0, 0], [0, 1]]], "geometric": true)";

std::string geometric(const std::string& member, const std::string& last, const std::string& more = by_name) {
    return served_at("/result/geometric/" + member, "{" + two_sheets(last, more) + "}");
}

}  // namespace

TEST_CASE("patches are reduced to degrees that are lower in each direction") {
    const auto reduce = [](const std::string& to, const std::string& map) {
        return R"("op": "reduce", "to": )" + to + ", " + map;
    };
    // The best line to (u - 1/2)^2 is 1/12, with the error 1/180.
    const std::string square =
        R"("map": {"kind": "tensor", "degrees": [2, 0], "control_net": [["1/4"], ["-1/4"], ["1/4"]]})";
    CHECK(
        result_text(reduce("[1, 0]", square)) ==
        R"({"map": {"kind": "tensor", "degrees": [1, 0], "intervals": [["0", "1"], ["0", "1"]], "control_net": [["1/12"], ["1/12"]]}, "exact": false, "error": {"l2_squared": "1/180"}})");
    CHECK(served_at("/result/exact", "{" + reduce("1", triangle) + "}") == "true");
    CHECK(served_at("/result/error/l2_squared", "{" + reduce("0", triangle) + "}") == R"("16/3")");
    CHECK(refusal_text(reduce("[1]", box)) == "wrong_arity /to");
    CHECK(refusal_text(reduce("[3, 1]", box)) == "degree_too_low /to");
    CHECK(refusal_text(reduce("2", triangle)) == "degree_too_low /to");
    CHECK(refusal_text(reduce("1", box) + R"(, "method": "uniform")") == "wrong_kind /method");
    CHECK(refusal_text(reduce("1", triangle) + R"(, "method": "inverse-formula")") == "wrong_kind /method");
    CHECK(refusal_text(reduce("1", box) + R"(, "interval": [0, 1])") == "unknown_field /interval");
}

TEST_CASE("a patch is expanded at a point, and read back") {
    const std::string convert = R"("op": "convert", "to": "taylor", )";
    CHECK(
        result_text(convert + triangle + R"(, "center": [1, "1/2"])") ==
        R"({"map": {"kind": "taylor", "variables": ["x", "y"], "degree": 1, "center": ["1", "1/2"], "terms": [[[0, 0], "4"], [[0, 1], "4"], [[1, 0], "2"]]}})");
    CHECK(served_at("/result/map/center", "{" + convert + box + "}") == R"(["0", "0"])");
    CHECK(refusal_text(convert + box + R"(, "center": [1])") == "mismatched_dimensions /center");
    CHECK(refusal_text(convert + barycentric) == "wrong_kind /map");
    const std::string expansion =
        R"("map": {"kind": "taylor", "variables": ["x", "y"], "center": [1, -1], "degrees": [2, 1], "terms": [[[2, 1], 3]]})";
    CHECK(result_text(R"("op": "evaluate", "at": [[3, 1]], )" + expansion) == R"({"values": ["24"]})");
    CHECK(served_at("/result/map/terms", R"({"op": "derivative", "direction": [0, 1], )" + expansion + "}") ==
          R"([[[2, 0], "3"]])");
    CHECK(
        refusal_text(
            R"("op": "evaluate", "at": [[3, 1]], "map": {"kind": "taylor", "variables": ["x", "y"], "center": [1], "terms": [[[2, 1], 3]]})") ==
        "mismatched_dimensions /map/center");
}

TEST_CASE("the pyramid of a patch has its nets, one direction after the other") {
    CHECK(served_at("/result/pyramids",
                    R"({"op": "evaluate", "at": [["1/2", "1/2"]], "pyramid": true, )" + box + "}") ==
          R"([[["0", "1", "2", "0", "1", "3"], ["1/2", "1", "2"], ["3/4", "3/2"], ["9/8"]]])");
    CHECK(served_at("/result/pyramids", R"({"op": "evaluate", "at": [[1, 0]], "pyramid": true, )" + triangle +
                                            "}") == R"([[["0", "4", "8"], ["2"]]])");
}

TEST_CASE("tangent planes are compared along an edge, with functions or a parameter as the reason") {
    CHECK(geometric("order", "[[3, 0, 3], [2, 1, 2]]") == "1");
    CHECK(geometric("edges/0/kind", "[[3, 0, 3], [2, 1, 2]]") == R"("smooth")");
    CHECK(geometric("edges/0/alpha", "[[3, 0, 3], [2, 1, 2]]") == R"("2 - t")");
    CHECK(geometric("edges/0/beta", "[[3, 0, 3], [2, 1, 2]]") == R"("1")");
    CHECK(geometric("edges/0/kind", "[[-1, 0, -1], [0, 1, 0]]") == R"("folded")");
    CHECK(geometric("order", "[[-1, 0, -1], [0, 1, 0]]") == "0");
    CHECK(geometric("edges/0/kind", "[[3, 0, 3], [2, 1, 5]]") == R"("bent")");
    CHECK(geometric("edges/0/vectors", "[[3, 0, 3], [2, 1, 5]]") ==
          R"([["-1", "0", "-1"], ["1", "0", "4"], ["0", "1", "0"]])");
    // Y = (2 - 4t, 0, 2 - 4t) vanishes for t = 1/2.
    CHECK(geometric("edges/0/singular", "[[3, 0, 3], [-1, 1, -1]]") == R"(["1/2"])");
    CHECK(geometric("edges/0/singular", "[[1, 0, 1], [1, 1, 1]]") == "[]");
    CHECK(geometric("edges/0/kind", "[[1, 0, 1], [1, 2, 1]]") == R"("singular")");
    const std::string apart = R"(, "faces": [[[1, 0], [1, 1]], [[0, 1], [0, 0]]], "geometric": true)";
    CHECK(geometric("order", "[[3, 0, 3], [2, 1, 2]]", apart) == "-1");
    const std::string found = R"(, "faces": "found", "geometric": true)";
    CHECK(geometric("edges/0/right", "[[3, 0, 3], [2, 1, 2]]", found) == R"([["0", "0"], ["0", "1"]])");
}

TEST_CASE("two quarters of a cylinder go on in each other, by their homogeneous points") {
    const auto quarter = [](const std::string& points) {
        return R"({"kind": "tensor", "degrees": [2, 1], "weights": [[1, 1], [1, 1], [2, 2]], "control_net": )" +
               points + "}";
    };
    const std::string request =
        R"({"op": "continuity", "maps": [)" +
        quarter("[[[1, 0, 0], [1, 0, 1]], [[1, 1, 0], [1, 1, 1]], [[0, 1, 0], [0, 1, 1]]]") + ", " +
        quarter("[[[0, 1, 0], [0, 1, 1]], [[-1, 1, 0], [-1, 1, 1]], [[-1, 0, 0], [-1, 0, 1]]]") + "]" +
        by_name + "}";
    CHECK(served_at("/result/order", request) == "0");
    CHECK(served_at("/result/geometric/order", request) == "1");
    // (2, -2, 0, -2) + (-2, 0, 0, 0) + (0, 2, 0, 2) = 0
    for (const std::string name : {"alpha", "beta", "delta"})
        CHECK(served_at("/result/geometric/edges/0/" + name, request) == R"("1")");
    CHECK(served_at("/result/geometric/edges/0/gamma", request) == R"("0")");
}

TEST_CASE("the domains of named edges are glued by third points") {
    const std::string sheets = R"("op": "continuity", "maps": [
        {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 0], [1, 1]]},
        {"kind": "tensor", "degrees": [1, 1], "control_net": [[1, 1], [3, 3]]}], "faces": )";
    CHECK(served_at("/result/order", "{" + sheets + "[[[1, 0], [1, 1]], [[0, 0], [0, 1]]]}") == "0");
    CHECK(served_at("/result/order",
                    "{" + sheets + "[[[1, 0], [1, 1], [0, 0]], [[0, 0], [0, 1], [\"-1/2\", 0]]]}") ==
          R"("infinite")");
    CHECK(refusal_text(sheets + "[[[1, 0], [1, 1], [0, 0]], [[0, 0], [0, 1]]]") == "wrong_arity /faces");
    CHECK(refusal_text(sheets + "[[[1, 0], [1, 1]]]") == "wrong_arity /faces");
    CHECK(refusal_text(sheets + "[[[1, 0], [1, 1]], [[0, 0]]]") == "wrong_arity /faces/1");
    CHECK(refusal_text(sheets + "[[[1, 0], [1, 2]], [[0, 0], [0, 1]]]") == "not_adjacent /faces/0");
    CHECK(refusal_text(sheets + "[[[1, 0], [1, 1]], [[0, 0], [1, 1]]]") == "not_adjacent /faces/1");
    CHECK(refusal_text(sheets + "[[[1, 0], [1, 0]], [[0, 0], [0, 1]]]") == "degenerate_simplex /faces/0");
    CHECK(refusal_text(sheets + "[[[1, 0], [1, 1], [1, 2]], [[0, 0], [0, 1], [0, 2]]]") ==
          "degenerate_simplex /faces/0");
    CHECK(refusal_text(sheets + R"("found")") == "not_adjacent /faces");
    CHECK(refusal_text(sheets + R"("nearest")") == "wrong_kind /faces");
    CHECK(refusal_text(sheets + R"([[[1, 0], [1, 1]], [[0, 0], [0, 1]]], "geometric": true)") ==
          "mismatched_dimensions /faces");
}

TEST_CASE("maps of one plane meet along any part of an edge") {
    const auto beside = [](const std::string& first, const std::string& second) {
        return R"("op": "continuity", "maps": [{)" + first + "}, {" + second + "}]";
    };
    const std::string rectangle =
        R"("kind": "tensor", "degrees": [1, 1], "intervals": [[0, 1], [-1, 0]], "control_net": [[-4, 0], [-3, 2]])";
    const std::string upper =
        R"("kind": "simplex", "degree": 1, "vertices": [[0, 0], [2, 0], [0, 2]],
            "control_net": [[[1, 0, 0], 0], [[0, 1, 0], 4], [[0, 0, 1], 8]])";
    CHECK(served_at("/result/order", "{" + beside(upper, rectangle) + "}") == "0");
    CHECK(served_at("/result/edges", "{" + beside(upper, rectangle) + "}") ==
          R"([{"left": [["0", "0"], ["1", "0"]], "right": [["0", "0"], ["1", "0"]]}])");
    const std::string lower =
        R"("kind": "simplex", "degree": 1, "vertices": [["1/2", 0], [3, 0], [0, -2]],
            "control_net": [[[1, 0, 0], 1], [[0, 1, 0], 6], [[0, 0, 1], -8]])";
    CHECK(served_at("/result/order", "{" + beside(upper, lower) + "}") == R"("infinite")");
    CHECK(refusal_text(beside(upper, R"("kind": "tensor", "degrees": [0, 0], "intervals": [[5, 6], [5, 6]],
                                          "control_net": [[1]])")) == "not_adjacent /maps");
    const std::string spline =
        R"("kind": "bspline", "degrees": [1, 1], "knots": [[0, 0, 1, 2, 2], [0, 0, 1, 1]], "control_net": [[0, 1], [1, 1], [3, 1]])";
    const std::string behind =
        R"("kind": "tensor", "degrees": [1, 1], "intervals": [["1/2", 3], [1, 2]], "control_net": [[1, 2], [1, 2]])";
    CHECK(served_at("/result/order", "{" + beside(spline, behind) + "}") == "0");
    CHECK(served_at("/result/face", "{" + beside(spline, behind) + "}") == R"([["1/2", "2"], ["1"]])");
    CHECK(served_at("/result/order", "{" + beside(spline, upper) + "}") == "-1");
}
