#include "decisions.hpp"

#include <fmt/format.h>
#include <blossom/proofs/case_groups.hpp>
#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/witness_maps.hpp>

#include <algorithm>

namespace blossom::protocol {

namespace {

Json integer(long long value) { return Json::Number{std::to_string(value)}; }

Json texts(const std::vector<std::string>& list) {
    Json::Array result;
    for (const std::string& text : list) result.emplace_back(text);
    return result;
}

Json to_json(const proofs::Parameters& parameters) {
    Json::Object result;
    for (const auto& [name, value] : parameters) result.emplace_back(name, integer(value));
    return result;
}

/// As a map of the protocol.
Json to_json(const proofs::WitnessMap& map) {
    Json result = Json::Object{{"kind", "polynomial"}, {"text", map.text}};
    const std::vector<std::string> variables = proofs::variables_of(map);
    if (variables.size() > 1) {
        Json::Array names;
        for (const std::string& name : variables) names.emplace_back(name);
        result["variables"] = std::move(names);
    }
    if (!proofs::is_tensor(map)) {
        result["degree"] = Json(map.directions.front().degree);
        return result;
    }
    Json::Array degrees;
    for (const auto& [degree, dimension] : map.directions) degrees.emplace_back(degree);
    result["degrees"] = std::move(degrees);
    return result;
}

Json to_json(const proofs::Counterexample& counterexample) {
    Json::Object maps;
    for (const proofs::WitnessMap& map : counterexample.maps) maps.emplace_back(map.name, to_json(map));
    Json::Object variables;
    for (const auto& [name, value] : counterexample.variables) variables.emplace_back(name, value);
    Json::Array values;
    for (const proofs::WitnessValue& value : counterexample.values) values.emplace_back(value.text);
    Json result = Json::Object{{"parameters", to_json(counterexample.parameters)},
                               {"maps", std::move(maps)},
                               {"variables", std::move(variables)},
                               {"left", counterexample.left},
                               {"right", counterexample.right},
                               {"values", std::move(values)}};
    if (!counterexample.roots.empty()) result["roots"] = texts(counterexample.roots);
    return result;
}

Json conditions_json(const std::vector<proofs::Condition>& conditions) {
    Json::Array list;
    for (const proofs::Condition& condition : conditions) list.emplace_back(condition.text);
    return list;
}

Json to_json(const proofs::CaseDecision& decided) {
    Json result = Json::Object{{"parameters", to_json(decided.parameters)},
                               {"verdict", proofs::verdict_name(decided.verdict)},
                               {"terms", decided.terms},
                               {"conditions", conditions_json(decided.conditions)}};
    if (!decided.open.empty()) result["open"] = texts(decided.open);
    if (!decided.holds_if.empty()) result["holds_if"] = texts(decided.holds_if);
    if (decided.counterexample) result["counterexample"] = to_json(*decided.counterexample);
    if (decided.error) result["error"] = decided.error->message();
    return result;
}

Json ranges_json(const proofs::Block& block, const proofs::Statement& line) {
    Json::Array ranges;
    for (const proofs::Range& range : proofs::ranges_of(block, line)) {
        ranges.emplace_back(Json::Object{{"name", range.name},
                                         {"first", proofs::to_text(range.first)},
                                         {"last", proofs::to_text(range.last)}});
    }
    return ranges;
}

}  // namespace

Json to_json(const proofs::Block& block, const proofs::Decision& decision) {
    const proofs::Statement& line = block.statements[decision.statement];
    Json::Array cases;
    for (const proofs::CaseDecision& decided : decision.cases) cases.emplace_back(to_json(decided));
    Json result = Json::Object{{"verdict", proofs::verdict_name(decision.verdict())},
                               {"as_expected", decision.as_expected()},
                               {"cases", decision.cases.size()},
                               {"terms", decision.terms()},
                               {"conditions", conditions_json(decision.conditions())},
                               {"title", block.title},
                               {"statement", proofs::to_text(line)},
                               {"ranges", ranges_json(block, line)},
                               {"by_case", std::move(cases)}};
    if (const auto* found = decision.counterexample()) result["counterexample"] = to_json(*found);
    if (const Error* error = decision.error()) result["error"] = error->message();
    return result;
}

}  // namespace blossom::protocol
