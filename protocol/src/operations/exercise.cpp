#include <blossom/rational/lists.hpp>
#include <blossom/worked/exercise.hpp>

#include <algorithm>

#include "explain/document_format.hpp"
#include "map_options.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

std::uint64_t read_seed(const Json& value, const Limits& limits) {
    const Rational number = read_number(value, limits);
    const auto seed = number.is_integer() ? number.numerator().to_int64() : std::nullopt;
    if (seed && *seed >= 0) return static_cast<std::uint64_t>(*seed);
    throw Error(ErrorCode::wrong_kind, to_string(number) + " is not a seed, an integer from 0 to 2^63 - 1");
}

std::string read_topic(const Json& value) {
    std::string name = read_text(value);
    worked::require_topic(name);
    return name;
}

void apply_topics(Json& request, const std::vector<std::string>& values, const Limits&) {
    request["topic"] = values.size() == 1
                           ? Json(values.front())
                           : Json(mapped(values, [](const std::string& name) { return Json(name); }));
}

Answer answer_exercise(Request& request, const Limits& limits) {
    worked::SheetRequest sheet;
    const auto number = [&](std::string_view name, std::size_t otherwise) {
        return request.optional(name, [&](const Json& value) { return read_count(value, limits); })
            .value_or(otherwise);
    };
    sheet.topics = request.required("topic", [](const Json& value) {
        return value.array() ? read_list(value, read_topic) : std::vector{read_topic(value)};
    });
    sheet.seed =
        request.optional("seed", [&](const Json& value) { return read_seed(value, limits); }).value_or(1);
    sheet.count = number("count", std::max<std::size_t>(5, sheet.topics.size()));
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
        {"TOPIC", {"topic"}, joined(worked::exercise_topics(), {}, "|"), "", apply_topics},
        field_option("--seed", "seed", "N", count),
        field_option("--count", "count", "N", count),
        field_option("--level", "level", "1|2|3", count),
        flag_option("--solutions", "solutions"),
    };
    std::ranges::move(document_options(), std::back_inserter(options));
    const Shape topic = Shape::words(worked::exercise_topics());
    FieldList fields{
        required("topic", Shape::one_of({topic, Shape::list(topic)}),
                 "the topic of the problems, or several, which the problems are on in turn"),
        optional("seed", ValueKind::count, "the number of the sheet; by default 1"),
        optional("count", ValueKind::count,
                 "the number of problems; by default 5, or one per topic, and at most 40"),
        optional("level", ValueKind::count, "the difficulty, from 1 to 3; by default 1"),
        optional("solutions", ValueKind::boolean, "give the worked solutions instead of the problems"),
    };
    std::ranges::move(document_fields(), std::back_inserter(fields));
    return {
        .summary = "Print a sheet of problems, or its worked solutions; the same seed gives the same sheet",
        .documentation = "The numbers are small enough to compute by hand.",
        .request = {std::move(fields)},
        .result = document_members(),
        .example = {"exercise", "subdivision", "--count", "2"},
        .options = std::move(options),
        .answer = answer_exercise,
        .render = document_text,
    };
}

}  // namespace blossom::protocol
