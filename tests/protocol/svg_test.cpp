#include "pictures/svg_document.hpp"

#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "answered.hpp"
#include "pictures/frame.hpp"
#include "responses.hpp"
#include "support/catch.hpp"

using namespace blossom;
using namespace blossom::protocol;

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

TEST_CASE("text in a picture is escaped, and what XML does not have is replaced") {
    CHECK(xml_escaped("a < b & \"c\" > 'd'") == "a &lt; b &amp; &quot;c&quot; &gt; 'd'");
    CHECK(xml_escaped(std::string("\0\x01\t\n\x1f", 5)) == "??\t\n?");
    CHECK(xml_escaped("größer") == "größer");
    SvgDocument document(10, 20, "<title>");
    document.add("text", {{"x", "\"1\""}}, "<&>");
    document.add("rect", {});
    CHECK(document.text() ==
          "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10\" height=\"20\" viewBox=\"0 0 10 20\" "
          "font-family=\"sans-serif\" font-size=\"12\">\n<title>&lt;title&gt;</title>\n"
          "<text x=\"&quot;1&quot;\">&lt;&amp;&gt;</text>\n<rect/>\n</svg>\n");
}

TEST_CASE("the frame of a picture holds all of it, with ticks at round numbers") {
    Picture shown{"", {}, {{{0, 0}, ""}, {{Rational(7), Rational(1) / 3}, ""}}, false};
    const Frame frame(shown);
    CHECK(frame.x(0) == "48.00");
    CHECK(frame.x(7) == "592.00");
    CHECK(frame.y(Rational(1) / 3) == "48.00");
    CHECK(frame.ticks_of_x() == std::vector<Rational>{0, 1, 2, 3, 4, 5, 6, 7});
    const Rational step = Rational(1) / 20;
    CHECK(frame.ticks_of_y() ==
          std::vector<Rational>{0, step, 2 * step, 3 * step, 4 * step, 5 * step, 6 * step});
    shown.points = {{{5, 5}, ""}};
    CHECK(Frame(shown).x(5) == "320.00");
    shown.equal_scales = true;
    shown.points = {{{0, 0}, ""}, {{1, Rational(1) / 1000}, ""}};
    CHECK(Frame(shown).height() == 296);
    shown.points = {{{-3, -3}, ""}, {{-1, -1}, ""}};
    CHECK(Frame(shown).ticks_of_x().front() < Rational(-2));
}

TEST_CASE("subdivision is painted with what was before and both parts") {
    const std::string text = picture(
        R"({"op": "subdivide", "map": {"kind": "bezier", "control_points": [[0, 0], [1, 2], [3, 0]]}, "at": "1/3"})");
    CHECK(text.starts_with("<svg "));
    CHECK(text.ends_with("</svg>\n"));
    for (const std::string label : {">before<", ">part 1<", ">part 2<", ">t = 1/3<"})
        CHECK(occurrences(text, label) >= 1);
    // A polygon and a curve each.
    CHECK(occurrences(text, "<polyline") == 6);
    CHECK(occurrences(text, "<circle") == 9);
}

TEST_CASE("a scalar spline is painted as its graph, a jump as a gap, a pole as a gap") {
    const std::string jump = picture(
        R"({"op": "evaluate", "map": {"kind": "bspline", "degree": 1, "knots": [0, 0, 1, 1, 2, 2],
            "control_points": [0, 1, 2, 3]}, "at": ["1/2"]})");
    CHECK(occurrences(jump, "<polyline") == 3);
    CHECK(occurrences(jump, ">P(1/2)<") == 1);
    const std::string pole = picture(
        R"({"op": "evaluate", "map": {"kind": "polynomial", "text": "1", "denominator": "2t - 1"}, "at": ["1"]})");
    CHECK(occurrences(pole, "<polyline") == 2);
}

TEST_CASE("every kind of curve has a picture") {
    for (
        const std::string map :
        {R"({"kind": "polynomial", "text": ["t", "t^2", "t^3"]})",
         R"({"kind": "taylor", "center": 1, "coefficients": [1]})",
         R"({"kind": "progressive", "knots": [0, 1], "control_points": [[0, 1], [1, 1]]})",
         R"({"kind": "bezier", "control_points": [[1, 0, 1], [0, 1, 0], [0, 0, 1]], "homogeneous": true})"}) {
        CAPTURE(map);
        CHECK(occurrences(picture(R"({"op": "elevate", "by": 2, "map": )" + map + "}"), "<polyline") >= 2);
        CHECK(occurrences(picture(R"({"op": "evaluate", "at": [0, 1], "map": )" + map + "}"), "<circle") >=
              2);
    }
}
