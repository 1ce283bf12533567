#include <blossom/rational/lists.hpp>
#include <blossom/worked/gallery.hpp>

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/worked/chapters.hpp>
#include <blossom/worked/proof_chapter.hpp>
#include <blossom/worked/render.hpp>
#include <blossom/worked/triangle_chapters.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include "writers/html_page.hpp"

namespace blossom::worked {

namespace {

GivenMap cubic() { return {PolynomialCurve(parse_univariate("1 + 2t + 4t^2 - t^3").polynomial)}; }

BezierCurve plane_cubic() {
    const std::vector<Coordinates> points{{0, 0}, {1, 3}, {4, 3}, {5, 0}};
    return BezierCurve(points);
}

/// Hart's knots, for a plane cubic of three segments.
BSplineCurve plane_spline() {
    return BSplineCurve(3, {0, 1, 2, 3, 4, 5, 6, 7}, {{0, 0}, {1, 3}, {4, 4}, {7, 3}, {8, 0}, {5, -1}});
}

std::vector<Argument> points(std::initializer_list<int> parameters) {
    return mapped(parameters, [&](const int parameter) { return Argument(Parameter(parameter)); });
}

/// The unit circle as (1 - t^2, 2t) / (1 + t^2).
GivenMap circle() {
    const std::vector<Polynomial> coordinates{parse_univariate("1 - t^2").polynomial,
                                              parse_univariate("2t").polynomial,
                                              parse_univariate("1 + t^2").polynomial};
    return {PolynomialCurve(coordinates)};
}

/// A quadratic patch in the plane.
GivenTriangle plane_triangle() {
    const std::vector<Coordinates> net{{0, 0}, {3, -1}, {1, 3}, {6, 0}, {5, 4}, {2, 6}};
    return {BezierPatch(NetShape::simplex(2, 2), net), {}, {}, false};
}

/// A quadratic patch in space over a triangle of the plane.
GivenTriangle space_triangle() {
    const std::vector<Coordinates> net{{0, 0, 0}, {2, 0, 3}, {0, 2, 2}, {4, 0, 1}, {2, 2, 4}, {0, 4, 0}};
    return {BezierPatch(NetShape::simplex(2, 2), net), BarycentricFrame({{0, 0}, {4, 0}, {0, 4}}), {}, false};
}

std::string index_page(const std::vector<GalleryPage>& pages) {
    HtmlPage page("Worked examples of blossoming");
    append_words(page.main(), "h1", "Worked examples of blossoming");
    append_words(
        page.main(), "p",
        "Every number on these pages is computed exactly. Each page can be made for any other input, and "
        "each is also available as LaTeX, Markdown and JSON.");
    pugi::xml_node list = page.main().append_child("ol");
    for (const GalleryPage& entry : pages) {
        pugi::xml_node item = list.append_child("li");
        append_words(item, "a", entry.document.title).append_attribute("href") =
            (entry.name + ".html").c_str();
        item.append_child(pugi::node_pcdata).set_value(": ");
        for (const auto& [ending, words] :
             {std::pair(".tex", "LaTeX"), std::pair(".md", "Markdown"), std::pair(".json", "JSON")}) {
            append_words(item, "a", words).append_attribute("href") = (entry.name + ending).c_str();
            item.append_child(pugi::node_pcdata).set_value(" ");
        }
    }
    return page.text();
}

std::vector<Link> links_of(const std::vector<GalleryPage>& pages, std::size_t i) {
    std::vector<Link> links{{"index.html", "All worked examples"}};
    if (i > 0) links.push_back({pages[i - 1].name + ".html", "← " + pages[i - 1].document.title});
    if (i + 1 < pages.size())
        links.push_back({pages[i + 1].name + ".html", pages[i + 1].document.title + " →"});
    return links;
}

}  // namespace

std::vector<GalleryPage> gallery_pages() {
    const Rational half(1, 2);
    const std::array<Rational, 1> knot{Rational(7, 2)};
    const std::vector<Coordinates> kinked{{0, 0}, {1, 3}, {3, 3}, {4, 1}, {6, 3}, {7, 0}};
    std::vector<GalleryPage> pages;
    const auto add = [&](std::string name, Document document) {
        pages.push_back({std::move(name), std::move(document)});
    };
    add("three-ways", three_ways(cubic(), points({1, 2, 3})));
    add("evaluation", evaluation_at({plane_cubic()}, half));
    add("homogenisation", homogenisation(cubic()));
    add("first-derivative", derivative_by_delta({plane_cubic()}, 1, half));
    add("second-derivative", derivative_by_delta(cubic(), 2, half));
    add("control-points", control_points_over(cubic(), Interval()));
    add("subdivision", subdivision_at({plane_cubic()}, half));
    add("degree-raising", degree_raised({plane_cubic()}, 1));
    add("coefficients-to-control-points", coefficients_to_control_points(cubic()));
    add("control-points-to-coefficients", control_points_to_coefficients({plane_cubic()}));
    add("spline-to-bezier", spline_to_bezier(plane_spline()));
    add("de-boor", de_boor_at(plane_spline(), Rational(7, 2)));
    add("knot-insertion", knots_inserted(plane_spline(), knot));
    add("continuity", continuity_at(BSplineCurve(3, {0, 0, 0, 1, 1, 2, 2, 2}, kinked), 1));
    add("rational-arc", rational_arc(circle(), half));
    const Coordinates inside{half, Rational(1, 4), Rational(1, 4)};
    add("triangle-evaluation", triangle_evaluation(space_triangle(), inside));
    add("triangle-subdivision", triangle_subdivision(plane_triangle(), inside));
    add("proof", claims_decided("theorem fj-eq20 \"the blossom from points of the curve alone\"\n"
                                "map b degree 2\n"
                                "claim b[s, t] == (4*b((s + t)/2) - b(s) - b(t))/2\n")
                     .front());
    add("refutation", claims_decided("theorem goldman-thm9 \"a derivative needs the vector delta\"\n"
                                     "map a degree 2\n"
                                     "claim a'(t) == 2*a[t, 1]\n")
                          .front());
    return pages;
}

std::vector<SiteFile> gallery_files() {
    const std::vector<GalleryPage> pages = gallery_pages();
    std::vector<SiteFile> files{{"index.html", index_page(pages)}};
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const auto& [name, document] = pages[i];
        const Notation notation{document.style};
        const std::string picture = "pictures/" + name;
        files.push_back({name + ".html", render_html({&document, 1}, notation, links_of(pages, i))});
        files.push_back({name + ".tex", render_latex({&document, 1}, notation)});
        files.push_back({name + ".md", render_markdown(document, notation, picture)});
        files.push_back({name + ".json", render_json(document, notation)});
        const std::vector<std::string> pictures = render_pictures(document, notation);
        for (std::size_t k = 0; k < pictures.size(); ++k) {
            files.push_back({picture + "-" + std::to_string(k + 1) + ".svg", pictures[k]});
        }
    }
    return files;
}

}  // namespace blossom::worked
