#include "foreign_options.hpp"

#include "formats/formats.hpp"
#include "given_answers.hpp"
#include "json/json_text.hpp"
#include "map_options.hpp"

namespace blossom::protocol {

Field format_field() {
    return required("format", Shape::words(format_names()), "the library whose file format is used");
}

Field document_field() {
    return required("document", ValueKind::document,
                    "what this library wrote, as JSON, or the text of a mesh or path");
}

Option format_option() { return word_option("--format", "format"); }

Option document_option(std::string help) {
    const auto apply = [](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        const std::string& text = values.front();
        const Json* format = request.find("format");
        const bool is_text = format && may_be_text(*format) && !trimmed(text).starts_with('{');
        request["document"] = is_text ? Json(text) : document_in(parse_json(text, limits));
    };
    return {"--document", {"document"}, "JSON", std::move(help), apply};
}

}  // namespace blossom::protocol
