#include "decisions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blossom::cli {

namespace {

Json integer(long long value) { return Json::Number{std::to_string(value)}; }

bool is_tensor(const proofs::WitnessMap& map) { return map.directions.size() > 1; }

std::string degrees_text(const proofs::WitnessMap& map) {
    std::string text;
    for (const auto& [degree, dimension] : map.directions)
        text += (text.empty() ? "" : ", ") + std::to_string(degree);
    return (is_tensor(map) ? "degrees " : "degree ") + text;
}

/// The names that the text of the map uses, in order.
std::vector<std::string> variables_of(const proofs::WitnessMap& map) {
    std::size_t count = 0;
    for (const auto& [degree, dimension] : map.directions) count += dimension;
    if (count == 1) return {"t"};
    if (count == 2 && is_tensor(map)) return {"u", "v"};
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= count; ++i) names.push_back("x" + std::to_string(i));
    return names;
}

/// As a map of the protocol.
Json to_json(const proofs::WitnessMap& map) {
    Json result = Json::Object{{"kind", "polynomial"}, {"text", map.text}};
    const std::vector<std::string> variables = variables_of(map);
    if (variables.size() > 1) {
        Json::Array names;
        for (const std::string& name : variables) names.emplace_back(name);
        result["variables"] = std::move(names);
    }
    if (!is_tensor(map)) {
        result["degree"] = Json(map.directions.front().degree);
        return result;
    }
    Json::Array degrees;
    for (const auto& [degree, dimension] : map.directions) degrees.emplace_back(degree);
    result["degrees"] = std::move(degrees);
    return result;
}

Json to_json(const proofs::Counterexample& counterexample) {
    Json::Object parameters;
    for (const auto& [name, value] : counterexample.parameters) parameters.emplace_back(name, integer(value));
    Json::Object maps;
    for (const proofs::WitnessMap& map : counterexample.maps) maps.emplace_back(map.name, to_json(map));
    Json::Object variables;
    for (const auto& [name, value] : counterexample.variables) variables.emplace_back(name, value);
    Json::Array values;
    for (const proofs::WitnessValue& value : counterexample.values) values.emplace_back(value.text);
    return Json::Object{{"parameters", std::move(parameters)}, {"maps", std::move(maps)},
                        {"variables", std::move(variables)},   {"left", counterexample.left},
                        {"right", counterexample.right},       {"values", std::move(values)}};
}

}  // namespace

Json to_json(const proofs::Decision& decision) {
    Json::Array conditions;
    for (const std::string& condition : decision.conditions) conditions.emplace_back(condition);
    Json result = Json::Object{{"verdict", proofs::verdict_name(decision.verdict)},
                               {"as_expected", decision.as_expected()},
                               {"cases", decision.cases},
                               {"terms", decision.terms},
                               {"conditions", std::move(conditions)}};
    if (decision.counterexample) result["counterexample"] = to_json(*decision.counterexample);
    if (decision.error) result["error"] = decision.error->message();
    return result;
}

std::string readable(const proofs::Counterexample& counterexample) {
    std::vector<std::string> parts;
    for (const auto& [name, value] : counterexample.parameters)
        parts.push_back(fmt::format("{} = {}", name, value));
    for (const proofs::WitnessMap& map : counterexample.maps) {
        std::string variables;
        for (const std::string& name : variables_of(map)) variables += (variables.empty() ? "" : ", ") + name;
        parts.push_back(fmt::format("{}({}) = {} ({})", map.name, variables, map.text, degrees_text(map)));
    }
    for (const auto& [name, value] : counterexample.variables)
        parts.push_back(fmt::format("{} = {}", name, to_string(value)));
    std::string text =
        fmt::format("    {}\n    left side {}, right side {}\n",
                    parts.empty() ? "without any choice" : fmt::format("{}", fmt::join(parts, ", ")),
                    to_string(counterexample.left), to_string(counterexample.right));
    constexpr std::size_t most_values = 6;
    std::size_t shown = 0;
    std::size_t width = 0;
    for (const proofs::WitnessValue& value : counterexample.values)
        width = std::max(width, value.text.size());
    for (const proofs::WitnessValue& value : counterexample.values) {
        if (shown++ == most_values) {
            text += fmt::format("    ... and {} more values\n", counterexample.values.size() - most_values);
            break;
        }
        text += value.command.empty() ? fmt::format("    {}\n", value.text)
                                      : fmt::format("    {:<{}}  $ {}\n", value.text, width, value.command);
    }
    return text;
}

}  // namespace blossom::cli
