#include "explain/explain_options.hpp"

#include <algorithm>

#include "explain/chapter_of.hpp"
#include "explain/document_format.hpp"
#include "operations/table.hpp"
#include "prove_statement.hpp"

namespace blossom::cli {

namespace {

Option inside_request(const Option& option) {
    const auto apply = [option](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        option.apply(request["request"], values, limits);
    };
    return {option.name, "/request" + option.field, option.value, option.help, apply, option.repeated};
}

/// The statement of a request grows with each option.
void put_in_front(Json& request, const std::string& text) {
    const Json* rest = request.find("statement");
    request["statement"] = text + (rest ? *rest->text() : "");
}

/// `prove` has a command of its own, whose options take texts as these do.
std::vector<Option> statement_options() {
    return {{"-e,--statement", "/statement", "TEXT", "the statement, \"claim\" may be left out",
             [](Json& request, const std::vector<std::string>& values, const Limits&) {
                 put_in_front(request, statement_text(values.front()));
             }},
            {"--degree", "/statement", "NAME=N", "declares a map: b=2; may be repeated",
             [](Json& request, const std::vector<std::string>& values, const Limits&) {
                 put_in_front(request, map_lines(values));
             },
             true}};
}

Operation explained(const Operation& operation) {
    const Operation explain = explain_operation();
    Operation command{.name = operation.name,
                      .summary = operation.summary,
                      .example = {},
                      .options = {},
                      .answer = explain.answer,
                      .render = explain.render,
                      .explains = true};
    const bool proves = operation.name == prove_operation().name;
    for (const Option& option : proves ? statement_options() : operation.options) {
        command.options.push_back(inside_request(option));
    }
    std::ranges::move(document_options(), std::back_inserter(command.options));
    return command;
}

}  // namespace

const std::vector<Operation>& explained_operations() {
    static const std::vector<Operation> table = [] {
        std::vector<Operation> commands;
        for (const Operation& operation : operations()) {
            if (has_chapter(operation.name)) commands.push_back(explained(operation));
        }
        return commands;
    }();
    return table;
}

}  // namespace blossom::cli
