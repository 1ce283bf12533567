#include "answered.hpp"

namespace {

/// The document for one request, or the code of the error.
std::string certified(const std::string& request, const Limits& limits = {}) {
    const Json response = served(R"({"op": "certify", "requests": [)" + request + "]}", limits);
    const Json* document = at_pointer(response, "/result/document");
    return document ? *document->text() : *at_pointer(response, "/error/code")->text();
}

bool says(const std::string& request, const std::string& line) {
    const std::string document = certified(request);
    CAPTURE(document);
    return document.find("\n   " + line) != std::string::npos;
}

std::string about(const std::string& map, const std::string& rest) {
    return R"({"map": )" + map + ", " + rest + "}";
}

const std::string cubic = R"({"kind": "polynomial", "text": "1 + 2t + 4t^2 - t^3"})";
const std::string parabola =
    R"({"kind": "bezier", "control_points": ["0", "1", "4"], "interval": ["1", "3"]})";

}  // namespace

TEST_CASE("certify: a value, control points, derivatives and the expansion are shown in comments") {
    CHECK(says(about(cubic, R"("op": "blossom", "arguments": ["1/2", "-2/3", {"vector": "1"}])"),
               "value = p[1/2, -2/3, delta] = 7/9 *)"));
    CHECK(says(about(cubic, R"("op": "control-points", "interval": ["2", "-1"])"),
               "control point 1 = p[2 (2 times), -1] = 7\n"));
    CHECK(says(about(cubic, R"("op": "derivative", "order": 2, "at": ["1/2"])"),
               "derivative 2 at 1/2 = 6 p[1/2, delta (2 times)] = 5 *)"));
    CHECK(says(about(cubic, R"("op": "derivative", "order": 2)"),
               "coefficient 1 = 6 p[delta (3 times)] = -6 *)"));
    CHECK(says(about(cubic, R"("op": "derivative", "order": 5)"),
               "coefficient 0 = 0 p[delta (3 times)] = 0 *)"));
    CHECK(says(about(cubic, R"("op": "agree")"), "coefficient of e2 = p[0, delta (2 times)] = 4/3\n"));
    CHECK(says(about(cubic, R"("op": "agree", "arguments": ["1", "2", "3"])"),
               "casteljau = p[1, 2, 3] = 41/3 *)"));
}

TEST_CASE(
    "certify: a value of a tensor product is one of the curves along its directions, the last one first") {
    const std::string bilinear =
        R"({"kind": "tensor", "degrees": [1, 1], "control_net": [["0", "1"], ["2", "5"]]})";
    const std::string value = about(bilinear, R"("op": "blossom", "arguments": [["1/2"], ["1/3"]])");
    CHECK(says(value, "rows for direction 0 = p[1/3] = (1/3, 3)"));
    CHECK(says(value, "given control point 1 = p[1] = 3\n"));
    CHECK(says(value, "value = p[1/2] = 5/3 *)"));
    CHECK(says(about(bilinear, R"("op": "agree", "arguments": [["1/2"], ["1/3"]])"),
               "casteljau = p[1/2] = 5/3"));
    CHECK(says(about(R"({"kind": "polynomial", "text": "u*v", "variables": ["u", "v"], "degrees": [1, 1]})",
                     R"("op": "blossom", "arguments": [["1/2"], [{"vector": "3"}]])"),
               "value = p[1/2] = 3/2 *)"));
    CHECK(says(
        about(
            R"({"kind": "bspline", "degrees": [1, 0], "knots": [[0, 0, 1, 2, 2], [0, 1]], "control_net": [[0], [2], [0]]})",
            R"("op": "blossom", "segment": [2, 0], "arguments": [["3/2"], []])"),
        "value = p[3/2] = 1 *)"));
    CHECK(certified(about(bilinear, R"("op": "derivative", "direction": [1, 0])")) == "wrong_kind");
    CHECK(certified(about(bilinear, R"("op": "agree")")) == "wrong_kind");
}

TEST_CASE("certify: control points and Taylor coefficients that are given are certified with the answer") {
    const std::string value = about(parabola, R"("op": "blossom", "arguments": ["0", "5"])");
    CHECK(says(value, "given control point 1 = p[1, 3] = 1\n"));
    CHECK(says(value, "value = p[0, 5] = -1/2 *)"));
    const std::string raised = about(parabola, R"("op": "control-points", "degree": 3)");
    CHECK(says(raised, "P has degree 2"));
    CHECK(says(raised, "P has degree 3"));
    CHECK(says(about(R"({"kind": "taylor", "center": "2", "coefficients": ["1", "3"]})",
                     R"("op": "blossom", "arguments": ["5"])"),
               "given coefficient 1 = p[delta] = 3\n"));
}

TEST_CASE("certify: the words are 4 |x| + 2 [x < 0], or a count of 60-bit words that follow") {
    const std::string document =
        certified(about(R"({"kind": "polynomial", "coefficients": ["-2305843009213693953"]})",
                        R"("op": "blossom", "arguments": [])"));
    // One map of degree 0 over 1, the coefficient -2^61 - 1 as two words, and one value, each once.
    CHECK(document.find("[:: 4; 0; 4; 11; 1;\n     2; 4; 4; 11; 1;\n     2; 4]]%uint63") !=
          std::string::npos);
}

TEST_CASE("certify: several requests are numbered, what has no certificate is refused at its place") {
    const std::string one = about(cubic, R"("op": "derivative")");
    const std::string document = certified(one + ", " + one);
    CHECK(document.find("Definition request_1_holds") != std::string::npos);
    CHECK(document.find("Definition request_2_holds") != std::string::npos);

    const std::string line = R"({"op": "certify", "requests": [)" + one + ", ";
    CHECK(served_at("/error/at", line + about(cubic, R"("op": "evaluate", "at": ["1"])") + "]}") ==
          "\"/requests/1/op\"");
    CHECK(served_at("/error/at", line + about(cubic, R"("op": "blossom", "arguments": ["1"])") + "]}") ==
          "\"/requests/1/arguments\"");
    const std::string rational = R"({"kind": "polynomial", "text": "1", "denominator": "1 + t"})";
    CHECK(served_at("/error/at", line + about(rational, R"("op": "derivative")") + "]}") ==
          "\"/requests/1/map\"");
    CHECK(certified(about(rational, R"("op": "derivative", "at": ["0"])")) == "wrong_kind");
    CHECK(certified(about(R"({"kind": "samples", "degree": 0, "values": [["0", "1"]]})",
                          R"("op": "control-points")")) == "wrong_kind");
    CHECK(
        certified(
            about(R"({"kind": "polynomial", "coefficients": [["1", "1"], ["0", "1"]], "homogeneous": true})",
                  R"("op": "blossom", "arguments": ["1"])"))
            .find("= (1, 2) *)") != std::string::npos);
}

TEST_CASE("certify: of a rational map the homogeneous point is certified") {
    const std::string rational = R"({"kind": "polynomial", "text": "1", "denominator": "1 + t"})";
    const std::string document = certified(about(rational, R"("op": "blossom", "arguments": ["1"])"));
    CHECK(document.find("value = p[1] = (1, 2) *)") != std::string::npos);
}

TEST_CASE("certify: progressive values and the control points of splines are certified with the answer") {
    const std::string progressive = certified(
        about(R"({"kind": "progressive", "knots": ["0", "1", "2", "3"], "control_points": ["0", "2", "6"]})",
              R"("op": "blossom", "arguments": ["1/2", "1/2"])"));
    CHECK(progressive.find("given control point 2 = p[2, 3] = 6\n") != std::string::npos);
    CHECK(progressive.find("value = p[1/2 (2 times)] = 1/4 *)") != std::string::npos);

    const std::string spline =
        R"({"kind": "bspline", "degree": 2, "knots": ["0", "0", "1", "2", "3", "3"], "control_points": )"
        R"(["0", "1", "4", "5", "9"]})";
    const std::string value =
        certified(about(spline, R"("op": "blossom", "segment": 2, "arguments": ["1", "3/2"])"));
    CHECK(value.find("given control point 0 = p[0, 1] = 1\n") != std::string::npos);
    CHECK(value.find("given control point 2 = p[2, 3] = 5\n") != std::string::npos);
    CHECK(value.find("value = p[1, 3/2] = 13/4 *)") != std::string::npos);
    CHECK(certified(about(spline, R"("op": "blossom", "arguments": ["1", "3/2"])")) == "outside_domain");

    // One polynomial per parameter, and one per span of the derived spline.
    const std::string values = certified(about(spline, R"("op": "derivative", "at": ["1/2", "3/2"])"));
    CHECK(values.find("derivative 1 at 1/2 = 2 p[1/2, delta] = ") != std::string::npos);
    CHECK(values.find("derivative 1 at 3/2 = 2 p[3/2, delta] = 2 *)") != std::string::npos);
    const std::string derived = certified(about(spline, R"("op": "derivative")"));
    CHECK(derived.find("control point 1 = 2 p[3, delta] = 8 *)") != std::string::npos);
    const std::string part =
        certified(about(spline, R"("op": "control-points", "interval": ["1", "2"], "degree": 3)"));
    CHECK(part.find("control point 3 = p[2 (3 times)] = 9/2 *)") != std::string::npos);
}

TEST_CASE("certify: the size is refused before it is written") {
    const std::string large =
        about(R"({"kind": "polynomial", "text": "t^100"})", R"("op": "control-points")");
    Limits few_numbers;
    few_numbers.numbers = 1000;
    CHECK(certified(large, few_numbers) == "limit_exceeded");
    Limits few_digits;
    few_digits.output_digits = 10'000;
    CHECK(certified(large, few_digits) == "limit_exceeded");
}
