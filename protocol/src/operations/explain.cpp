#include <algorithm>
#include <iterator>

#include "explain/chapter_of.hpp"
#include "explain/document_format.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

Answer answer_explain(Request& request, const Limits& limits) {
    const std::vector<worked::Document> documents =
        request.required("request", [&](const Json& explained) { return chapters_of(explained, limits); });
    const DocumentFormat format = DocumentFormat::read(request, limits);
    request.finish();
    return format.written(documents);
}

}  // namespace

Operation explain_operation() {
    FieldList fields{
        required("request", Shape::request_of(chapter_names()), "the request that is worked out")};
    std::ranges::move(document_fields(), std::back_inserter(fields));
    return {
        .summary = "Work out a computation step by step, as text, Markdown, LaTeX, HTML or JSON",
        .documentation = "A page has every step, with formulas, pyramids, tables and pictures.",
        .request = {std::move(fields)},
        .result = document_members(),
        .example = {"explain", "evaluate", "t^2", "--at", "3"},
        .options = {},
        .answer = answer_explain,
        .render = document_text,
        .has_own_command = true,
    };
}

}  // namespace blossom::protocol
