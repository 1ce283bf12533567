#include "explain_options.hpp"

#include <algorithm>

#include "explain/chapter_of.hpp"
#include "explain/document_format.hpp"
#include "operations/table.hpp"
#include "proof_task.hpp"

namespace blossom::cli {

namespace {

Option inside_request(const Option& option) {
    const auto apply = [option](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        option.apply(request["request"], values, limits);
    };
    return {option.name,  Place{"request"}.around(option.field),
            option.value, option.help,
            apply,        option.repeated,
            option.files, option.of_map};
}

/// The field "statement" of a request as a list.
Json::Array statements_of(const Json& request) {
    const Json* statements = request.find("statement");
    return statements ? *statements->array() : Json::Array();
}

/// The options of `explain prove`, in the order in which they are applied. They have the syntax of the
/// options of `prove`.
std::vector<Option> statement_options() {
    return {{"-e,--statement",
             {"statement"},
             "TEXT",
             "a statement, with or without \"claim\"; may be repeated",
             [](Json& request, const std::vector<std::string>& values, const Limits&) {
                 Json::Array statements;
                 for (const std::string& value : values) statements.emplace_back(statement_text(value));
                 request["statement"] = std::move(statements);
             },
             true},
            {"--degree",
             {"statement"},
             "NAME=N",
             "declares a map for -e: b=2; may be repeated",
             [](Json& request, const std::vector<std::string>& values, const Limits&) {
                 Json::Array statements = statements_of(request);
                 for (Json& statement : statements) statement = map_lines(values) + *statement.text();
                 request["statement"] = std::move(statements);
             },
             true},
            {"FILE",
             {"statement"},
             "FILE",
             "files of statements, or folders with files *.blossom",
             [](Json& request, const std::vector<std::string>& values, const Limits&) {
                 Json::Array statements(values.begin(), values.end());
                 std::ranges::move(statements_of(request), std::back_inserter(statements));
                 request["statement"] = std::move(statements);
             },
             true,
             true}};
}

}  // namespace

Operation explained(const Operation& operation) {
    const Operation& explain = *operation_of(explain_name);
    Operation command{.name = operation.name,
                      .summary = operation.summary,
                      .documentation = explain.documentation,
                      .request = {},
                      .result = {},
                      .example = {},
                      .options = {},
                      .answer = explain.answer,
                      .render = explain.render,
                      .explains = true};
    const bool proves = operation.name == prove_name;
    for (const Option& option : proves ? statement_options() : operation.options) {
        command.options.push_back(inside_request(option));
    }
    std::ranges::move(document_options(), std::back_inserter(command.options));
    return command;
}

}  // namespace blossom::cli
