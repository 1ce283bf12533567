#include <limits>
#include "answered.hpp"

#include "formats/doubles.hpp"

// Numbers and files of other libraries.

namespace {

Json number(const std::string& text) { return Json::Number{text}; }

}  // namespace

TEST_CASE("a double is read for the number that it is") {
    CHECK(read_double(number("0.5")) == Rational(1) / 2);
    CHECK(read_double(number("1e3")) == Rational(1000));
    CHECK(read_double(number("-25E-1")) == Rational(-5) / 2);
    CHECK(read_double(number("0.1")) == Rational(3602879701896397) / Rational(36028797018963968));
    CHECK(read_double("-0x1.8p+1") == Rational(-3));
    CHECK(read_double("0.1") == read_double(number("0.1")));
    for (const char* text : {"", "-", "--1", "x", "1/3", "nan", "inf", "0x", "1 "}) {
        CAPTURE(text);
        CHECK(failure_code([&] { read_double(text); }) == ErrorCode::not_a_number);
    }
    const std::string zeros(400, '0');
    for (const std::string& text :
         {std::string("1e400"), std::string("-1e+400"), "1" + zeros, "1" + zeros + "e-1", "1" + zeros + ".5",
          "0." + zeros + "1e900", std::string("1e99999999999999999999"), std::string("0x1p1024"),
          std::string("0x1.fffffffffffff8p+1023"), "0x1" + zeros, "0x1" + zeros + "p-9"}) {
        CAPTURE(text);
        CHECK(failure_code([&] { read_double(text); }) == ErrorCode::overflow);
    }
    for (const std::string& text :
         {std::string("1e-400"), std::string("-1e-400"), "0." + zeros + "1", "." + zeros + "1",
          "0." + zeros + "1e+9", "1" + zeros + "e-900", std::string("1e-99999999999999999999"),
          std::string("2e-324"), std::string("0x1p-1080"), "0x." + zeros + "1", "0x0." + zeros + "1p+9"}) {
        CAPTURE(text);
        CHECK(read_double(text) == 0);
    }
    CHECK(read_double("3e-324") == Rational(1) / pow(Rational(2), 1074));
    CHECK(read_double("0x1.8p-1075") == Rational(1) / pow(Rational(2), 1074));
    CHECK(failure_code([] { read_double(true); }) == ErrorCode::not_a_number);
}

TEST_CASE("an audit gives the exact error of each number, and its size in units in the last place") {
    const std::string map = R"("op": "audit", "map": {"kind": "bezier", "control_points": ["0", "1/3"]}, )";
    CHECK(
        result_text(map + R"("computed": {"control_points": [0, 0.3333333333333333]})") ==
        R"({"errors": {"control_points": ["0", "-1/54043195528445952"]}, )"
        R"("ulps": {"control_points": ["0", "1/3"]}, "greatest_ulps": "1/3", "numbers": 2, "not_nearest": 0})");
    CHECK(served_at("/result/not_nearest",
                    "{" + map + R"("computed": {"control_points": [5e-324, 0.33333333333333337]}})") == "2");
    CHECK(refusal_text(map + R"("computed": {"control_points": [0]})") ==
          "mismatched_dimensions /computed/control_points");
    CHECK(refusal_text(map + R"("computed": {"control_points": [0, [1]]})") ==
          "mismatched_dimensions /computed/control_points/1");
    CHECK(refusal_text(map + R"("computed": {"control_points": [0, null]})") ==
          "not_a_number /computed/control_points/1");
    CHECK(refusal_text(map + R"("computed": {"knots": [0]})") == "wrong_kind /computed/knots");
    CHECK(refusal_text(map + R"("computed": {})") == "missing_field /computed/control_points");
    CHECK(refusal_text(map + R"("computed": {"points": []})") == "unknown_field /computed/points");
}

TEST_CASE("what is exported is imported again, with its numbers rounded") {
    const std::string spline =
        R"("map": {"kind": "bspline", "degree": 1, "knots": ["0", "1/2"], "control_points": [["1/3", "2"], ["5", "-1"]])";
    for (const std::string format : {"tinyspline", "geomdl", "splinepy"}) {
        const bool weighted = format != "tinyspline";
        const std::string weights = weighted ? R"(, "weights": ["3", "1/2"]})" : "}";
        const std::string document =
            served_at("/result/document",
                      R"({"op": "export", "format": ")" + format + R"(", )" + spline + weights + "}");
        CAPTURE(format, document);
        const std::string read =
            result_text(R"("op": "import", "format": ")" + format + R"(", "document": )" + document);
        CHECK(read == R"({"maps": [{"kind": "bspline", "degree": 1, "knots": ["0", "0", "1/2", "1/2"], )"
                      R"("control_points": [["6004799503160661/18014398509481984", "2"], ["5", "-1"]])" +
                          std::string(weighted ? R"(, "weights": ["3", "1/2"])" : "") + "}]}");
    }
}

TEST_CASE("files as the other libraries write them are read") {
    CHECK(
        result_text(R"("op": "import", "format": "geomdl", "document": {"shape": {"type": "curve", "count": 1,
                    "data": [{"type": "spline", "rational": false, "dimension": 2, "degree": 1,
                              "knotvector": [0.0, 0.0, 1.0, 1.0], "delta": 0.01,
                              "control_points": {"points": [[0.0, 0.5], [1.0, 2.0]]}}]}})") ==
        R"({"maps": [{"kind": "bspline", "degree": 1, "knots": ["0", "0", "1", "1"], )"
        R"("control_points": [["0", "1/2"], ["1", "2"]]}]})");
    CHECK(result_text(R"("op": "import", "format": "splinepy", "document": {"Name": "SplineGroup",
                    "NumberOfSplines": 1, "Base64Encoding": false, "SplineList": [{"degrees": [1],
                    "control_points": [[0.0], [1.0]], "weights": [[1.0], [2.0]],
                    "SplineType": "RationalBezier", "dim": 1, "para_dim": 1}]})") ==
          R"({"maps": [{"kind": "bspline", "degree": 1, "knots": ["0", "0", "1", "1"], )"
          R"("control_points": [["0"], ["1"]], "weights": ["1", "2"]}]})");
    CHECK(refusal_text(R"("op": "import", "format": "tinyspline", "document": {"degree": 1, "dimension": 2,
                     "control_points": [0, 1, 2], "knots": [0, 0, 1, 1]})") ==
          "mismatched_dimensions /document/control_points");
    CHECK(refusal_text(R"("op": "import", "format": "splinepy", "document": {"Base64Encoding": true})") ==
          "wrong_kind /document/Base64Encoding");
    CHECK(refusal_text(R"("op": "import", "format": "geomdl", "document": {"shape": {"type": "solid"}})") ==
          "wrong_kind /document/shape/type");
    CHECK(refusal_text(R"("op": "import", "format": "iges", "document": {})") == "wrong_kind /format");
    CHECK(refusal_text(R"("op": "export", "format": "tinyspline", "map": {"kind": "bezier",
                     "control_points": [1], "weights": [2]})") == "wrong_kind /map");
}
