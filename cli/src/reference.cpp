// Prints a page of the documentation with its generated parts up to date: they are made from the descriptions
// of operations, kinds of maps and options. A generated part stands between the lines <!-- generated: WHAT
// --> and <!-- end -->. For a file *.json it prints the JSON Schema.
//
// Usage: blossom_reference FILE

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>

#include <blossom/protocol/description.hpp>
#include "maps/kind.hpp"
#include "operations/map_options.hpp"
#include "protocol_names.hpp"
#include "responses.hpp"

namespace blossom::cli {

namespace {

constexpr std::string_view part_begin = "<!-- generated: ";
constexpr std::string_view comment_end = " -->";
constexpr std::string_view part_end = "<!-- end -->";

/// Escapes a text for a cell of a table.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return text;
}

std::string fields_table(std::string_view title, const Members& members, bool of_result) {
    const FieldList fields = all_fields(members);
    if (fields.empty()) return "";
    std::string text = of_result
                           ? fmt::format("| {} | kind | |\n| --- | --- | --- |\n", title)
                           : fmt::format("| {} | kind | required | |\n| --- | --- | --- | --- |\n", title);
    for (const Field& field : fields) {
        text += fmt::format("| `{}` | {} | ", field.name, cell(field.shape.text("`")));
        if (!of_result) text += presence_text(members, field.name) + " | ";
        text += cell(field.documentation) + " |\n";
    }
    return text;
}

std::string options_table(const std::vector<Option>& options) {
    std::string text = "| option | meaning |\n| --- | --- |\n";
    for (const Option& option : options) {
        text += fmt::format("| `{}{}{}` | {} |\n", option.name, option.value.empty() ? "" : " ",
                            cell(option.value), cell(option.help));
    }
    return text;
}

std::string operation_part(const Operation& operation) {
    return fields_table("field", operation.request, false) + "\n" +
           fields_table("member of the result", operation.result, true);
}

/// The options of a command besides those that describe a map.
std::string command_part(const Operation& operation) {
    const std::vector<Option> of_map = with_map_options({});
    std::vector<Option> own;
    std::ranges::copy_if(operation.options, std::back_inserter(own), [&](const Option& option) {
        const auto same = std::ranges::find(of_map, option.name, &Option::name);
        return same == of_map.end() || same->help != option.help;
    });
    return own.empty() ? "It has the options that describe a map.\n" : options_table(own);
}

std::string commands_table() {
    std::string text = "| command | what it does |\n| --- | --- |\n";
    for (const Operation& operation : operations())
        text += fmt::format("| [`{0}`](#{0}) | {1} |\n", operation.name, operation.summary);
    return text;
}

std::string generated(std::string_view what) {
    if (what == "commands") return commands_table();
    if (what == "options of a map") return options_table(with_map_options({}));
    if (what == "fields of a request") return fields_table("field", {.fields = common_fields()}, false);
    const std::size_t end = std::min(what.find(' '), what.size());
    const std::string_view name = what.substr(std::min(end + 1, what.size()));
    for (const Operation& operation : operations()) {
        if (operation.name != name) continue;
        if (what.starts_with("operation ")) return operation_part(operation);
        if (what.starts_with("command ")) return command_part(operation);
    }
    for (const Kind* kind : Kinds::all) {
        for (const KindWord& word : kind->words) {
            if (word.word.empty() || what != "map " + title_of(word, " with ")) continue;
            return std::string(word.documentation) + "\n\n" + fields_table("field", word.members(), false);
        }
    }
    throw std::invalid_argument("nothing is generated for \"" + std::string(what) + "\"");
}

/// Sections for the operations whose part is not on the page, before <!-- new operations: HEADING WHAT -->.
std::string missing_sections(std::string_view arguments, const std::set<std::string, std::less<>>& present) {
    const std::size_t space = arguments.find(' ');
    const std::string_view heading = arguments.substr(0, space);
    const std::string_view what = arguments.substr(space + 1);
    std::string text;
    for (const Operation& operation : operations()) {
        const std::string part = fmt::format("{} {}", what, operation.name);
        if (present.contains(part) || (what == "command" && operation.has_own_command)) continue;
        text +=
            fmt::format("{} {}\n\n{}. {}\n\n{}{}{}\n{}{}\n\n", heading, operation.name, operation.summary,
                        operation.documentation, part_begin, part, comment_end, generated(part), part_end);
    }
    return text;
}

std::string renewed(std::istream& page) {
    constexpr std::string_view new_operations = "<!-- new operations: ";
    std::set<std::string, std::less<>> present;
    std::string text;
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        const std::string_view view = line;
        if (view == part_end) inside = false;
        if (inside) continue;
        if (view.starts_with(new_operations)) {
            text += missing_sections(
                view.substr(new_operations.size(), view.size() - new_operations.size() - comment_end.size()),
                present);
        }
        text += line + "\n";
        if (!view.starts_with(part_begin)) continue;
        const std::string what(
            view.substr(part_begin.size(), view.size() - part_begin.size() - comment_end.size()));
        present.insert(what);
        text += generated(what);
        inside = true;
    }
    return text;
}

}  // namespace

}  // namespace blossom::cli

int main(int count, char** arguments) {
    const std::string name = count == 2 ? arguments[1] : "";
    std::ifstream page(name);
    if (!page) {
        std::cerr << "usage: blossom_reference FILE\n";
        return 2;
    }
    std::cout << (name.ends_with(".json") ? blossom::to_text(blossom::protocol::schema(), 2) + "\n"
                                          : blossom::cli::renewed(page));
    return 0;
}
