#include <blossom/rational/number_text.hpp>
#include <blossom/worked/render.hpp>

#include <string>
#include <string_view>

#include "explain/chapter_of.hpp"
#include "explain/explain_options.hpp"
#include "operations/map_options.hpp"
#include "operations/table.hpp"

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

std::string rendered(const worked::Document& document, const std::string& format,
                     const worked::Notation& notation, std::size_t width) {
    if (format == "text") return render_text(document, notation, width);
    if (format == "markdown") return render_markdown(document, notation);
    if (format == "latex") return render_latex(document, notation);
    if (format == "latex-fragment") return render_latex_fragment(document, notation);
    if (format == "html") return render_html(document, notation);
    if (format == "json") return render_json(document, notation);
    throw Error(ErrorCode::wrong_kind,
                "the format is text, markdown, latex, latex-fragment, html or json, not " + quoted(format),
                "/format");
}

Json answer(Fields& request, const Limits& limits) {
    const worked::Document document =
        request.required("request", [&](const Json& explained) { return chapter_of(explained, limits); });
    const std::string format =
        request.optional("format", [](const Json& value) { return read_text(value); }).value_or("text");
    const auto style = request.optional("notation", read_style);
    const auto multiplicities = request.optional("multiplicities", read_boolean);
    const auto width =
        request.optional("columns", [&](const Json& value) { return read_count(value, limits); });
    request.finish();
    const worked::Notation notation{style.value_or(worked::BlossomStyle::parentheses),
                                    multiplicities.value_or(largest_degree(document) > widest_degree)};
    return Json::Object{{"format", format},
                        {"document", rendered(document, format, notation, width.value_or(default_width))}};
}

std::string render(const Answered& answered) { return *answered.result.find("document")->text(); }

}  // namespace

Operation explain_operation() {
    return {
        .name = "explain",
        .summary = "Any computation worked out step by step, as text, Markdown, LaTeX, HTML or JSON",
        .example = {"explain", "evaluate", "t^2", "--at", "3"},
        .options = {},
        .answer = answer,
        .render = render,
        .has_own_command = true,
    };
}

}  // namespace blossom::cli
