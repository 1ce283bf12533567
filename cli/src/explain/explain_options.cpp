#include "explain/explain_options.hpp"

#include <algorithm>

#include "explain/chapter_of.hpp"
#include "explain/document_format.hpp"
#include "operations/table.hpp"

namespace blossom::cli {

namespace {

Option inside_request(const Option& option) {
    const auto apply = [option](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        option.apply(request["request"], values, limits);
    };
    return {option.name, "/request" + option.field, option.value, option.help, apply};
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
    for (const Option& option : operation.options) {
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
