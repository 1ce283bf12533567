#include "answered.hpp"
#include "responses.hpp"

namespace {

std::string picture(const std::string& text) {
    const Json request = parse_json(text, Limits{});
    const Answer answer = find_answer(request, Limits{});
    const auto plot = find_operation(*request.find("op")->text()).plot;
    REQUIRE(plot);
    return plot({request, answer, Limits{}, Style()});
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_CASE("subdivision is painted with what was before and both parts") {
    const std::string text = picture(
        R"({"op": "subdivide", "map": {"kind": "bezier", "control_points": [[0, 0], [1, 2], [3, 0]]}, "at": "1/3"})");
    CHECK(text.starts_with("<svg "));
    CHECK(text.ends_with("</svg>\n"));
    for (const std::string label : {">before<", ">part 1<", ">part 2<", ">t = 1/3<"})
        CHECK(occurrences(text, label) >= 1);
    // A polygon and a curve each.
    CHECK(occurrences(text, "class=\"line ") == 3);
    // And the piece of a curve in the legend.
    CHECK(occurrences(text, "class=\"curve ") == 3 + 3);
    // Nine control points at six places, the ends of both parts among them.
    CHECK(occurrences(text, "<circle") == 6);
}

TEST_CASE("a scalar spline is painted as its graph, a jump as a gap, a pole as a gap") {
    const std::string jump = picture(
        R"({"op": "evaluate", "map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 1, 2, 2],
            "control_points": [0, 1, 2, 3]}, "at": ["1/2"]})");
    CHECK(occurrences(jump, "class=\"line ") == 1);
    CHECK(occurrences(jump, "class=\"curve ") == 2);
    CHECK(occurrences(jump, ">P(1/2)<") == 1);
    const std::string pole = picture(
        R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "1", "denominator": "2t - 1"}, "at": ["1"]})");
    CHECK(occurrences(pole, "class=\"curve ") == 2);
}

TEST_CASE("every kind of curve has a picture") {
    for (
        const std::string map :
        {R"({"kind": "polynomial", "text": ["t", "t^2", "t^3"]})",
         R"({"kind": "taylor", "center": 1, "coefficients": [1]})",
         R"({"kind": "progressive", "knots": [0, 1], "control_points": [[0, 1], [1, 1]]})",
         R"({"kind": "bezier", "control_points": [[1, 0, 1], [0, 1, 0], [0, 0, 1]], "homogeneous": true})"}) {
        CAPTURE(map);
        CHECK(occurrences(picture(R"({"op": "elevate", "by": 2, "map": )" + map + "}"), "class=\"curve ") >=
              2);
        CHECK(occurrences(picture(R"({"op": "evaluate", "at": [0, 1], "map": )" + map + "}"), "<circle") >=
              2);
    }
}
