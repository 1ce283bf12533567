#include "answered.hpp"

#include "floats.hpp"

// What the JSON numbers of a request stand for.

namespace {

const std::string line =
    R"("op": "evaluate", "map": {"kind": "bezier", "control_points": [0, 1]}, "at": [0.2])";
const std::string nearest = R"("3602879701896397/18014398509481984")";

}  // namespace

TEST_CASE("JSON numbers are refused unless the request says what they are") {
    CHECK(refusal_text(line) == "inexact_number /at/0");
    const std::string message = served_at("/error/message", "{" + line + "}");
    CHECK(message.find("\\\"floats\\\": \\\"decimal\\\" or \\\"double\\\"") != std::string::npos);
    CHECK(result_text(line + R"(, "floats": "decimal")") == R"({"values": ["1/5"]})");
    CHECK(result_text(line + R"(, "floats": "double")") == R"({"values": [)" + nearest + "]}");
    CHECK(refusal_text(line + R"(, "floats": "single")") == "wrong_kind /floats");
    CHECK(refusal_text(line + R"(, "floats": 1)") == "wrong_kind /floats");
}

TEST_CASE("texts stay exact, and integers are themselves") {
    const std::string map = R"("op": "evaluate", "map": {"kind": "polynomial", "text": "0.1t"}, )";
    CHECK(result_text(map + R"("at": ["0.2", 1, 2.0, -0.0, 1e2], "floats": "double")") ==
          R"({"values": ["1/50", "1/10", "1/5", "0", "10"]})");
    CHECK(result_text(map + R"("at": [9007199254740993], "floats": "decimal")") ==
          R"({"values": ["9007199254740993/10"]})");
    CHECK(result_text(map + R"("at": [9007199254740993], "floats": "double")") ==
          R"({"values": ["4503599627370496/5"]})");
    CHECK(refusal_text(map + R"("at": [1e400], "floats": "double")") == "overflow /at/0");
    CHECK(refusal_text(map + R"("at": [1e99999999], "floats": "decimal")") == "limit_exceeded /at/0");
}

TEST_CASE("degrees and indices may be floats that are integers") {
    const std::string net =
        R"({"kind": "simplex", "degree": 1.0, "control_net": [[[1.0, 0], 0.5], [[0, 1], 0.25]]})";
    CHECK(result_text(R"("op": "evaluate", "map": )" + net +
                      R"(, "at": [[0.5, 0.5]], "floats": "decimal")") == R"({"values": ["3/8"]})");
    CHECK(
        refusal_text(
            R"("op": "elevate", "map": {"kind": "polynomial", "text": "t"}, "by": 1.5, "floats": "decimal")") ==
        "wrong_kind /by");
}

TEST_CASE("the id is returned as it is") {
    CHECK(served_at("/id", R"({"id": 0.50, )" + line + R"(, "floats": "decimal"})") == "0.50");
}

TEST_CASE("what another program has computed is doubles") {
    const std::string audit = R"("op": "audit", "map": {"kind": "bezier", "control_points": [0.1, 1]}, )"
                              R"("computed": {"control_points": [0.1, 1]}, "floats": )";
    CHECK(served_at("/result/errors/control_points/0", "{" + audit + R"("decimal"})") ==
          R"("1/180143985094819840")");
    CHECK(served_at("/result/errors/control_points/0", "{" + audit + R"("double"})") == R"("0")");
}

TEST_CASE("an imported document is doubles unless it is said to be decimals") {
    const std::string import =
        R"("op": "import", "format": "tinyspline", "document": {"degree": 1, "dimension": 1, )"
        R"("control_points": [0.2, "0.2"], "knots": [0, 0, 1, 1]})";
    const auto points = [&](const std::string& more) {
        return served_at("/result/maps/0/control_points", "{" + import + more + "}");
    };
    const std::string doubles = "[[" + nearest + "], [" + nearest + "]]";
    CHECK(points("") == doubles);
    CHECK(points(R"(, "floats": "double")") == doubles);
    CHECK(points(R"(, "floats": "decimal")") == R"([["1/5"], ["1/5"]])");
}

TEST_CASE("a knot that is a decimal meets the parameter") {
    const std::string import =
        R"({"op": "import", "format": "fitpack", "document": [[0, 0, 0.2, 1, 1], [0, 1, 0], 1])";
    const auto removal = [&](const std::string& floats) {
        const std::string map = served_at("/result/maps/0", import + floats + "}");
        return served(R"({"op": "remove-knot", "knot": "0.2", "times": 1, "map": )" + map + "}");
    };
    CHECK(removal(R"(, "floats": "decimal")").find("result"));
    const Json refused = removal("");
    const std::string& message = *at_pointer(refused, "/error/message")->text();
    CHECK(message.find("the nearest is 3602879701896397/18014398509481984") != std::string::npos);
}

TEST_CASE("the request that is explained has a reading of its own") {
    const std::string nested =
        R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [0.5])";
    const auto explained = [&](const std::string& inner, const std::string& outer) {
        return served(R"({"op": "explain", "request": )" + nested + inner + "}" + outer + "}")
                   .find("result") != nullptr;
    };
    CHECK_FALSE(explained("", ""));
    CHECK(explained(R"(, "floats": "decimal")", ""));
    CHECK(explained("", R"(, "floats": "double")"));
}

TEST_CASE("a domain is printed as it was typed") {
    const std::string spline =
        R"("op": "evaluate", "map": {"kind": "bspline", "degree": 1, "control_points": [0, 1], )"
        R"("knots": ["0.10", "0.10", "2/4", "2/4"]}, "at": ["0.75"])";
    CHECK(served_at("/error/message", "{" + spline + "}") ==
          R"("the parameter 0.75 lies outside the domain [0.10, 2/4]")");
    const std::string floats =
        R"("op": "evaluate", "map": {"kind": "bspline", "degree": 1, "control_points": [0, 1], )"
        R"("knots": [0.1, 0.1, 0.5, 0.5]}, "at": [0.7], "floats": )";
    for (const char* reading : {R"("decimal")", R"("double")"}) {
        CHECK(served_at("/error/message", "{" + floats + reading + "}") ==
              R"("the parameter 0.7 lies outside the domain [0.1, 0.5]")");
    }
}
