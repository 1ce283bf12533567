#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/worked/chapters.hpp>
#include <blossom/worked/gallery.hpp>
#include <blossom/worked/json.hpp>
#include <blossom/worked/render.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"

using namespace blossom;
using namespace blossom::worked;

namespace {

Document small_page() {
    return evaluation_at({PolynomialCurve(parse_univariate("1 + t^2").polynomial)}, Rational(1, 2));
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

/// The number of characters of the longest line.
std::size_t widest_line(std::string_view text) {
    std::size_t widest = 0;
    std::size_t width = 0;
    for (const char c : text) {
        if (c == '\n') {
            width = 0;
        } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
            widest = std::max(widest, ++width);
        }
    }
    return widest;
}

}  // namespace

TEST_CASE("a text fits its width, and pyramids are set in columns if there is room") {
    for (const GalleryPage& page : gallery_pages()) {
        // Tables and single formulas cannot be broken; none of these is wider than 79 columns.
        CAPTURE(page.name);
        CHECK(widest_line(render_text(page.document)) <= 79);
    }
    const std::string wide = render_text(small_page(), {}, 79);
    const std::string narrow = render_text(small_page(), {}, 30);
    CHECK(has(wide, "  p(0, 0) = 1\n              ╲ 1/2\n"));
    CHECK_FALSE(has(wide, "level 1"));
    CHECK(has(narrow, "  level 1\n    p(0, 1/2) = 1/2 p(0, 0)"));
    CHECK_FALSE(has(narrow, "╲"));
    CHECK(widest_line(narrow) <= 30);
}

TEST_CASE("each notation writes blossom values alike in every rendering") {
    const Document page = small_page();
    for (const auto& [style, text, latex] :
         {std::tuple(BlossomStyle::parentheses, "p(0, 1/2)", "p(0, \\tfrac{1}{2})"),
          std::tuple(BlossomStyle::brackets, "p[0, 1/2]", "p[0, \\tfrac{1}{2}]"),
          std::tuple(BlossomStyle::multiplicative, "(0)(1/2)", "(\\tfrac{1}{2})")}) {
        const Notation notation{style, false};
        CAPTURE(text);
        CHECK(has(render_text(page, notation), text));
        CHECK(has(render_html({&page, 1}, notation), text));
        CHECK(has(render_latex({&page, 1}, notation), latex));
        CHECK(has(render_markdown(page, notation), latex));
        CHECK(has(render_json(page, notation), text));
    }
    const Notation counted{BlossomStyle::parentheses, true};
    CHECK(has(render_text(page, counted), "p(0^<2>) = 1"));
    CHECK(has(render_latex({&page, 1}, counted), "{0}^{\\langle 2\\rangle}"));
}

TEST_CASE("LaTeX is a whole document, or a fragment of it") {
    const Document page = small_page();
    const std::string whole = render_latex({&page, 1});
    const std::string fragment = render_latex_fragment(page);
    CHECK(whole.starts_with("\\documentclass"));
    CHECK(has(whole, latex_preamble()));
    CHECK(has(whole, "\\begin{document}\n" + fragment + "\\end{document}"));
    CHECK_FALSE(has(fragment, "\\usepackage"));
    CHECK(count(fragment, "\\begin{tikzpicture}") == 2);
    // Every node and every label is there.
    CHECK(count(fragment, "\\node[blossom node") == 6);
    CHECK(count(fragment, "\\node[blossom label") == 6);
}

TEST_CASE("Markdown has tables, formulas and pictures as files or as their points") {
    const Document page = small_page();
    const std::string alone = render_markdown(page);
    CHECK(alone.starts_with("# Evaluation by de Casteljau's algorithm\n\n"));
    CHECK(has(alone, "$$P(t) = 1 + {t}^{2}$$"));
    CHECK(has(alone, "```text\n  p(0, 0) = 1"));
    CHECK_FALSE(has(alone, "!["));
    CHECK(has(alone, "| point | place |\n| --- | --- |\n| $p(0, 0)$ | $(0, 1)$ |\n"));
    const std::string with_files = render_markdown(page, {}, "pictures/page");
    CHECK(count(with_files, "![") == 1);
    CHECK(has(with_files, "](pictures/page-1.svg)"));
    CHECK(render_pictures(page).size() == 1);
    CHECK(render_pictures(page).front().starts_with("<svg "));
}

TEST_CASE("an HTML page is one file that names its language, headings and pictures") {
    const Document document = small_page();
    const std::string page = render_html({&document, 1});
    CHECK(page.starts_with("<!DOCTYPE html><html lang=\"en\">"));
    CHECK(count(page, "<h1>") == 1);
    CHECK(count(page, "<h2>") == 4);
    CHECK(count(page, "role=\"img\"") == 2);
    CHECK(count(page, "<title id=") == 2);
    CHECK(has(page, "@media print"));
    CHECK(has(page, "prefers-color-scheme:dark"));
    for (const std::string_view foreign : {"<script", "<link", "http:", "https:", "src="}) {
        CAPTURE(foreign);
        CHECK(count(page, foreign) ==
              count(page, "http://www.w3.org/2000/svg") * (foreign == "http:" ? 1 : 0));
    }
}

TEST_CASE("what is written is escaped in every rendering") {
    Document page;
    page.title = "a < b & c_d";
    CHECK(has(render_html({&page, 1}), "<h1>a &lt; b &amp; c_d</h1>"));
    CHECK(has(render_latex({&page, 1}), "a \\textless{} b \\& c\\_d"));
    CHECK(has(render_markdown(page), "a \\< b & c\\_d"));
}

TEST_CASE("a long number is rounded to four digits") {
    CHECK(short_text(Rational(-1, 3)) == "-1/3");
    CHECK(short_text(Rational(100000, 300001)) == "≈ 0.3333");
    CHECK(short_text(Rational(-1234567891)) == "≈ -1.235e9");
    CHECK(short_text(Rational(99999, 10000001)) == "≈ 0.01");
    CHECK(short_text(Rational(999960001, 1000000)) == "≈ 1000");
    CHECK(short_text(Rational(1, 1234567890)) == "≈ 8.1e-10");
    CHECK(short_text(Rational(1234567, 1000)) == "≈ 1235");
    CHECK(short_text(Rational(1000000001), 11) == "1000000001");
    CHECK(short_text(Rational(123400000000)) == "1.234e11");
}

TEST_CASE("JSON is written on one line, or with one line per element and member") {
    const Json value =
        Json::Object{{"a", Json::Array{Rational(1, 2), true}}, {"b", Json::Object()}, {"c", Json()}};
    CHECK(to_text(value) == R"({"a": ["1/2", true], "b": {}, "c": null})");
    CHECK(to_text(value, 1) == "{\n \"a\": [\n  \"1/2\",\n  true\n ],\n \"b\": {},\n \"c\": null\n}");
}
