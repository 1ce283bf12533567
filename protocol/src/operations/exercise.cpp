#include <blossom/worked/exercise.hpp>

#include <algorithm>

#include "explain/document_format.hpp"
#include "map_options.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

std::string topics_text() {
    std::string text;
    for (const std::string_view topic : worked::exercise_topics())
        text += (text.empty() ? "" : "|") + std::string(topic);
    return text;
}

Answer answer(Request& request, const Limits& limits) {
    worked::SheetRequest sheet;
    const auto number = [&](std::string_view name, std::size_t otherwise) {
        return request.optional(name, [&](const Json& value) { return read_count(value, limits); })
            .value_or(otherwise);
    };
    sheet.topic = request.required("topic", [](const Json& value) { return read_text(value); });
    sheet.seed = number("seed", 1);
    sheet.count = number("count", 5);
    sheet.level = number("level", 1);
    const bool solutions = request.optional("solutions", read_boolean).value_or(false);
    const DocumentFormat format = DocumentFormat::read(request, limits);
    request.finish();
    const worked::Sheet made = exercise_sheet(sheet);
    return format.written({solutions ? made.solutions : made.problems});
}

}  // namespace

Operation exercise_operation() {
    std::vector<Option> options{
        field_option("TOPIC", "topic", topics_text(), "the topic of the problems", plain_text),
        field_option("--seed", "seed", "N", "the number of the sheet; by default 1", count),
        field_option("--count", "count", "N", "the number of problems; by default 5", count),
        field_option("--level", "level", "1|2|3", "the difficulty; by default 1", count),
        flag_option("--solutions", "solutions", "print the worked solutions instead of the problems"),
    };
    std::ranges::move(document_options(), std::back_inserter(options));
    return {
        .name = "exercise",
        .summary = "Print a sheet of problems, or its worked solutions; the same seed gives the same sheet",
        .example = {"exercise", "subdivision", "--count", "2"},
        .options = std::move(options),
        .answer = answer,
        .render = document_text,
    };
}

}  // namespace blossom::protocol
