#include <blossom/core/blossom/evaluation.hpp>

#include "answered.hpp"

#include "formats/svg_path.hpp"

// SVG paths and the splines of FITPACK.

namespace {

std::vector<Map> curves(std::string_view text, Floats floats = Floats::decimal) {
    return svg_path_curves(text, floats, Limits{});
}

/// The control points of each curve, "(0, 0) (1, 2)".
std::string points(std::string_view text) {
    std::string all;
    for (const Map& map : curves(text))
        all += (all.empty() ? "" : " ") + to_text(*to_json(map).find("control_points"));
    return all;
}

Json point_at_begin(const Map& map) { return to_json(map).find("control_points")->array()->front(); }
Json point_at_end(const Map& map) { return to_json(map).find("control_points")->array()->back(); }

/// Whether a curve lies on the ellipse of this centre and radii: each coordinate of degree 2 over the weight.
bool lies_on(const Map& map, const Rational& x, const Rational& y, const Rational& rx, const Rational& ry) {
    const auto& curve = std::get<BezierCurve>(map.value);
    for (int i = 0; i <= 4; ++i) {
        const Coordinates point = evaluate(curve, curve.interval().a() + Rational(i, 4));
        const Rational u = (point[0] - x * point[2]) / rx;
        const Rational v = (point[1] - y * point[2]) / ry;
        if (u * u + v * v != point[2] * point[2]) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("a path is a list of Bezier curves") {
    CHECK(points("M0 0C1 2 3 2 4 0") == R"([["0", "0"], ["1", "2"], ["3", "2"], ["4", "0"]])");
    CHECK(points("M0,0 L1,2 3,4") == R"([["0", "0"], ["1", "2"]] [["1", "2"], ["3", "4"]])");
    CHECK(points("m1 1 2 0 0 2z") ==
          R"([["1", "1"], ["3", "1"]] [["3", "1"], ["3", "3"]] [["3", "3"], ["1", "1"]])");
    CHECK(points("M1 1H2V3h-1v-1") == R"([["1", "1"], ["2", "1"]] [["2", "1"], ["2", "3"]] )"
                                      R"([["2", "3"], ["1", "3"]] [["1", "3"], ["1", "2"]])");
    CHECK(points("M0 0Q1 2 2 0T4 0") ==
          R"([["0", "0"], ["1", "2"], ["2", "0"]] [["2", "0"], ["3", "-2"], ["4", "0"]])");
    CHECK(points("M0 0q1 2 2 0t2 0") == points("M0 0Q1 2 2 0T4 0"));
    CHECK(points("M0 0T4 0") == R"([["0", "0"], ["0", "0"], ["4", "0"]])");
    CHECK(
        points("M0 0C0 1 1 1 1 0S2 -1 2 0") ==
        R"([["0", "0"], ["0", "1"], ["1", "1"], ["1", "0"]] [["1", "0"], ["1", "-1"], ["2", "-1"], ["2", "0"]])");
    CHECK(points("M0 0c0 1 1 1 1 0s1-1 1 0") == points("M0 0C0 1 1 1 1 0S2 -1 2 0"));
    CHECK(points("M.5.5-.5-1e1") == R"([["1/2", "1/2"], ["-1/2", "-10"]])");
    CHECK(points("M0 0L1 0Zm2 2h1") ==
          R"([["0", "0"], ["1", "0"]] [["1", "0"], ["0", "0"]] [["2", "2"], ["3", "2"]])");
    CHECK(points("M3 4") == "");
    CHECK(to_json(curves("M.1 0H1", Floats::binary64).front()) !=
          to_json(curves("M.1 0H1", Floats::decimal).front()));
    const std::vector<Map> several = curves("M0 0H1H2");
    CHECK(std::get<BezierCurve>(several[1].value).interval() == Interval(1, 2));
}

TEST_CASE("an arc is rational where its centre is") {
    CHECK(to_text(to_json(curves("M1 0A1 1 0 0 1 0 1").front())) ==
          R"({"kind": "bezier", "degree": 2, "interval": ["0", "1"], )"
          R"("control_points": [["1", "0"], ["1", "1"], ["0", "1"]], "weights": ["1", "1/2", "1/2"]})");
    struct Example {
        const char* path;
        std::size_t parts;
        Rational x, y, rx, ry;
    };
    for (const Example& example :
         {Example{"M1 0A1 1 0 0 1 0 1", 1, 0, 0, 1, 1}, Example{"M1 0A1 1 0 1 0 0 1", 3, 0, 0, 1, 1},
          Example{"M1 0A1 1 0 0 0 0 1", 1, 1, 1, 1, 1}, Example{"M1 0A1 1 0 1 1 0 1", 3, 1, 1, 1, 1},
          Example{"M0 0A5 5 0 0 1 3 1", 1, 0, 5, 5, 5}, Example{"M0 0a5,3 0 01 5 3", 1, 0, 3, 5, 3},
          Example{"M0 0A3 5 90 0 1 5 3", 1, 0, 3, 5, 3}, Example{"M0 0A3 5 -270 0 1 5 3", 1, 0, 3, 5, 3},
          Example{"M-1 0A1 1 0 0 1 1 0", 2, 0, 0, 1, 1}, Example{"M-1 0A.1 .1 0 0 1 1 0", 2, 0, 0, 1, 1},
          Example{"M-.6.8A1 1 33 0 0 .6.8", 1, 0, 0, 1, 1},
          Example{"M-.6.8A1 1 0 1 0 .6.8", 4, 0, Rational(8, 5), 1, 1}}) {
        CAPTURE(example.path);
        const std::vector<Map> parts = curves(example.path);
        CHECK(parts.size() == example.parts);
        const Map closing = curves(std::string(example.path) + "Z").back();
        CHECK(point_at_end(parts.back()) == point_at_begin(closing));
        CHECK(point_at_begin(parts.front()) == point_at_end(closing));
        for (std::size_t i = 1; i < parts.size(); ++i)
            CHECK(point_at_end(parts[i - 1]) == point_at_begin(parts[i]));
        for (const Map& part : parts) CHECK(lies_on(part, example.x, example.y, example.rx, example.ry));
    }
    CHECK(points("M0 0A0 3 0 0 1 2 2") == R"([["0", "0"], ["2", "2"]])");
    CHECK(points("M1 1A2 3 0 0 1 1 1L0 0") == R"([["1", "1"], ["0", "0"]])");
}

TEST_CASE("what is no path is refused with its place") {
    struct Example {
        const char* path;
        std::size_t offset;
        ErrorCode code = ErrorCode::syntax;
    };
    for (const Example& example :
         {Example{"L0 0", 0}, Example{"M0", 2}, Example{"M0 0X", 4}, Example{"M0 0A1 1 0 2 0 1 1", 11},
          Example{"M0 0L1", 6}, Example{"M0 0é", 4}, Example{"M0 0A5 3 30 0 1 3 1", 4, ErrorCode::wrong_kind},
          Example{"M0 0A1 1 0 0 1 1 0", 4, ErrorCode::wrong_kind},
          Example{"M1e99999999 0", 1, ErrorCode::limit_exceeded}}) {
        CAPTURE(example.path);
        const auto error = failure([&] { curves(example.path); });
        REQUIRE(error);
        CAPTURE(error->message());
        CHECK(error->code() == example.code);
        CHECK(error->offset() == example.offset);
    }
}

TEST_CASE("a path that is written is read back") {
    const std::string exported = served_at(
        "/result/document", R"({"op": "export", "format": "svg", "map": {"kind": "bspline", "degree": 2,
            "knots": ["0", "0", "0", "1", "2", "2", "2"], "control_points": [["0", "0"], ["1", "2"], ["3", "2"], ["4", "0"]]}})");
    CHECK(exported == R"("M 0,0 Q 1,2 2,2 Q 3,2 4,0")");
    CHECK(served_at("/result/maps/1/control_points",
                    R"({"op": "import", "format": "svg", "document": )" + exported + "}") ==
          R"([["2", "2"], ["3", "2"], ["4", "0"]])");
    CHECK(refusal_text(
              R"("op": "export", "format": "svg", "map": {"kind": "polynomial", "text": ["t^4", "t"]})") ==
          "wrong_kind /map");
    CHECK(refusal_text(R"("op": "import", "format": "svg", "document": {})") == "wrong_kind /document");
}

TEST_CASE("the splines of FITPACK are read with their padding") {
    const auto imported = [](const std::string& document) {
        return served_at("/result/maps/0",
                         R"({"op": "import", "format": "fitpack", "document": )" + document + "}");
    };
    const std::string scalar = R"({"kind": "bspline", "degree": 1, "knots": ["0", "0", "1", "2", "2"], )"
                               R"("control_points": ["1", "2", "3"]})";
    for (const char* document : {"[[0, 0, 1, 2, 2], [1, 2, 3, 0, 0], 1]", "[[0, 0, 1, 2, 2], [1, 2, 3], 1]",
                                 R"({"t": [0, 0, 1, 2, 2], "c": [1, 2, 3, 0, 0], "k": 1})",
                                 R"t("(array([0., 0., 1., 2., 2.]), array([1., 2., 3., 0., 0.]), 1)")t",
                                 R"t("[array([0., 0., 1., 2., 2.]), array([1., 2., 3.]), 1]")t"}) {
        CAPTURE(document);
        CHECK(imported(document) == scalar);
    }
    const std::string plane = R"({"kind": "bspline", "degree": 1, "knots": ["0", "0", "1", "2", "2"], )"
                              R"("control_points": [["1", "4"], ["2", "5"], ["3", "6"]]})";
    for (const char* document :
         {"[[0, 0, 1, 2, 2], [[1, 2, 3, 0, 0], [4, 5, 6, 0, 0]], 1]",
          "[[0, 0, 1, 2, 2], [[1, 2, 3], [4, 5, 6]], 1]", "[[0, 0, 1, 2, 2], [[1, 4], [2, 5], [3, 6]], 1]",
          "[[0, 0, 1, 2, 2], [[1, 4], [2, 5], [3, 6], [0, 0], [0, 0]], 1]",
          R"t("(array([0., 0., 1., 2., 2.]), [array([1., 2., 3.]), array([4., 5., 6.])], 1)")t"}) {
        CAPTURE(document);
        CHECK(imported(document) == plane);
    }
    const auto refused = [](const std::string& document) {
        return refusal_text(R"("op": "import", "format": "fitpack", "document": )" + document);
    };
    CHECK(refused("[[0, 0, 1, 2, 2], [1, 2, 3, 4, 0], 1]") == "wrong_arity /document/1/3");
    CHECK(refused("[[0, 0, 1, 2, 2], [1, 2, 3, 0], 1]") == "wrong_arity /document/1");
    CHECK(refused("[[0, 0, 1, 2, 2], [1, 2, 3], 2]") == "wrong_arity /document/1");
    CHECK(refused("[[0, 2, 1, 2, 2], [1, 2, 3], 1]") == "bad_knots /document/0/2");
    CHECK(refused("[[0, 0], [1, 2, 3], 1]") == "bad_knots /document/0");
    CHECK(refused("[[0, 0], [1, 2, 3]]") == "wrong_arity /document");
    CHECK(refused(R"({"t": [0, 0, 1, 1], "c": [1, 2]})") == "missing_field /document/k");
    // As many points as coordinates: a list says nothing, an object has points.
    CHECK(refused("[[0, 0, 1, 1], [[1, 2], [3, 4]], 1]") == "wrong_arity /document/1");
    CHECK(imported(R"({"t": [0, 0, 1, 1], "c": [[1, 2], [3, 4]], "k": 1})")
              .find(R"([["1", "2"], ["3", "4"]])") != std::string::npos);
    CHECK(served_at("/result/document", R"({"op": "export", "format": "fitpack", "map": )" + scalar + "}") ==
          "[[0, 0, 1, 2, 2], [1, 2, 3], 1]");
    CHECK(served_at("/result/greatest_ulps", R"({"op": "audit", "format": "fitpack", "map": )" + scalar +
                                                 R"(, "document": [[0, 0, 1, 2, 2], [1, 2, 3, 0, 0], 1]})") ==
          R"("0")");
}
