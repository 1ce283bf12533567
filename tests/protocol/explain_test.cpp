#include "answered.hpp"

namespace {

std::string answer_text(const std::string& request) { return protocol::answer(request).text; }

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

std::string explained(const std::string& request, const std::string& more = "") {
    return answer_text(R"({"op": "explain", "request": )" + request + more + "}");
}

const std::string triangle =
    R"({"kind": "simplex", "degree": 1, "control_net": [[[1,0,0], 0], [[0,1,0], 4], [[0,0,1], 8]]})";

}  // namespace

TEST_CASE("every chapter is served for its operation") {
    const std::string cubic = R"("map": {"kind": "polynomial", "text": "1 + t^3"})";
    const std::string spline =
        R"("map": {"kind": "bspline", "degree": 2, "knots": [0,0,1,2,2], "control_points": [0,1,3,2]})";
    for (const std::string& request :
         {R"({"op": "agree", )" + cubic + R"(, "arguments": [1, 2, 3]})", R"({"op": "agree", )" + cubic + "}",
          R"({"op": "blossom", )" + cubic + R"(, "arguments": [1, 2, 3]})",
          R"({"op": "evaluate", )" + cubic + R"(, "at": [2]})",
          R"({"op": "evaluate", )" + spline + R"(, "at": ["1/2"]})",
          R"({"op": "derivative", )" + cubic + R"(, "at": [2]})",
          R"({"op": "control-points", )" + cubic + "}",
          R"({"op": "convert", )" + cubic + R"(, "to": "bernstein"})",
          R"({"op": "subdivide", )" + cubic + R"(, "at": "1/2"})",
          R"({"op": "elevate", )" + cubic + R"(, "by": 1})",
          R"({"op": "insert-knots", )" + spline + R"(, "knots": ["1/2"]})",
          R"({"op": "segments", )" + spline + "}", R"({"op": "continuity", )" + spline + R"(, "at": 1})",
          R"({"op": "evaluate", "map": )" + triangle + R"(, "at": [["1/2", "1/4", "1/4"]]})",
          R"({"op": "subdivide", "map": )" + triangle + R"(, "at": ["1/2", "1/4", "1/4"]})",
          std::string(R"({"op": "prove", "statement": "map b degree 1\nclaim b(t) == b[t]"})")}) {
        CAPTURE(request);
        CHECK(has(explained(request), R"({"ok": true, "result": {"format": "text", "document": )"));
    }
}

TEST_CASE("what no page can be made of is refused with the place") {
    const auto refused = [](const std::string& request, std::string_view code, std::string_view place) {
        const std::string response = explained(request);
        CAPTURE(response);
        CHECK(has(response, "\"code\": \"" + std::string(code) + "\""));
        CHECK(has(response, "\"at\": \"" + std::string(place) + "\""));
    };
    const std::string square = R"("map": {"kind": "polynomial", "text": "t^2"})";
    refused(R"({"op": "roots", )" + square + R"(, "interval": [-1, 1]})", "unknown_op", "/request/op");
    refused(R"({"op": "evaluate", )" + square + R"(, "at": [1, 2]})", "wrong_arity", "/request/at");
    refused(R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^13"}, "at": [1]})",
            "limit_exceeded", "/request");
    refused(R"({"op": "subdivide", "map": )" + triangle + R"(, "at": "midpoints"})", "wrong_kind",
            "/request/at");
    refused(R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "x*y", "variables": ["x", "y"],)"
            R"( "degrees": [1, 1]}, "at": [[1, 2]]})",
            "wrong_kind", "/request/map");
    refused(R"({"op": "prove", "statement": []})", "wrong_arity", "/request/statement");
    refused(R"({"op": "prove", "statement": ["claim x == x", "claim y ="]})", "syntax",
            "/request/statement/1");
}

TEST_CASE("a rational curve is said to be shown in homogeneous coordinates") {
    const std::string map =
        R"("map": {"kind": "bezier", "control_points": [[1,0],[1,1],[0,1]], "weights": [1,1,2]})";
    CHECK(has(explained(R"({"op": "subdivide", )" + map + R"(, "at": "1/2"})"), "The curve is rational"));
    CHECK(has(explained(R"({"op": "evaluate", )" + map + R"(, "at": ["1/2"]})"), "A rational arc"));
}

TEST_CASE("statements are written with brackets unless another notation is requested") {
    const std::string request = R"({"op": "prove", "statement": "map b degree 1\nclaim b(t) == b[t]"})";
    CHECK(has(explained(request), "b[t]"));
    CHECK_FALSE(has(explained(request, R"(, "notation": "parentheses")"), "  b[t]"));
}
