#include "run_command.hpp"

#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/resource_budget.hpp>
#include <blossom/rational/utf8.hpp>

#include <algorithm>

#include "floats.hpp"
#include "limit_flags.hpp"
#include "operations/map_options.hpp"
#include "proof_task.hpp"
#include "responses.hpp"

namespace blossom::cli {

namespace {

constexpr std::size_t line_width = 76;

/// The line of `text` around `offset`, cut to what fits, and a caret below the place.
std::string with_caret(std::string_view text, std::size_t offset, const Style& style) {
    offset = std::min(offset, text.size());
    const std::size_t line_start = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
    std::size_t first = offset - line_start > line_width / 2 ? offset - line_width / 2 : line_start;
    while (first < offset && continues_character(text[first])) ++first;
    std::size_t last = std::min({text.find('\n', offset), text.size(), first + line_width});
    while (last < text.size() && last > offset && continues_character(text[last])) --last;
    std::string line(text.substr(first, last - first));
    std::ranges::replace(line, '\x1b', '?');  // not even a colour is taken from what was typed
    return fmt::format("  {}\n  {}{}\n", line,
                       std::string(count_characters(text.substr(first, offset - first)), ' '),
                       style.bad("^"));
}

/// Whether an option writes the field at `place` or a field that contains it.
bool writes(const Option& option, const Place& place) {
    if (place.begins_with(option.field)) return true;
    if (!option.of_map) return false;
    const std::vector<Place::Step>& steps = option.field.steps();
    Place outer;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) outer = outer.around({steps[i]});
    return place.begins_with((outer / blossom::Part::map).around({steps.back()}));
}

bool has_option(const Command& command, std::string_view name) {
    return std::ranges::any_of(command.options,
                               [&](const GivenOption& given) { return given.option->name == name; });
}

/// The most specific of the given options that write the field at `place`; if none was given,
/// the first option that could write it, or "".
std::string writer_of(const Place& place, const Command& command) {
    for (const char* name : {"numbers", "floats"}) {  // options of every command
        if (place.begins_with(Place{name})) return std::string("--") + name;
    }
    const Option* writer = nullptr;
    for (const GivenOption& given : command.options) {
        const Option& option = *given.option;
        if (!writes(option, place)) continue;
        if (!writer || option.field.steps().size() >= writer->field.steps().size()) writer = &option;
    }
    if (writer) return writer->name;
    for (const Option& option : command.operation.options) {
        if (!place.begins_with(option.field)) continue;
        if (!writer || option.field.steps().size() > writer->field.steps().size()) writer = &option;
    }
    return writer ? writer->name : "";
}

/// The value of an option: "-" stands for standard input and "@NAME" for a file, without the last line end.
std::string resolved(const std::string& value, const Streams& streams, const Limits& limits) {
    const bool from_file = value.starts_with('@');
    if (!from_file && value != "-") return value;
    std::string text = read_all(from_file ? file_source(value.substr(1)) : streams.input, limits.line_bytes);
    while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
    return text;
}

struct Refusal {
    Error error;
    Json request;
};

/// Writes the error as a response in JSON, or as a message.
Outcome report(const Refusal& refusal, const Command& command, const Streams& streams) {
    if (command.as_json) {
        streams.output(to_text(error_response(Json(), refusal.error, add_flag)) + "\n");
    } else {
        streams.errors(
            readable_error(refusal.error, refusal.request, command, Style(streams.coloured_errors)));
    }
    return Outcome::refused;
}

/// Writes one option into the request. If the text of a whole map in JSON is wrong, the error has this text
/// as its request.
void apply(const GivenOption& given, const Command& command, const Streams& streams, Json& request) {
    std::vector<std::string> values;
    values.reserve(given.values.size());
    for (const std::string& value : given.values) {
        if (!given.option->files) {
            values.push_back(resolved(value, streams, command.limits));
            continue;
        }
        for (const std::string& file : statement_files(value))
            values.push_back(resolved(file == "-" ? file : "@" + file, streams, command.limits));
    }
    try {
        given.option->apply(request, values, command.limits);
    } catch (const Error& error) {
        throw Refusal{error, values.empty() ? Json() : Json(values.front())};
    }
}

/// Makes JSON numbers of the decimals in a request, which were typed as options.
void make_floats(Json& value, const Command& command) {
    if (const std::string* text = value.text()) {
        const std::string_view unsigned_text = std::string_view(*text).substr(text->starts_with('-') ? 1 : 0);
        const bool is_float = !unsigned_text.starts_with("0x") &&
                              text->find_first_of(".eE") != std::string::npos &&
                              unsigned_number_length(unsigned_text) == unsigned_text.size();
        if (is_float) value = Json(Json::Number{*text});
    }
    if (Json::Array* elements = value.array()) {
        for (Json& element : *elements) make_floats(element, command);
    }
    Json::Object* members = value.object();
    if (!members) return;
    for (auto& [name, member] : *members) {
        constexpr std::string_view texts[] = {"text",     "denominator", "statement",
                                              "document", "computed",    "maps"};
        const bool stays = std::ranges::find(texts, name) != std::end(texts) ||
                           (name == "map" && has_option(command, "--map"));
        if (!stays) make_floats(member, command);
    }
}

Json begun_request(const Operation& operation) {
    Json request = Json::Object{{"op", operation.name}};
    return operation.explains ? Json::Object{{"op", "explain"}, {"request", std::move(request)}} : request;
}

Outcome answer_and_print(const Command& command, const Json& request, const Streams& streams) {
    try {
        const ResourceBudget budget(command.limits);
        const Answer answer = find_answer(request, command.limits);
        const Answered answered{request, answer, command.limits, Style(streams.coloured_output)};
        if (!command.picture.empty()) write_file(command.picture, command.operation.plot(answered));
        if (!command.mesh.empty()) write_file(command.mesh, command.operation.mesh(answered));
        streams.output(command.as_json ? to_text(success_response(Json(), answer.result)) + "\n"
                                       : command.operation.render(answered));
        return outcome_of(answer.result);
    } catch (const Error& error) {
        return report({error, request}, command, streams);
    }
}

}  // namespace

std::string readable_error(const Error& error, const Json& request, const Command& command,
                           const Style& style) {
    std::string message = fmt::format("{} {}\n", style.bad("error:"), with_flag(error).message());
    const Json* place = at_place(request, error.place());
    const std::string* text = place ? place->text() : nullptr;
    if (text && error.offset()) return message + with_caret(*text, *error.offset(), style);
    if (error.place().empty()) return message;
    const std::string value = place ? to_text(*place) : "";
    const bool shown = !value.empty() && value.size() <= line_width;
    const std::string option = writer_of(error.place(), command);
    return message + fmt::format("  at {}{}{}{}{}\n", option, option.empty() ? "" : ", ",
                                 pointer_of(error.place()), shown ? ": " : "", shown ? value : "");
}

Outcome run_command(const Command& command, const Streams& streams) {
    Json request = begun_request(command.operation);
    try {
        for (const GivenOption& given : command.options) apply(given, command, streams, request);
        if (!command.numbers.empty()) request["numbers"] = command.numbers;
        if (!command.floats.empty()) {
            request["floats"] = command.floats;
            if (command.floats == floats_names().back()) make_floats(request, command);
        }
        return answer_and_print(command, request, streams);
    } catch (const Refusal& refusal) {
        return report(refusal, command, streams);
    } catch (const Error& error) {
        return report({error, request}, command, streams);
    } catch (const UsageError&) {
        throw;
    } catch (const std::system_error&) {
        throw;
    } catch (const std::exception& problem) {
        return report({unexpected(problem), request}, command, streams);
    }
}

}  // namespace blossom::cli
