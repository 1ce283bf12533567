#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/number_text.hpp>
#include "answered.hpp"

#include <cstdlib>

#include "rounding.hpp"

namespace {

const std::string cubic = R"("map": {"kind": "polynomial", "text": "1 + 2t + 4t^2 - t^3"})";
const std::string circle =
    R"("map": {"kind": "polynomial", "text": ["1 - t^2", "2t"], "denominator": "1 + t^2"})";

std::string result(const std::string& request, const Limits& limits = {}) {
    const Json response = served("{" + request + "}", limits);
    INFO(protocol::to_text(response));
    REQUIRE(response.find("result"));
    return protocol::to_text(*response.find("result"));
}

}  // namespace

TEST_CASE("numbers come in as strings or integers of any size and go out in lowest terms") {
    const std::string digits(400, '9');
    CHECK(result(R"("op": "evaluate", "map": {"kind": "polynomial", "text": "t"},
                     "at": ["6/4", "010", "-0.125", "1.5e-3", -7, )" +
                 digits + "]") ==
          R"({"values": ["3/2", "10", "-1/8", "3/2000", "-7", ")" + digits + R"("]})");
}

TEST_CASE("points mirror the form of the input") {
    const auto value = [](const std::string& map) {
        return result(R"("op": "evaluate", "at": [2], "map": {"kind": "polynomial", )" + map + "}");
    };
    CHECK(value(R"("coefficients": ["1", "1"])") == R"({"values": ["3"]})");
    CHECK(value(R"("coefficients": [["1"], ["1"]])") == R"({"values": [["3"]]})");
    CHECK(value(R"("text": ["1 + x"])") == R"({"values": [["3"]]})");
    CHECK(value(R"("text": ["1 + x", "2", "x"])") == R"({"values": [["3", "2", "2"]]})");
}

TEST_CASE("the formal degree is the actual one unless it is given") {
    const std::string arguments =
        R"("op": "blossom", "arguments": ["1", "3"], "map": {"kind": "polynomial", )";
    CHECK(result(arguments + R"("coefficients": ["0", "1"], "degree": 2})") == R"({"value": "2"})");
    CHECK(result(arguments + R"("coefficients": ["0", "0", "1", "0", "0"]})") == R"({"value": "3"})");
    CHECK(served_at("/error/code", "{" + arguments + R"("coefficients": ["0", "1", "0"]}})") ==
          "\"wrong_arity\"");
}

TEST_CASE("each construction gives the blossom") {
    for (const std::string construction : {"symmetric", "polarization", "casteljau"}) {
        CHECK(result(R"("op": "blossom", "arguments": ["1", "2", "3"], "construction": ")" + construction +
                     "\", " + cubic) == R"({"value": "41/3"})");
    }
}

TEST_CASE("a rational map is divided by its weight") {
    CHECK(result(R"("op": "evaluate", "at": ["1/2", 1], )" + circle) ==
          R"({"values": [["3/5", "4/5"], ["0", "1"]]})");
    CHECK(result(R"("op": "blossom", "arguments": ["0", "1"], )" + circle) == R"({"value": ["1", "1"]})");
    CHECK(
        result(
            R"("op": "evaluate", "at": [2], "map": {"kind": "polynomial", "text": "1", "denominator": [0, 1]})") ==
        R"({"values": ["1/2"]})");
    CHECK(result(R"("op": "evaluate", "at": ["1/2"],
                    "map": {"kind": "bezier", "control_points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]})") ==
          R"({"values": [["3/5", "4/5"]]})");
}

TEST_CASE("a homogeneous map keeps the weight as its last coordinate") {
    const std::string line =
        R"("map": {"kind": "bezier", "control_points": [[1, 1], [1, 0]], "homogeneous": true})";
    CHECK(result(R"("op": "evaluate", "at": [1, "1/2"], )" + line) ==
          R"({"values": [["1", "0"], ["1", "1/2"]]})");
    CHECK(result(R"("op": "blossom", "arguments": [{"vector": 1}], )" + line) == R"({"value": ["0", "-1"]})");
    CHECK(result(R"("op": "control-points", "interval": [1, 2], )" + line) ==
          R"({"map": {"kind": "bezier", "degree": 1, "interval": ["1", "2"], )"
          R"("control_points": [["1", "0"], ["1", "-1"]], "homogeneous": true}})");
    CHECK(
        result(
            R"("op": "control-points", "map": {"kind": "polynomial", "text": "1", "denominator": "t", "degree": 1,
                    "homogeneous": true})") ==
        R"({"map": {"kind": "bezier", "degree": 1, "interval": ["0", "1"], )"
        R"("control_points": [["1", "0"], ["1", "1"]], "homogeneous": true}})");
}

TEST_CASE("control points of a degree and an interval") {
    CHECK(
        result(
            R"("op": "control-points", "interval": [0, 1], "degree": 2, "map": {"kind": "polynomial", "text": "t"})") ==
        R"({"map": {"kind": "bezier", "degree": 2, "interval": ["0", "1"], "control_points": ["0", "1/2", "1"]}})");
    const std::string bezier = R"("map": {"kind": "bezier", "control_points": [0, 2], "interval": [1, 3]})";
    CHECK(
        result(R"("op": "control-points", )" + bezier) ==
        R"({"map": {"kind": "bezier", "degree": 1, "interval": ["1", "3"], "control_points": ["0", "2"]}})");
    CHECK(
        result(R"("op": "control-points", "degree": 2, )" + bezier) ==
        R"({"map": {"kind": "bezier", "degree": 2, "interval": ["1", "3"], "control_points": ["0", "1", "2"]}})");
    CHECK(
        result(R"("op": "control-points", "interval": [5, -1], )" + bezier) ==
        R"({"map": {"kind": "bezier", "degree": 1, "interval": ["5", "-1"], "control_points": ["4", "-2"]}})");
}

TEST_CASE("a derivative is values or a map of the same kind") {
    CHECK(result(R"("op": "derivative", )" + cubic) ==
          R"({"map": {"kind": "polynomial", "degree": 2, "coefficients": ["2", "8", "-3"]}})");
    CHECK(result(R"("op": "derivative", "order": 4, )" + cubic) ==
          R"({"map": {"kind": "polynomial", "degree": 0, "coefficients": ["0"]}})");
    CHECK(result(R"("op": "derivative", "order": 0, "at": [2], )" + cubic) == R"({"values": ["13"]})");
    CHECK(
        result(
            R"("op": "derivative", "map": {"kind": "bezier", "control_points": [0, 1, 4], "interval": [0, 2]})") ==
        R"({"map": {"kind": "bezier", "degree": 1, "interval": ["0", "2"], "control_points": ["1", "3"]}})");
}

TEST_CASE("agreement at arguments shows the three values") {
    CHECK(
        result(R"("op": "agree", "arguments": ["1", "2", "3"], )" + cubic) ==
        R"({"agree": true, "degree": 3, "values": {"symmetric": "41/3", "polarization": "41/3", "casteljau": "41/3"}, )"
        R"("skipped": []})");
}

TEST_CASE("agreement without arguments is proved for all") {
    CHECK(result(R"("op": "agree", "map": {"kind": "polynomial", "text": "1 + 3x^2"})") ==
          R"({"agree": true, "for_all_arguments": true, "degree": 2, "elementary": "1 + 3 e2", )"
          R"("expansion": "1 + 3 u1*u2", "skipped": []})");
    CHECK(result(R"("op": "agree", "map": {"kind": "bezier", "control_points": [[0, 1], [1, 1]]})") ==
          R"({"agree": true, "for_all_arguments": true, "degree": 1, "elementary": ["e1", "1"], )"
          R"("expansion": ["u1", "1"], "skipped": []})");
}

TEST_CASE("what was not run is skipped and never agrees") {
    std::string arguments;
    for (int i = 0; i < 64; ++i) arguments += (i == 0 ? "" : ", ") + std::to_string(i);
    const Json response =
        served(R"({"op": "agree", "map": {"kind": "polynomial", "text": "t^64"}, "arguments": [)" +
               arguments + "]}");
    CHECK(protocol::to_text(*at_pointer(response, "/result/agree")) == "true");
    CHECK(at_pointer(response, "/result/values/polarization") == nullptr);
    CHECK(at_pointer(response, "/result/values/regrouped-polarization") != nullptr);
    CHECK(at_pointer(response, "/result/values/casteljau") != nullptr);
    CHECK(*at_pointer(response, "/result/skipped/0/construction") == Json("polarization"));
    CHECK(at_pointer(response, "/result/skipped/0/reason")->text()->find("polarization_terms") !=
          std::string::npos);
    CHECK(served_at("/error/code", R"({"op": "blossom", "construction": "polarization",
                                       "map": {"kind": "polynomial", "text": "t^64"}, "arguments": [)" +
                                       arguments + "]}") == "\"limit_exceeded\"");
}

TEST_CASE("what was not run on symbols is skipped too") {
    Limits limits;
    limits.expansion_work = 1;
    const std::string text = result(R"("op": "agree", "map": {"kind": "polynomial", "text": "t^2"})", limits);
    CHECK(text.starts_with(R"({"agree": true, "for_all_arguments": true, )"));
    CHECK(text.find(R"("skipped": [{"construction": "polarization", "reason": ")") != std::string::npos);
    CHECK(text.find("expansion_work = 1") != std::string::npos);
}

TEST_CASE("a disagreement has its own outcome") {
    const auto outcome = [](const char* result) { return outcome_of(parse_json(result, Limits{})); };
    CHECK(outcome(R"({"agree": false})") == Outcome::disagreement);
    CHECK(outcome(R"({"agree": true})") == Outcome::success);
    CHECK(outcome(R"({"value": "1"})") == Outcome::success);
    CHECK(protocol::answer("{}").outcome == Outcome::refused);
}

TEST_CASE("rounded numbers are given beside the exact ones, in the same shape") {
    CHECK(result(R"("op": "evaluate", "at": ["1/3"], "numbers": "double", )" + circle) ==
          R"({"values": [["4/5", "3/5"]], "values_double": [[0.8, 0.6]]})");
    CHECK(
        result(R"("op": "evaluate", "at": ["1/3"], "numbers": "hexfloat", )" + circle) ==
        R"({"values": [["4/5", "3/5"]], "values_hex": [["0x1.999999999999ap-1", "0x1.3333333333333p-1"]]})");
    CHECK(result(R"("op": "control-points", "numbers": "double", "degree": 1,
                    "map": {"kind": "polynomial", "text": "t", "denominator": "3"})") ==
          R"({"map": {"kind": "bezier", "degree": 1, "interval": ["0", "1"], "interval_double": [0, 1], )"
          R"("control_points": ["0", "1/3"], "control_points_double": [0, 0.3333333333333333], )"
          R"("weights": ["3", "3"], "weights_double": [3, 3]}})");
    CHECK(
        result(
            R"("op": "agree", "arguments": ["1/2"], "numbers": "double", "map": {"kind": "polynomial", "text": "t"})") ==
        R"({"agree": true, "degree": 1, "values": {"symmetric": "1/2", "symmetric_double": 0.5, )"
        R"("polarization": "1/2", "polarization_double": 0.5, "casteljau": "1/2", "casteljau_double": 0.5}, )"
        R"("skipped": []})");
    CHECK(result(R"("op": "agree", "numbers": "double", "map": {"kind": "polynomial", "text": "t"})")
              .find("_double") == std::string::npos);
}

TEST_CASE("nested and mixed shapes are rounded too") {
    // A constructor with a count, not braces: compilers differ on a braced list whose one element is a list.
    const Json::Array row{Json(std::size_t{2}), Rational(1, 4)};
    const Json::Array net(1, Json(row));
    const Json::Array maps(1, Json(Json::Object{{"net", Json(net)}}));
    Json result = Json::Object{{"maps", Json(maps)}, {"name", "x"}, {"empty", Json::Array{}}};
    add_rounded_numbers(result, Rounding::binary64);
    CHECK(protocol::to_text(result) ==
          R"({"maps": [{"net": [[2, "1/4"]], "net_double": [[2, 0.25]]}], "name": "x", "empty": []})");
}

TEST_CASE("a rounded number reads back as the nearest double") {
    for (const std::string number :
         {"1/3", "0.1", "5e-324", "1.7976931348623157e308", "-123456789/1000003", "1e22", "1e23"}) {
        const std::string text =
            served_at("/result/values_double/0",
                      R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "numbers": "double",
                                               "at": [")" +
                          number + "\"]}");
        CHECK(std::strtod(text.c_str(), nullptr) == nearest_double(parse_rational(number)));
    }
}

TEST_CASE("a number beyond the doubles names its place in the result") {
    CHECK(served_at("/error/message", R"({"op": "evaluate", "numbers": "hexfloat", "at": [0, "1e200"],
                                          "map": {"kind": "polynomial", "text": ["t", "t^2"]}})")
              .find("/values/1/1") != std::string::npos);
}
