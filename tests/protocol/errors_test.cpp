#include <blossom/rational/error.hpp>
#include "answered.hpp"

namespace {

struct Case {
    std::string request;
    std::string code;
    std::string at;
};

const std::string cubic = R"("map": {"kind": "polynomial", "coefficients": ["1", "2", "4", "-1"]})";

std::string evaluate(const std::string& map, const std::string& at = R"(["1"])") {
    return R"({"op": "evaluate", "map": )" + map + R"(, "at": )" + at + "}";
}
std::string polynomial(const std::string& fields) {
    return evaluate(R"({"kind": "polynomial", )" + fields + "}");
}
std::string bezier(const std::string& fields) { return evaluate(R"({"kind": "bezier", )" + fields + "}"); }

const std::vector<Case> cases{
    // the request as a whole
    {"", "syntax", ""},
    {"nonsense", "syntax", ""},
    {R"({"op": "evaluate", "at": [1], "at": [2]})", "syntax", ""},
    {"[]", "wrong_kind", ""},
    {"5", "wrong_kind", ""},
    {"{}", "missing_field", "/op"},
    {R"({"op": "evalute"})", "unknown_op", "/op"},
    {R"({"op": 5})", "wrong_kind", "/op"},
    {R"({"op": "evaluate"})", "missing_field", "/map"},
    {R"({"op": "evaluate", )" + cubic + "}", "missing_field", "/at"},
    {R"({"op": "evaluate", "at": [1], )" + cubic + R"(, "sample/rate": 1})", "unknown_field",
     "/sample~1rate"},
    {R"({"op": "evaluate", "at": [1], "numbers": "float", )" + cubic + "}", "wrong_kind", "/numbers"},
    {R"({"op": "evaluate", "at": [1], "numbers": 2, )" + cubic + "}", "wrong_kind", "/numbers"},
    // numbers
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[1, 0.5]"), "inexact_number", "/at/1"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[1e400]"), "inexact_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[-0.0]"), "inexact_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[1e5]"), "inexact_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[\"0x10\"]"), "not_a_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[\"\"]"), "not_a_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[\" 1\"]"), "not_a_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[\"+1\"]"), "not_a_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[\"6/-4\"]"), "not_a_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[null]"), "not_a_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[true]"), "not_a_number", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "[\"1/0\"]"), "zero_denominator", "/at/0"},
    {evaluate(R"({"kind": "polynomial", "text": "t"})", "\"1\""), "wrong_kind", "/at"},
    // maps
    {evaluate("5"), "wrong_kind", "/map"},
    {evaluate("{}"), "missing_field", "/map/kind"},
    {evaluate(R"({"kind": 5})"), "wrong_kind", "/map/kind"},
    {evaluate(R"({"kind": "klothoid"})"), "wrong_kind", "/map/kind"},
    {evaluate(R"({"kind": ""})"), "wrong_kind", "/map/kind"},
    {polynomial(R"("degree": 2)"), "missing_field", "/map/coefficients"},
    {polynomial(R"("coefficients": [])"), "wrong_arity", "/map/coefficients"},
    {polynomial(R"("coefficients": "1")"), "wrong_kind", "/map/coefficients"},
    {polynomial(R"("coefficients": [["1", "2"], ["3"]])"), "mismatched_dimensions", "/map/coefficients/1"},
    {polynomial(R"("coefficients": ["1", ["2"]])"), "mismatched_dimensions", "/map/coefficients/1"},
    {polynomial(R"("coefficients": [[]])"), "mismatched_dimensions", "/map/coefficients/0"},
    {polynomial(R"("coefficients": ["1", "1/0"])"), "zero_denominator", "/map/coefficients/1"},
    {polynomial(R"("coefficients": [["1", "2"], ["1", 0.5]])"), "inexact_number", "/map/coefficients/1/1"},
    {polynomial(R"("coefficients": ["0", "1"], "degree": 0)"), "degree_too_low", "/map/degree"},
    {polynomial(R"("coefficients": ["0", "1"], "degree": -1)"), "wrong_kind", "/map/degree"},
    {polynomial(R"("coefficients": ["0", "1"], "degree": "1/2")"), "wrong_kind", "/map/degree"},
    {polynomial(R"("coefficients": ["0", "1"], "degree": 999999999999)"), "limit_exceeded", "/map/degree"},
    {polynomial(R"("coefficients": ["0", "1"], "degree": 99999999999999999999)"), "limit_exceeded",
     "/map/degree"},
    {polynomial(R"("coefficients": ["0", "1"], "text": "t")"), "wrong_kind", "/map/coefficients"},
    {polynomial(R"("coefficients": ["0", "1"], "degre": 1)"), "unknown_field", "/map/degre"},
    {polynomial(R"("text": 5)"), "wrong_kind", "/map/text"},
    {polynomial(R"("text": [])"), "wrong_arity", "/map/text"},
    {polynomial(R"("text": ["t", 5])"), "wrong_kind", "/map/text/1"},
    {polynomial(R"("text": ["t", "1 +"])"), "syntax", "/map/text/1"},
    {polynomial(R"("text": ["t", "x"])"), "syntax", "/map/text/1"},
    {polynomial(R"("text": "x*y")"), "syntax", "/map/text"},
    {polynomial(R"("text": "t/0")"), "zero_denominator", "/map/text"},
    {polynomial(R"("text": "t^999999999999")"), "limit_exceeded", "/map/text"},
    {polynomial(R"("text": "t", "denominator": "0")"), "zero_denominator", "/map/denominator"},
    {polynomial(R"("text": "t", "denominator": [0, "0"])"), "zero_denominator", "/map/denominator"},
    {polynomial(R"("text": "t", "denominator": 5)"), "wrong_kind", "/map/denominator"},
    {polynomial(R"("text": "t", "denominator": "1 - x")"), "syntax", "/map/denominator"},
    {polynomial(R"("text": "t", "denominator": "1 - t")"), "zero_weight", "/at/0"},
    {polynomial(R"("text": "t", "homogeneous": true)"), "mismatched_dimensions", "/map/homogeneous"},
    {polynomial(R"("text": "t", "homogeneous": 1)"), "wrong_kind", "/map/homogeneous"},
    {bezier(R"("points": [])"), "missing_field", "/map/control_points"},
    {bezier(R"("control_points": [])"), "wrong_arity", "/map/control_points"},
    {bezier(R"("control_points": ["1", ["2"]])"), "mismatched_dimensions", "/map/control_points/1"},
    {bezier(R"("control_points": ["1", "x"])"), "not_a_number", "/map/control_points/1"},
    {bezier(R"("control_points": ["1"], "interval": ["1"])"), "wrong_arity", "/map/interval"},
    {bezier(R"("control_points": ["1"], "interval": ["1", "2/2"])"), "empty_interval", "/map/interval"},
    {bezier(R"("control_points": ["1"], "weights": ["1", "2"])"), "wrong_arity", "/map/weights"},
    {bezier(R"("control_points": ["1", "2"], "weights": ["1", "0"])"), "zero_weight", "/map/weights/1"},
    {bezier(R"("control_points": ["1", "2"], "weights": ["1", "-1"], "interval": [0, 2])"), "zero_weight",
     "/at/0"},
    {bezier(R"("control_points": ["1", "2"], "homogeneous": true)"), "mismatched_dimensions",
     "/map/control_points"},
    {bezier(R"("control_points": [["1", "2"]], "homogeneous": true, "weights": ["1"])"), "wrong_kind",
     "/map/weights"},
    {bezier(R"("control_points": ["1", "2"], "degree": 2)"), "wrong_arity", "/map/degree"},
    // operations
    {R"({"op": "blossom", "arguments": ["1", "2"], )" + cubic + "}", "wrong_arity", "/arguments"},
    {R"({"op": "blossom", "arguments": ["1", "2", {}], )" + cubic + "}", "missing_field",
     "/arguments/2/vector"},
    {R"({"op": "blossom", "arguments": ["1", "2", {"vektor": 1}], )" + cubic + "}", "unknown_field",
     "/arguments/2/vektor"},
    {R"({"op": "blossom", "arguments": ["1", "2", {"vector": 0.5}], )" + cubic + "}", "inexact_number",
     "/arguments/2/vector"},
    {R"({"op": "blossom", "arguments": ["1", "2", {"vector": 1, "homogeneous": [1, 2]}], )" + cubic + "}",
     "unknown_field", "/arguments/2/homogeneous"},
    {R"({"op": "blossom", "arguments": ["1", "2", {"homogeneous": ["1"]}], )" + cubic + "}", "wrong_arity",
     "/arguments/2/homogeneous"},
    {R"({"op": "blossom", "arguments": ["1", "2", "3"], "construction": "horner", )" + cubic + "}",
     "wrong_kind", "/construction"},
    {R"({"op": "blossom", "arguments": ["1", "2", "3"], "segment": 3, )" + cubic + "}", "unknown_field",
     "/segment"},
    {R"({"op": "blossom", "arguments": ["1", {"vector": 1}],
         "map": {"kind": "bezier", "control_points": [1, 2, 3], "weights": [1, 1, 2]}})",
     "zero_weight", "/arguments/1"},
    {R"({"op": "blossom", "arguments": ["1", "1"], "map": {"kind": "polynomial", "text": "t", "denominator": "1 - t^2"}})",
     "zero_weight", "/arguments"},
    {R"({"op": "agree", "arguments": ["1"], )" + cubic + "}", "wrong_arity", "/arguments"},
    {R"({"op": "derivative", "order": -1, )" + cubic + "}", "wrong_kind", "/order"},
    {R"({"op": "derivative", "order": 99999999999, )" + cubic + "}", "limit_exceeded", "/order"},
    {R"({"op": "derivative", "at": ["1", "x"], )" + cubic + "}", "not_a_number", "/at/1"},
    {R"({"op": "derivative", "map": {"kind": "samples", "degree": 1, "values": [["0", "1"]]}})", "wrong_kind",
     "/map"},
    {R"({"op": "control-points", "interval": ["1/3", "2/6"], )" + cubic + "}", "empty_interval", "/interval"},
    {R"({"op": "control-points", "interval": ["1", "2", "3"], )" + cubic + "}", "wrong_arity", "/interval"},
    {R"({"op": "control-points", "degree": 2, )" + cubic + "}", "degree_too_low", "/degree"},
    {R"({"op": "control-points", "degree": 2, "map": {"kind": "bezier", "control_points": [0, 0, 0, 1]}})",
     "degree_too_low", "/degree"},
    {R"({"op": "control-points", "interval": [0, 1],
         "map": {"kind": "polynomial", "text": "1", "denominator": "t", "degree": 2}})",
     "zero_weight", "/map"},
    {R"({"op": "evaluate", "numbers": "double", "at": ["1e400"], )" + cubic + "}", "overflow", "/numbers"},
};

}  // namespace

TEST_CASE("every refused request says which rule and where") {
    for (const auto& [request, code, at] : cases) {
        CAPTURE(request);
        const Json response = served(request);
        CHECK(protocol::to_text(*response.find("ok")) == "false");
        CHECK(response.find("result") == nullptr);
        REQUIRE(response.find("error"));
        CHECK(*response.find("error")->find("code") == Json(code));
        CHECK(*response.find("error")->find("at") == Json(at));
        CHECK(response.find("error")->find("message")->text()->size() > 10);
    }
}

TEST_CASE("the cases cover the error codes of the protocol") {
    std::set<std::string> covered;
    for (const Case& each : cases) covered.insert(each.code);
    for (const ErrorCode code :
         {ErrorCode::syntax, ErrorCode::inexact_number, ErrorCode::not_a_number, ErrorCode::zero_denominator,
          ErrorCode::overflow, ErrorCode::missing_field, ErrorCode::unknown_field, ErrorCode::unknown_op,
          ErrorCode::wrong_kind, ErrorCode::wrong_arity, ErrorCode::empty_interval, ErrorCode::degree_too_low,
          ErrorCode::mismatched_dimensions, ErrorCode::zero_weight, ErrorCode::limit_exceeded}) {
        CHECK(covered.count(std::string(error_name(code))) == 1);
    }
}

TEST_CASE("a name that is nearly right is suggested") {
    const auto message = [](const std::string& request) { return served_at("/error/message", request); };
    CHECK(message(R"({"op": "evalute"})").find("did you mean \\\"evaluate\\\"?") != std::string::npos);
    CHECK(message(polynomial(R"("text": "t", "degre": 1)")).find("did you mean \\\"degree\\\"?") !=
          std::string::npos);
    CHECK(message(R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "att": [1]})")
              .find("was it meant by \\\"att\\\"?") != std::string::npos);
    CHECK(message(R"({"op": "x"})").find("did you mean") == std::string::npos);
    CHECK(message(evaluate(R"({"kind": "spline"})")).find("known are: polynomial, bezier") !=
          std::string::npos);
}

TEST_CASE("the first unknown field is named, however many there are") {
    for (const int count : {1, 7, 62, 63, 64, 65, 200}) {
        std::string others;
        for (int i = 0; i < count; ++i) others += R"(, "other )" + std::to_string(i) + R"(": 0)";
        CHECK(served_at("/error/at", R"({"at": [1], "op": "evaluate", )" + cubic + others + "}") ==
              R"("/other 0")");
        CHECK(served_at("/error/at", "{" + others.substr(2) + R"(, "at": [1], "op": "evaluate", )" + cubic +
                                         "}") == R"("/other 0")");
    }
}

TEST_CASE("the id comes back exactly, in errors too") {
    for (const std::string id : {"1", "-0.50", "1e400", "12345678901234567890123", "\"é\"", "null", "false",
                                 "[1, {\"a\": \"b\"}]", "-0"}) {
        CHECK(served_at("/id", R"({"id": )" + id + R"(, "op": "none"})") == id);
        CHECK(served_at("/id", R"({"id": )" + id + R"(, "op": "evaluate", "at": ["1"], )" + cubic + "}") ==
              id);
        CHECK(served_at("/id", R"({"id": )" + id + ", \"op\": ") == id);
    }
    CHECK(served(R"({"op": "none"})").find("id") == nullptr);
}
