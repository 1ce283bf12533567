#include <string>

#include "answered.hpp"

namespace {

const std::string surface =
    R"("map": {"kind": "bspline", "degrees": [2, 1], "knots": [[0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 1, 1]],
        "control_net": [[0, 0], [1, 0], [2, 1], [3, 0], [4, 0]]})";
const std::string box = R"("map": {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 1], [2, 5]]})";
const std::string simplex =
    R"("map": {"kind": "simplex", "degree": 1, "control_net": [[[1, 0, 0], 0], [[0, 1, 0], 1], [[0, 0, 1], 2]]})";
const std::string curve = R"("map": {"kind": "bezier", "control_points": [0, 1]})";

}  // namespace

TEST_CASE("a direction is a number below that of the directions, of a tensor product only") {
    for (const std::string op :
         {R"("op": "clamp")", R"("op": "reverse")", R"("op": "reparametrise")", R"("op": "periodic")",
          R"("op": "trim", "interval": [0, 1])", R"("op": "remove-knot", "knot": 1)"}) {
        INFO(op);
        CHECK(refusal_text(op + R"(, "direction": 2, )" + surface) == "wrong_arity /direction");
        CHECK(refusal_text(op + R"(, "direction": -1, )" + surface) == "wrong_kind /direction");
    }
    for (const std::string op :
         {R"("op": "reverse")", R"("op": "periodic")", R"("op": "trim", "interval": [0, 1])",
          R"("op": "remove-knot", "knot": 1)"}) {
        INFO(op);
        CHECK(refusal_text(op + ", " + surface) == "missing_field /direction");
    }
    CHECK(refusal_text(R"("op": "reverse", "direction": 0, )" + curve) == "unknown_field /direction");
    CHECK(refusal_text(R"("op": "reverse", )" + simplex) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "clamp", "direction": 0, )" + box) == "wrong_kind /map");
    CHECK(refusal_text(R"("op": "insert-knots", "direction": 2, "knots": [1], )" + surface) ==
          "wrong_arity /direction");
    CHECK(refusal_text(R"("op": "insert-knots", "direction": 0, "knots": [1, 5], )" + surface) ==
          "outside_domain /knots/1");
}

TEST_CASE("errors in a direction are in the fields of the request") {
    CHECK(refusal_text(R"("op": "trim", "direction": 0, "interval": [1, 3], )" + surface) ==
          "outside_domain /interval");
    CHECK(refusal_text(R"("op": "remove-knot", "direction": 1, "knot": 1, )" + surface) == "bad_knots /knot");
    CHECK(refusal_text(R"("op": "remove-knot", "direction": 0, "knot": 1, "times": 3, )" + surface) ==
          "bad_knots /times");
    CHECK(refusal_text(R"("op": "periodic", "direction": 1, )" + surface) == "not_continuous /map");
    CHECK(refusal_text(R"("op": "continuity", "at": ["seam", "seam"], )" + surface) == "wrong_arity /at");
    CHECK(refusal_text(R"("op": "continuity", "at": [null, "end"], )" + surface) == "not_a_number /at/1");
}

TEST_CASE(
    "maps that are joined have the same domains in the other directions, and the order that knots need") {
    const auto join = [](const std::string& interval, const std::string& last, const std::string& more) {
        return R"("op": "join", "direction": 0, "maps": [
            {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 0], [1, 2]]},
            {"kind": "tensor", "degrees": [1, 1], "intervals": [[1, 2], )" +
               interval + R"(], "control_net": [[1, )" + last + "], [5, 5]]}]" + more;
    };
    CHECK(served_at("/result/map/knots/0", "{" + join("[0, 1]", "2", "") + "}") ==
          R"(["0", "0", "1", "2", "2"])");
    CHECK(served_at("/result/map/knots/0", "{" + join("[0, 1]", "3", "") + "}") ==
          R"(["0", "0", "1", "1", "2", "2"])");
    CHECK(refusal_text(join("[0, 2]", "2", "")) == "not_adjacent /maps/1");
    const std::string knots = R"(, "knots": [0, 0, 1, 2, 2])";
    CHECK(served_at("/result/map/control_net", "{" + join("[0, 1]", "2", knots) + "}") ==
          R"([["0", "0"], ["1", "2"], ["5", "5"]])");
    const Json refused = served("{" + join("[0, 1]", "3", knots) + "}");
    CHECK(*at_pointer(refused, "/error/code")->text() == "not_continuous");
    CHECK(at_pointer(refused, "/error/message")->text()->find("In row 1: The curves do not meet at 1") !=
          std::string::npos);
    CHECK(refusal_text(R"("op": "join", "direction": 0, "maps": [)" + box.substr(7) +
                       R"(, {"kind": "bezier", "control_points": [0, 1]}])") == "wrong_kind /maps/1");
}
