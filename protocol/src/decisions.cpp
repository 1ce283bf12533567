#include "decisions.hpp"

#include <fmt/format.h>
#include <blossom/proofs/case_groups.hpp>
#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/witness_maps.hpp>

#include <algorithm>

#include "certificates/proof_certificate.hpp"

namespace blossom::protocol {

namespace {

Json texts(const std::vector<std::string>& list) {
    Json::Array result;
    for (const std::string& text : list) result.emplace_back(text);
    return result;
}

/// As a map of the protocol.
Json witness_json(const proofs::WitnessMap& map) {
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

Json counterexample_json(const proofs::Counterexample& counterexample) {
    Json::Object maps;
    for (const proofs::WitnessMap& map : counterexample.maps) maps.emplace_back(map.name, witness_json(map));
    Json::Object variables;
    for (const auto& [name, value] : counterexample.variables) variables.emplace_back(name, value);
    Json::Array values;
    for (const proofs::WitnessValue& value : counterexample.values) values.emplace_back(value.text);
    Json result = Json::Object{{"parameters", parameters_json(counterexample.parameters)},
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

Json case_json(const proofs::CaseDecision& decided) {
    Json result = Json::Object{{"parameters", parameters_json(decided.parameters)},
                               {"verdict", proofs::verdict_name(decided.verdict)},
                               {"terms", decided.terms},
                               {"conditions", conditions_json(decided.conditions)}};
    if (!decided.open.empty()) result["open"] = texts(decided.open);
    if (!decided.holds_if.empty()) result["holds_if"] = texts(decided.holds_if);
    if (decided.counterexample) result["counterexample"] = counterexample_json(*decided.counterexample);
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

Shape texts_shape(std::size_t least = 0) { return Shape::list(ValueKind::text, least); }

Field parameters_member() {
    return required("parameters", Shape::names(ValueKind::integer), "the integer parameters");
}

/// As maps of the protocol, with the text of a polynomial.
Shape witness_shape() {
    return Shape::object({{required("kind", Shape::words({"polynomial"}), "the kind of map"),
                           required("text", ValueKind::text, "the polynomial"),
                           optional("variables", texts_shape(), "its variables")},
                          {{{optional("degree", ValueKind::count, "the formal degree")},
                            {optional("degrees", Shape::list(ValueKind::count), "the formal degrees")}}}});
}

Field counterexample_member(std::string documentation) {
    return optional(
        "counterexample",
        Shape::object(
            {{parameters_member(), required("maps", Shape::names(witness_shape()), "the maps"),
              required("variables", Shape::names(ValueKind::number), "the variables with a rational value"),
              required("left", ValueKind::text, "the left side: a number, or an expression in roots"),
              required("right", ValueKind::text, "the right side"),
              required("values", texts_shape(), "values of the maps"),
              optional("roots", texts_shape(1), "equations of variables without a rational value")}}),
        std::move(documentation));
}

Shape case_shape() {
    return Shape::object(
        {{parameters_member(),
          required("verdict", Shape::words({"proved", "refuted", "undecided", "disagreement"}),
                   "what became of this case"),
          required("terms", ValueKind::count, "the number of terms in its normal form"),
          required("conditions", texts_shape(), "what must not vanish"),
          optional("open", texts_shape(1), "what a pivot excluded and could not be decided"),
          optional("holds_if", texts_shape(1), "where a refuted case is proved"),
          counterexample_member("where the sides differ"),
          optional("error", ValueKind::text, "why the case is undecided")}});
}

Shape range_shape() {
    return Shape::object({{required("name", ValueKind::text, "the parameter"),
                           required("first", ValueKind::text, "its first value, as written"),
                           required("last", ValueKind::text, "its last value")}});
}

/// Of one line.
FieldList line_members() {
    return {
        required(
            "verdict", Shape::words({"proved", "refuted"}),
            "proved: in every case, for all maps and all values of the variables; refuted: in at least one"),
        required("as_expected", ValueKind::boolean,
                 "whether a `claim` is proved in every case, a `refute` refuted in every case, or a "
                 "`refute some` refuted in at least one"),
        required("cases", ValueKind::count,
                 "the number of choices of the integer parameters that were decided"),
        required("terms", ValueKind::count, "the number of terms in the normal forms of all cases"),
        required("conditions", texts_shape(),
                 "the conditions of all cases under which the statement is defined and proved, such as \"a "
                 "!= b\""),
        required("title", ValueKind::text, "the title of the theorem"),
        required("statement", ValueKind::text, "the line in canonical form"),
        required("ranges", Shape::list(range_shape()),
                 "the integer parameters of the block and of the line, as written"),
        required(
            "by_case", Shape::list(case_shape(), 1),
            "for each case its `parameters`, `verdict`, `terms` and `conditions`, and `open`, `holds_if`, "
            "`counterexample` and `error` where they apply"),
        counterexample_member("the counterexample of the first case that has one"),
        optional("error", ValueKind::text, "the error of the first case that has one"),
    };
}

}  // namespace

Members decision_members() {
    FieldList fields = line_members();
    fields.push_back(optional("lines", Shape::list(Shape::object({line_members()})),
                              "if there are several lines `claim` or `refute`: the answers to all of them. "
                              "The other members are then "
                              "those of the first refuted line or, if none is refuted, of the first line"));
    return {std::move(fields)};
}

Json to_json(const proofs::Block& block, const proofs::Decision& decision) {
    const proofs::Statement& line = block.statements[decision.statement];
    Json::Array cases;
    for (const proofs::CaseDecision& decided : decision.cases) cases.emplace_back(case_json(decided));
    Json result = Json::Object{{"verdict", proofs::verdict_name(decision.verdict())},
                               {"as_expected", decision.as_expected()},
                               {"cases", decision.cases.size()},
                               {"terms", decision.terms()},
                               {"conditions", conditions_json(decision.conditions())},
                               {"title", block.title},
                               {"statement", proofs::to_text(line)},
                               {"ranges", ranges_json(block, line)},
                               {"by_case", std::move(cases)}};
    if (const auto* found = decision.counterexample()) result["counterexample"] = counterexample_json(*found);
    if (const Error* error = decision.error()) result["error"] = error->message();
    return result;
}

}  // namespace blossom::protocol
