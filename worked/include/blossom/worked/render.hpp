#pragma once

#include <blossom/worked/document.hpp>
#include <blossom/worked/notation.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::worked {

/// Text for a terminal: pyramids are printed in columns if they fit into `width`, otherwise level by level.
/// Pictures are lists of points.
std::string render_text(const Document& document, const Notation& notation = {}, std::size_t width = 79);

/// Markdown with formulas in LaTeX between dollar signs; pyramids are drawn as text. Picture number k,
/// counted from 1, is the image PICTURES-k.svg, which `render_pictures` makes; without a path the points of a
/// picture stand in a table in its place.
std::string render_markdown(const Document& document, const Notation& notation = {},
                            const std::string& pictures = "");

/// The pictures of a document in their order, each as an SVG file of its own.
std::vector<std::string> render_pictures(const Document& document, const Notation& notation = {});

/// LaTeX: a complete document of several examples, or a fragment for \input into another document after
/// the preamble of `latex_preamble`.
std::string render_latex(std::span<const Document> documents, const Notation& notation = {});
std::string render_latex_fragment(const Document& document, const Notation& notation = {});
std::string latex_preamble();

/// A link from a page to another.
struct Link {
    std::string target;
    std::string text;
};

/// A self-contained file of HTML with one or more examples: formulas in MathML, pyramids and pictures
/// in SVG, no script.
std::string render_html(std::span<const Document> documents, const Notation& notation = {},
                        const std::vector<Link>& links = {});

/// The document as data: every formula as a tree, every number exact.
std::string render_json(const Document& document, const Notation& notation = {});

/// One picture as an SVG file of its own.
std::string render_svg(const Picture& picture, const Notation& notation = {});

}  // namespace blossom::worked
