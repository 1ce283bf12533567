#include "explain/document_format.hpp"

#include <blossom/rational/number_text.hpp>
#include <blossom/worked/render.hpp>

#include <algorithm>
#include <array>

#include "operations/map_options.hpp"

namespace blossom::cli {

namespace {

constexpr std::size_t default_width = 79;
/// A degree above which equal arguments are written once, with their multiplicity.
constexpr std::size_t widest_degree = 5;

worked::BlossomStyle read_style(const Json& value) {
    const std::string& name = read_text(value);
    if (name == "parentheses") return worked::BlossomStyle::parentheses;
    if (name == "brackets") return worked::BlossomStyle::brackets;
    if (name == "multiplicative") return worked::BlossomStyle::multiplicative;
    throw Error(ErrorCode::wrong_kind,
                "the notation is parentheses, brackets or multiplicative, not " + quoted(name));
}

struct Format {
    std::string_view name;
    std::string (*write)(const worked::Document& document, const worked::Notation& notation,
                         std::size_t columns);
};

constexpr std::array<Format, 6> formats{
    {{"text", [](const worked::Document& document, const worked::Notation& notation,
                 std::size_t columns) { return render_text(document, notation, columns); }},
     {"markdown", [](const worked::Document& document, const worked::Notation& notation,
                     std::size_t) { return render_markdown(document, notation); }},
     {"latex", [](const worked::Document& document, const worked::Notation& notation,
                  std::size_t) { return render_latex(document, notation); }},
     {"latex-fragment", [](const worked::Document& document, const worked::Notation& notation,
                           std::size_t) { return render_latex_fragment(document, notation); }},
     {"html", [](const worked::Document& document, const worked::Notation& notation,
                 std::size_t) { return render_html(document, notation); }},
     {"json", [](const worked::Document& document, const worked::Notation& notation, std::size_t) {
          return render_json(document, notation);
      }}}};

std::string read_format(const Json& value) {
    const std::string& name = read_text(value);
    if (std::ranges::find(formats, name, &Format::name) != formats.end()) return name;
    throw Error(ErrorCode::wrong_kind,
                "the format is text, markdown, latex, latex-fragment, html or json, not " + quoted(name));
}

}  // namespace

DocumentFormat DocumentFormat::read(Fields& request, const Limits& limits) {
    DocumentFormat format;
    format.format_ = request.optional("format", read_format).value_or("text");
    format.style_ = request.optional("notation", read_style);
    format.multiplicities_ = request.optional("multiplicities", read_boolean);
    format.columns_ =
        request.optional("columns", [&](const Json& value) { return read_count(value, limits); })
            .value_or(default_width);
    return format;
}

Json DocumentFormat::written(const worked::Document& document) const {
    const worked::Notation notation{style_.value_or(document.style),
                                    multiplicities_.value_or(largest_degree(document) > widest_degree)};
    const auto* format = std::ranges::find(formats, format_, &Format::name);
    return Json::Object{{"format", format_}, {"document", format->write(document, notation, columns_)}};
}

std::vector<Option> document_options() {
    return {
        field_option("--format", "format", "text|markdown|latex|latex-fragment|html|json",
                     "how the document is written; by default text", plain_text),
        field_option("--notation", "notation", "parentheses|brackets|multiplicative",
                     "p(u,v,w), p[u,v,w] or uvw; by default parentheses, of statements brackets", plain_text),
        flag_option("--multiplicities", "multiplicities", "write equal arguments once, as t^<3>"),
        field_option("--columns", "columns", "N", "the columns of a text; by default 79", count),
    };
}

std::string document_text(const Answered& answered) { return *answered.result.find("document")->text(); }

}  // namespace blossom::cli
