#include "answered.hpp"

// Maps on simplices and boxes and polynomials in several variables: answers and errors.

namespace {

std::string result(const std::string& request) {
    const Json response = served("{" + request + "}");
    const Json* found = response.find("result");
    return found ? protocol::to_text(*found) : protocol::to_text(response);
}

/// The code of the error and its place.
std::string refusal(const std::string& request) {
    const Json response = served("{" + request + "}");
    const Json* error = response.find("error");
    if (!error) return protocol::to_text(response);
    return *error->find("code")->text() + " " + *error->find("at")->text();
}

// x^2 + 3 x y - 2 as each kind.
const std::string polynomial =
    R"("map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x^2 + 3x*y - 2"})";
const std::string by_degrees =
    R"("map": {"kind": "polynomial", "variables": ["x", "y"], "text": "x^2 + 3x*y - 2", "degrees": [2, 1]})";
const std::string triangle = R"("map": {"kind": "simplex", "degree": 2, "vertices": [[0, 0], [1, 0], [0, 1]],
    "control_net": [[[0, 0, 2], -2], [[2, 0, 0], -2], [[1, 1, 0], -2], [[1, 0, 1], -2], [[0, 2, 0], -1],
                    [[0, 1, 1], "-1/2"]]})";
const std::string barycentric = R"("map": {"kind": "simplex", "degree": 2,
    "control_net": [[[0, 0, 2], -2], [[2, 0, 0], -2], [[1, 1, 0], -2], [[1, 0, 1], -2], [[0, 2, 0], -1],
                    [[0, 1, 1], "-1/2"]]})";
const std::string box = R"("map": {"kind": "tensor", "degrees": [2, 1], "intervals": [[0, 1], [0, 2]],
    "control_net": [[-2, -2], [-2, 1], [-1, 5]]})";

}  // namespace

TEST_CASE("the same map as a polynomial, over a triangle and over a box") {
    for (const std::string& map : {polynomial, by_degrees, triangle, box}) {
        INFO(map);
        CHECK(result(R"("op": "evaluate", "at": [[2, 3], ["1/2", "-1"]], )" + map) ==
              R"({"values": ["20", "-13/4"]})");
        CHECK(result(R"("op": "derivative", "direction": [1, 2], "at": [[2, 3]], )" + map) ==
              R"({"values": ["25"]})");
        CHECK(result(R"("op": "derivative", "direction": [1, 2], "order": 2, "at": [[2, 3]], )" + map) ==
              R"({"values": ["14"]})");
        CHECK(result(R"("op": "derivative", "directions": [[1, 0], [0, 1]], "at": [[2, 3]], )" + map) ==
              R"({"values": ["3"]})");
        CHECK(result(R"("op": "derivative", "direction": [1, 2], "order": 3, "at": [[2, 3]], )" + map) ==
              R"({"values": ["0"]})");
        CHECK(served_at("/result/for_all_arguments", R"({"op": "agree", )" + map + "}") == "true");
        CHECK(result(R"("op": "control-points", "intervals": [[0, 1], [0, 2]], "degrees": [2, 1], )" + map) ==
              R"({"map": {"kind": "tensor", "degrees": [2, 1], "intervals": [["0", "1"], ["0", "2"]], )"
              R"("control_net": [["-2", "-2"], ["-2", "1"], ["-1", "5"]]}})");
        // The derived map, and its values.
        const Json derived = served(R"({"op": "derivative", "direction": [1, 2], )" + map + "}");
        CHECK(result(R"("op": "evaluate", "at": [[2, 3]], "map": )" +
                     protocol::to_text(*at_pointer(derived, "/result/map"))) == R"({"values": ["25"]})");
        // After degree raising it is the same map.
        const Json raised = served(R"({"op": "elevate", "by": 2, )" + map + "}");
        CHECK(result(R"("op": "evaluate", "at": [[2, 3]], "map": )" +
                     protocol::to_text(*at_pointer(raised, "/result/map"))) == R"({"values": ["20"]})");
    }
    for (const std::string& map : {polynomial, triangle}) {
        CHECK(result(R"("op": "blossom", "arguments": [[1, 2], {"homogeneous": [6, -2, 2]}], )" + map) ==
              R"({"value": "17"})");
        CHECK(
            result(R"("op": "control-points", "vertices": [[0, 0], [1, 0], [0, 2]], )" + map) ==
            R"({"map": {"kind": "simplex", "degree": 2, "vertices": [["0", "0"], ["1", "0"], ["0", "2"]], )"
            R"("control_net": [[[2, 0, 0], "-2"], [[1, 1, 0], "-2"], [[1, 0, 1], "-2"], [[0, 2, 0], "-1"], )"
            R"([[0, 1, 1], "1"], [[0, 0, 2], "-2"]]}})");
    }
    for (const std::string& map : {by_degrees, box}) {
        for (const std::string construction : {"symmetric", "polarization", "casteljau"}) {
            CHECK(result(R"("op": "blossom", "arguments": [[1, {"vector": 2}], [3]], "construction": ")" +
                         construction + "\", " + map) == R"({"value": "11"})");
        }
        CHECK(result(R"("op": "agree", "arguments": [[1, 2], [3]], )" + map) ==
              R"({"agree": true, "degrees": [2, 1], "values": {"symmetric": "27/2", "polarization": "27/2", )"
              R"("casteljau": "27/2"}, "skipped": []})");
    }
    CHECK(result(R"("op": "blossom", "arguments": [["-2", 1, 2], {"vector": [-1, 1, 0]}], )" + barycentric) ==
          R"({"value": "4"})");
    CHECK(result(R"("op": "evaluate", "at": [["1/3", "1/3", "1/3"]], )" + barycentric) ==
          R"({"values": ["-14/9"]})");
}

TEST_CASE("the pieces of patches are the patch on other domains") {
    const auto values_of_pieces = [](const std::string& at, const std::string& map,
                                     const std::string& parameter) {
        const Json divided = served(R"({"op": "subdivide", "at": )" + at + ", " + map + "}");
        std::vector<std::string> values;
        for (const Json& piece : *at_pointer(divided, "/result/maps")->array()) {
            values.push_back(served_at("/result/values/0", R"({"op": "evaluate", "at": [)" + parameter +
                                                               R"(], "map": )" + protocol::to_text(piece) +
                                                               "}"));
        }
        return values;
    };
    CHECK(values_of_pieces(R"(["1/4", "1/4"])", triangle, "[2, 3]") ==
          std::vector<std::string>(3, R"("20")"));
    CHECK(values_of_pieces(R"("midpoints")", triangle, "[2, 3]") == std::vector<std::string>(4, R"("20")"));
    CHECK(values_of_pieces(R"(["1/4", "1/4"])", polynomial, "[2, 3]") ==
          std::vector<std::string>(3, R"("20")"));
    CHECK(values_of_pieces(R"(["1/4", null])", box, "[2, 3]") == std::vector<std::string>(2, R"("20")"));
    CHECK(values_of_pieces(R"(["1/4", "1/4"])", box, "[2, 3]") == std::vector<std::string>(4, R"("20")"));
    CHECK(served_at("/result/maps/0/intervals", R"({"op": "subdivide", "at": ["1/4", "1/2"], )" + box +
                                                    "}") == R"([["0", "1/4"], ["0", "1/2"]])");
    CHECK(values_of_pieces(R"([0, "1/4"])", triangle, "[2, 3]") == std::vector<std::string>(2, R"("20")"));
    CHECK(refusal(R"("op": "subdivide", "at": [0, 1], )" + triangle) == "degenerate_simplex /at");
    CHECK(refusal(R"("op": "subdivide", "at": ["1/4"], )" + box) == "wrong_arity /at");
    CHECK(refusal(R"("op": "subdivide", "at": [0, null], )" + box) == "degenerate_simplex /at/0");
}

TEST_CASE("rational patches are divided by their weights") {
    // (x, y) / (1 + x + y) over a triangle and over a box.
    const std::string rational =
        R"("map": {"kind": "polynomial", "variables": ["x", "y"], "text": ["x", "y"], "denominator": "1 + x + y"})";
    const std::string net = R"("map": {"kind": "simplex", "degree": 1, "vertices": [[0, 0], [1, 0], [0, 1]],
        "control_net": [[[1, 0, 0], [0, 0]], [[0, 1, 0], ["1/2", 0]], [[0, 0, 1], [0, "1/2"]]],
        "weights": [[[1, 0, 0], 1], [[0, 1, 0], 2], [[0, 0, 1], 2]]})";
    for (const std::string& map : {rational, net}) {
        CHECK(result(R"("op": "evaluate", "at": [[1, 2]], )" + map) == R"({"values": [["1/4", "1/2"]]})");
        // d/dx of x / (1 + x + y) is (1 + y) / (1 + x + y)^2, and d2/dxdy (x - y - 1) / (1 + x + y)^3.
        CHECK(result(R"("op": "derivative", "direction": [1, 0], "at": [[1, 2]], )" + map) ==
              R"({"values": [["3/16", "-1/8"]]})");
        CHECK(result(R"("op": "derivative", "directions": [[1, 0], [0, 1]], "at": [[1, 2]], )" + map) ==
              R"({"values": [["-1/32", "0"]]})");
        CHECK(refusal(R"("op": "evaluate", "at": [[1, -2]], )" + map) == "zero_weight /at/0");
        CHECK(refusal(R"("op": "blossom", "arguments": [{"vector": [1, 0]}], )" + map) ==
              "zero_weight /arguments/0");
    }
    CHECK(served_at("/result/map/weights", R"({"op": "control-points", )" + rational + "}") ==
          R"([[[1, 0, 0], "1"], [[0, 1, 0], "2"], [[0, 0, 1], "2"]])");
    CHECK(
        refusal(
            R"("op": "evaluate", "at": [[0]], "map": {"kind": "tensor", "degrees": [1], "control_net": [1, 2],
                     "weights": [1, 0]})") == "zero_weight /map/weights/1");
    CHECK(result(
              R"("op": "evaluate", "at": [[1]], "map": {"kind": "tensor", "degrees": [1], "homogeneous": true,
                    "control_net": [[1, 1], [2, 0]]})") == R"({"values": [["2", "0"]]})");
}

TEST_CASE("two patches meet along the face that they share") {
    const std::string left = R"({"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 0], [1, 2]]})";
    const std::string right =
        R"({"kind": "tensor", "degrees": [1, 1], "intervals": [[1, 2], [0, 1]], "control_net": [[1, 2], [2, 5]]})";
    const auto order = [&](const std::string& first, const std::string& second) {
        return result(R"("op": "continuity", "maps": [)" + first + ", " + second + "]");
    };
    CHECK(order(left, right) ==
          R"({"order": 0, "first_difference": {"arguments": [["0"], ["1"]], "left": "0", "right": "-1"}, )"
          R"("reason": "The patches meet with order 0 along the face: the blossom values at )"
          R"([0; 1] are 0 and -1"})");
    CHECK(order(left, left) == R"({"order": "infinite", "reason": "The patches are the same polynomial"})");
    const std::string far =
        R"({"kind": "tensor", "degrees": [1, 1], "intervals": [[3, 4], [0, 1]], "control_net": [[1, 2], [2, 5]]})";
    CHECK(refusal(R"("op": "continuity", "maps": [)" + left + ", " + far + "]") == "not_adjacent /maps");
    CHECK(refusal(R"("op": "continuity", "maps": [)" + left + R"(, {"kind": "polynomial", "text": "t"}])") ==
          "wrong_kind /maps/1");
}

TEST_CASE("an invalid patch is refused with its place") {
    const auto map = [](const std::string& members) {
        return R"("op": "evaluate", "at": [], "map": {)" + members + "}";
    };
    const std::string simplex = R"("kind": "simplex", "degree": 1, "control_net": )";
    CHECK(refusal(map(simplex + "[[[1, 0], 0]]")) == "incomplete_net /map/control_net");
    CHECK(refusal(map(simplex + "[[[1, 0], 0], [[1, 0], 1]]")) == "incomplete_net /map/control_net/1");
    CHECK(refusal(map(simplex + "[[[1, 0], 0], [[0, 2], 1]]")) == "incomplete_net /map/control_net/1/0");
    CHECK(refusal(map(simplex + "[[[1, 0], 0], [[0, 1], [1, 2]]]")) ==
          "mismatched_dimensions /map/control_net/1/1");
    CHECK(refusal(map(simplex + "[[[1, 0], 0], [[0, 1], 1]], \"vertices\": [[1], [1]]")) ==
          "degenerate_simplex /map/vertices/1");
    CHECK(refusal(map(simplex + "[[[1, 0], 0], [[0, 1], 1]], \"vertices\": [[1, 1], [1, 2]]")) ==
          "mismatched_dimensions /map/vertices");
    CHECK(refusal(map(simplex + "[]")) == "incomplete_net /map/control_net");
    CHECK(refusal(map(simplex + "[[1, 2]]")) == "incomplete_net /map/control_net/0/0");
    const std::string tensor = R"("kind": "tensor", "degrees": [1, 1], "control_net": )";
    CHECK(refusal(map(tensor + "[[0, 1], [2]]")) == "incomplete_net /map/control_net/1");
    CHECK(refusal(map(tensor + "[[0, 1], [2, 3]], \"intervals\": [[0, 1]]")) == "wrong_arity /map/intervals");
    CHECK(refusal(map(tensor + "[[0, 1], [2, 3]], \"intervals\": [[0, 1], [2, 2]]")) ==
          "empty_interval /map/intervals/1");
    CHECK(refusal(map(R"("kind": "tensor", "degrees": [], "control_net": 1)")) == "wrong_arity /map/degrees");
    CHECK(refusal(map(R"("kind": "simplex", "degree": 10000, "control_net": [[[1, 0, 0, 0], 0]])")) ==
          "limit_exceeded /map/control_net");
    const std::string variables = R"("kind": "polynomial", "variables": ["x", "y"], )";
    CHECK(refusal(map(variables + R"("text": "x*z")")) == "syntax /map/text");
    CHECK(refusal(map(variables + R"("text": "x*y", "degree": 1)")) == "degree_too_low /map/degree");
    CHECK(refusal(map(variables + R"("text": "x*y", "degrees": [1, 0])")) == "degree_too_low /map/degrees");
    CHECK(refusal(map(variables + R"("text": "x*y", "degree": 2, "degrees": [1, 1])")) ==
          "wrong_kind /map/degree");
    CHECK(refusal(map(variables + R"("terms": [[[1], 1]])")) == "wrong_arity /map/terms/0/0");
    CHECK(refusal(map(variables + R"("text": "x", "denominator": "x - x")")) ==
          "zero_denominator /map/denominator");
    CHECK(refusal(map(R"("kind": "polynomial", "variables": ["x", "x"], "text": "x")")) ==
          "syntax /map/variables/1");
    CHECK(refusal(map(R"("kind": "polynomial", "variables": ["x+"], "text": "x")")) ==
          "syntax /map/variables/0");

    CHECK(refusal(R"("op": "evaluate", "at": [[1, 2, 3]], )" + triangle) == "mismatched_dimensions /at/0");
    CHECK(refusal(R"("op": "evaluate", "at": [[1, 2, 3]], )" + barycentric) == "not_affine /at/0");
    CHECK(refusal(R"("op": "blossom", "arguments": [[1, 2]], )" + triangle) == "wrong_arity /arguments");
    CHECK(refusal(R"("op": "blossom", "arguments": [[1, 2]], )" + box) == "wrong_arity /arguments");
    CHECK(refusal(R"("op": "derivative", )" + triangle) == "missing_field /direction");
    CHECK(refusal(R"("op": "derivative", "direction": [1, 0, 0], )" + barycentric) ==
          "not_affine /direction");
    CHECK(refusal(R"("op": "control-points", "degree": 1, )" + triangle) == "degree_too_low /degree");
    CHECK(refusal(R"("op": "control-points", "intervals": [[0, 1], [0, 1]], )" + barycentric) ==
          "wrong_kind /intervals");
    CHECK(refusal(R"("op": "control-points", "vertices": [[0, 0], [1, 0], [2, 0]], )" + triangle) ==
          "degenerate_simplex /vertices/2");
    CHECK(refusal(R"("op": "elevate", "by": [1], )" + box) == "wrong_arity /by");
    CHECK(refusal(R"("op": "roots", )" + triangle) == "wrong_kind /map");
    CHECK(refusal(R"("op": "barycentric", "vertices": [[0], [1]], "at": [[0, 1]])") ==
          "mismatched_dimensions /at/0");
}
