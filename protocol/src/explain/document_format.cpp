#include "document_format.hpp"

#include <blossom/rational/lists.hpp>
#include <blossom/worked/render.hpp>

#include <algorithm>
#include <array>

#include "operations/map_options.hpp"

namespace blossom::protocol {

namespace {

constexpr std::size_t default_width = 79;
/// A degree above which equal arguments are written once, with their multiplicity.
constexpr std::size_t widest_degree = 5;

constexpr std::string_view style_names[] = {"parentheses", "brackets", "multiplicative"};

worked::BlossomStyle read_style(const Json& value) {
    constexpr worked::BlossomStyle styles[] = {worked::BlossomStyle::parentheses,
                                               worked::BlossomStyle::brackets,
                                               worked::BlossomStyle::multiplicative};
    return styles[read_alternative(value, style_names, "a notation")];
}

using Documents = std::vector<worked::Document>;

/// The object of a document; of several documents a list.
std::string json_text(const Documents& documents, const worked::Notation& notation) {
    const std::string objects = joined(
        documents,
        [&](const worked::Document& document) {
            std::string object = render_json(document, notation);
            if (object.ends_with('\n')) object.pop_back();
            return object;
        },
        ",\n");
    return documents.size() == 1 ? objects + "\n" : "[" + objects + "]\n";
}

struct Format {
    std::string_view name;
    std::string (*write)(const Documents& documents, const worked::Notation& notation, std::size_t columns);
};

constexpr std::array<Format, 6> document_formats{
    {{"text",
      [](const Documents& documents, const worked::Notation& notation, std::size_t columns) {
          return joined(
              documents,
              [&](const worked::Document& document) { return render_text(document, notation, columns); },
              "\n");
      }},
     {"markdown",
      [](const Documents& documents, const worked::Notation& notation, std::size_t) {
          return joined(
              documents,
              [&](const worked::Document& document) { return render_markdown(document, notation); }, "\n");
      }},
     {"latex", [](const Documents& documents, const worked::Notation& notation,
                  std::size_t) { return render_latex(documents, notation); }},
     {"latex-fragment",
      [](const Documents& documents, const worked::Notation& notation, std::size_t) {
          return joined(
              documents,
              [&](const worked::Document& document) { return render_latex_fragment(document, notation); },
              "");
      }},
     {"html", [](const Documents& documents, const worked::Notation& notation,
                 std::size_t) { return render_html(documents, notation); }},
     {"json", [](const Documents& documents, const worked::Notation& notation, std::size_t) {
          return json_text(documents, notation);
      }}}};

std::vector<std::string_view> names_of_formats() { return mapped(document_formats, &Format::name); }

std::string read_format(const Json& value) {
    return std::string(document_formats[read_alternative(value, names_of_formats(), "a format")].name);
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

Json DocumentFormat::written(const std::vector<worked::Document>& documents) const {
    const bool wide = std::ranges::any_of(
        documents, [](const worked::Document& document) { return largest_degree(document) > widest_degree; });
    const worked::Notation notation{style_.value_or(documents.front().style), multiplicities_.value_or(wide)};
    const auto* format = std::ranges::find(document_formats, format_, &Format::name);
    return Json::Object{{"format", format_}, {"document", format->write(documents, notation, columns_)}};
}

FieldList document_fields() {
    return {
        optional("format", Shape::words(names_of_formats()), "the format of the document; by default text"),
        optional("notation", Shape::words(style_names),
                 "p(u,v,w), p[u,v,w] or uvw; by default parentheses, for statements brackets"),
        optional("multiplicities", ValueKind::boolean, "write equal arguments once, as t^<3>"),
        optional("columns", ValueKind::count, "the columns of a text; by default 79"),
    };
}

Members document_members() {
    return {{required("format", Shape::words(names_of_formats()), "the format of the document"),
             required("document", ValueKind::text, "the document")}};
}

std::vector<Option> document_options() {
    return completed(
        {word_option("--format", "format"), word_option("--notation", "notation"),
         flag_option("--multiplicities", "multiplicities"), field_option("--columns", "columns", "N", count)},
        {document_fields()});
}

std::string document_text(const Answered& answered) { return *answered.result().find("document")->text(); }

}  // namespace blossom::protocol
