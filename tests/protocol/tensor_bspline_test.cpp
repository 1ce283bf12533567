#include "answered.hpp"

// B-splines in several directions: answers and errors.

namespace {

const std::string fields =
    R"("kind": "bspline", "degrees": [2, 1], "knots": [[0, 0, 0, 1, 2, 2, 2], [0, 2]],
       "control_net": [[0, 1], [1, 3], [3, "-1"], [4, 0]])";
const std::string surface = R"("map": {)" + fields + "}";
/// The same map as a polynomial on each side of u = 1: sums of products of the basis functions. For u <= 1
/// the functions are (1 - u)^2, 2 u - 3/2 u^2, u^2 / 2, and (1 - v/2), v/2 in the other direction.
const std::string left = R"("map": {"kind": "polynomial", "variables": ["u", "v"], "degrees": [2, 1], "text":
    "((2u - 3/2u^2) + 3u^2/2)(1 - v/2) + ((1 - u)^2 + 3(2u - 3/2u^2) - u^2/2)v/2"})";
/// For u >= 1 they are (2 - u)^2 / 2, 2 (2 - u) - 3/2 (2 - u)^2, (u - 1)^2.
const std::string right = R"("map": {"kind": "polynomial", "variables": ["u", "v"], "degrees": [2, 1], "text":
    "((2 - u)^2/2 + 3(2(2 - u) - 3/2(2 - u)^2) + 4(u - 1)^2)(1 - v/2) + (3(2 - u)^2/2 - (2(2 - u) - 3/2(2 - u)^2))v/2"})";

/// Checks that a request gives the same answer for both maps.
void check_same(const std::string& request, const std::string& map, const std::string& polynomial,
                const std::string& more = "") {
    CAPTURE(request);
    CHECK(result_text(request + ", " + more + map) == result_text(request + ", " + polynomial));
}

}  // namespace

TEST_CASE("B-splines in two directions have the values, blossoms and derivatives of their polynomials") {
    const auto check = [](const std::string& polynomial, const std::string& u, const std::string& segment) {
        const std::string at = R"("at": [[)" + u + R"(, "1/3"]])";
        check_same(R"("op": "evaluate", )" + at, surface, polynomial);
        for (const std::string construction :
             {"", R"(, "construction": "symmetric")", R"(, "construction": "polarization")"}) {
            check_same(R"("op": "blossom", "arguments": [[5, "1/7"], [{"vector": 3}]])" + construction,
                       surface, polynomial, segment);
        }
        for (const std::string which : {R"("direction": [1, "2/3"])", R"("direction": [3, 1], "order": 2)",
                                        R"("directions": [[1, 0], [0, 2]])"}) {
            check_same(R"("op": "derivative", )" + which + ", " + at, surface, polynomial);
        }
    };
    check(left, R"("2/5")", R"("segment": [2, 0], )");
    check(right, R"("7/5")", R"("segment": [3, 0], )");
    check(right, "2", R"("segment": [3, 0], )");
    // At a knot, the polynomial to the right counts.
    check(right, "1", R"("segment": [3, 0], )");
}

TEST_CASE("what is made of B-splines in two directions is the same map") {
    const std::string at = R"("at": [["2/5", 1], [1, "1/2"], ["9/5", 2]])";
    const std::string values = result_text(R"("op": "evaluate", )" + at + ", " + surface);
    const auto made = [&](const std::string& request) {
        return protocol::to_text(*at_pointer(served("{" + request + ", " + surface + "}"), "/result/map"));
    };
    for (const std::string request :
         {R"("op": "insert-knots", "knots": [["1/2", "1/2"], ["1/3"]])", R"("op": "elevate", "by": [1, 2])",
          R"("op": "elevate", "by": 1)", R"("op": "control-points")",
          R"("op": "control-points", "degrees": [3, 1])",
          R"("op": "control-points", "intervals": [["1/4", 2], [0, 2]])"}) {
        CAPTURE(request);
        CHECK(result_text(R"("op": "evaluate", )" + at + R"(, "map": )" + made(request)) == values);
    }
    CHECK(
        made(R"("op": "insert-knots", "knots": [[], [1]])")
            .starts_with(
                R"({"kind": "bspline", "degrees": [2, 1], "knots": [["0", "0", "0", "1", "2", "2", "2"], ["0", "1", "2"]], )"
                R"("control_net": [["0", "1/2", "1"], )"));
    // One box is a Bezier patch.
    CHECK(made(R"("op": "control-points", "intervals": [["1/2", 1], [0, 1]])")
              .starts_with(
                  R"({"kind": "tensor", "degrees": [2, 1], "intervals": [["1/2", "1"], ["0", "1"]], )"));
    // The derived map along each parameter.
    const std::string derived = made(R"("op": "derivative", "directions": [[3, 0], [0, "1/2"]])");
    CHECK(result_text(R"("op": "evaluate", )" + at + R"(, "map": )" + derived) ==
          result_text(R"("op": "derivative", "directions": [[3, 0], [0, "1/2"]], )" + at + ", " + surface));
    CHECK(made(R"("op": "derivative", "direction": [0, 0])").find(R"("control_net": [["0", "0"])") !=
          std::string::npos);
}

TEST_CASE("the Bezier patches and the parts of B-splines in two directions are theirs") {
    const Json segments = served(R"({"op": "segments", )" + surface + "}");
    const Json::Array& patches = *at_pointer(segments, "/result/maps")->array();
    REQUIRE(patches.size() == 2);
    const std::string over_left = R"({"op": "control-points", "intervals": [[0, 1], [0, 2]], )" + left + "}";
    const std::string over_right =
        R"({"op": "control-points", "intervals": [[1, 2], [0, 2]], )" + right + "}";
    CHECK(protocol::to_text(patches[0]) == served_at("/result/map", over_left));
    CHECK(protocol::to_text(patches[1]) == served_at("/result/map", over_right));
    const Json parts = served(R"({"op": "subdivide", "at": ["1/2", 1], )" + surface + "}");
    const Json::Array& list = *at_pointer(parts, "/result/maps")->array();
    REQUIRE(list.size() == 4);
    const std::vector<std::string> at{R"(["1/4", "1/2"])", R"(["1/4", "3/2"])", R"(["3/2", "1/2"])",
                                      R"(["3/2", "3/2"])"};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string request = R"("op": "evaluate", "at": [)" + at[i] + "], ";
        CHECK(result_text(request + R"("map": )" + protocol::to_text(list[i])) ==
              result_text(request + surface));
    }
}

TEST_CASE("rational B-splines in two directions are divided by their weights") {
    // Half a cylinder in two quarters: x^2 + y^2 = 1.
    const std::string cylinder = R"("map": {"kind": "bspline", "degrees": [2, 1],
        "knots": [[0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 1, 1]],
        "control_net": [[[1, 0, 0], [1, 0, 1]], [[1, 1, 0], [1, 1, 1]], [[0, 1, 0], [0, 1, 1]],
                        [[-1, 1, 0], [-1, 1, 1]], [[-1, 0, 0], [-1, 0, 1]]],
        "weights": [[1, 1], [1, 1], [2, 2], [1, 1], [1, 1]]})";
    CHECK(result_text(R"("op": "evaluate", "at": [["1/2", "1/3"]], )" + cylinder) ==
          R"({"values": [["3/5", "4/5", "1/3"]]})");
    // Of (1 - t^2, 2t) / (1 + t^2) at 1/2.
    CHECK(result_text(R"("op": "derivative", "direction": [1, 0], "at": [["1/2", 0]], )" + cylinder) ==
          R"({"values": [["-32/25", "24/25", "0"]]})");
    CHECK(refusal_text(R"("op": "derivative", "direction": [1, 0], )" + cylinder) == "wrong_kind /map");
    CHECK(served_at("/result/map/weights",
                    R"({"op": "insert-knots", "knots": [["1/2"], []], )" + cylinder + "}") ==
          R"([["1", "1"], ["1", "1"], ["3/2", "3/2"], ["2", "2"], ["1", "1"], ["1", "1"]])");
}

TEST_CASE("an invalid tensor product of B-splines is refused with its place") {
    const auto read = [](const std::string& members) {
        return refusal_text(R"("op": "evaluate", "at": [], "map": {"kind": "bspline", )" + members + "}");
    };
    const std::string one = R"("degrees": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]], )";
    CHECK(read(one + R"("control_net": [[0, 1], [2]])") == "incomplete_net /map/control_net/1");
    CHECK(read(one + R"("control_net": [[0, 1], [2, [3]]])") == "mismatched_dimensions /map/control_net/1/1");
    CHECK(read(one + R"("control_net": [])") == "incomplete_net /map/control_net");
    CHECK(read(one + R"("control_net": [[0, 1], [2, 3]], "weights": [[1, 1], [0, 1]])") ==
          "zero_weight /map/weights/1/0");
    CHECK(read(one + R"("control_net": [[0, 1], [2, 3], [4, 5]])") == "bad_knots /map/knots/0");
    CHECK(
        read(
            R"("degrees": [1, 1], "knots": [[0, 0, 1, 1], [0, 1, 0, 1]], "control_net": [[0, 1], [2, 3]])") ==
        "bad_knots /map/knots/1/2");
    CHECK(read(R"("degrees": [1, 1], "knots": [[0, 0, 1, 1]], "control_net": [[0, 1], [2, 3]])") ==
          "wrong_arity /map/knots");
    CHECK(read(R"("degrees": [], "knots": [], "control_net": 1)") == "wrong_arity /map/degrees");
    CHECK(read(one + R"("control_points": [0, 1])") == "missing_field /map/control_net");
    const auto refused = [](const std::string& request) { return refusal_text(request + ", " + surface); };
    CHECK(refused(R"("op": "evaluate", "at": [[1, 1], [1, 3]])") == "outside_domain /at/1/1");
    CHECK(refused(R"("op": "evaluate", "at": [[1]])") == "mismatched_dimensions /at/0");
    CHECK(refused(R"("op": "blossom", "arguments": [[1, 1], [1]])") == "outside_domain /segment");
    CHECK(refused(R"("op": "blossom", "segment": [1, 0], "arguments": [[1, 1], [1]])") ==
          "outside_domain /segment");
    CHECK(refused(R"("op": "blossom", "segment": [2], "arguments": [[1, 1], [1]])") ==
          "wrong_arity /segment");
    CHECK(refused(R"("op": "derivative", "direction": [1, 1])") == "wrong_kind /direction");
    CHECK(refused(R"("op": "control-points", "intervals": [[0, 1], [0, 3]])") ==
          "outside_domain /intervals/1");
    CHECK(refused(R"("op": "control-points", "degrees": [2, 0])") == "degree_too_low /degrees/1");
    CHECK(refused(R"("op": "insert-knots", "knots": [["1/2"]])") == "wrong_arity /knots");
    CHECK(refused(R"("op": "insert-knots", "knots": [["1/2"], [1, 5]])") == "outside_domain /knots/1/1");
    CHECK(refused(R"("op": "subdivide", "at": [null, 2])") == "outside_domain /at/1");
    CHECK(refused(R"("op": "elevate", "by": [1])") == "wrong_arity /by");
    CHECK(refused(R"("op": "roots")") == "wrong_kind /map");
}
