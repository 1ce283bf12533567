#include "formula_json.hpp"

#include <string_view>

namespace blossom::worked {

namespace {

std::string_view kind_name(FormulaKind kind) {
    switch (kind) {
        case FormulaKind::number:
            return "number";
        case FormulaKind::symbol:
            return "symbol";
        case FormulaKind::words:
            return "words";
        case FormulaKind::sum:
            return "sum";
        case FormulaKind::product:
            return "product";
        case FormulaKind::fraction:
            return "fraction";
        case FormulaKind::power:
            return "power";
        case FormulaKind::index:
            return "index";
        case FormulaKind::call:
            return "call";
        case FormulaKind::application:
            return "application";
        case FormulaKind::derivative:
            return "derivative";
        case FormulaKind::blossom:
            return "blossom";
        case FormulaKind::elementary:
            return "elementary";
        case FormulaKind::binomial:
            return "binomial";
        case FormulaKind::factorial:
            return "factorial";
        case FormulaKind::tuple:
            return "tuple";
        case FormulaKind::list:
            return "list";
        case FormulaKind::repeated:
            return "repeated";
        case FormulaKind::pair:
            return "pair";
        case FormulaKind::size:
            return "size";
        case FormulaKind::cases:
            return "cases";
        case FormulaKind::set:
            return "set";
        case FormulaKind::interval:
            return "interval";
        case FormulaKind::summation:
            return "summation";
        case FormulaKind::relation:
            return "relation";
    }
    return "";
}

bool has_value(FormulaKind kind) {
    return kind == FormulaKind::number || kind == FormulaKind::derivative || kind == FormulaKind::elementary;
}

}  // namespace

nlohmann::ordered_json to_json(const Formula& formula) {
    nlohmann::ordered_json json{{"kind", kind_name(formula.kind)}};
    if (has_value(formula.kind)) json["value"] = to_string(formula.value);
    if (formula.kind == FormulaKind::blossom && formula.value.sign() > 0) {
        json["span"] = *(formula.value.numerator() - Integer(1)).to_int64();
    }
    if (!formula.name.empty()) json["name"] = formula.name;
    if (!formula.parts.empty()) json["parts"] = nlohmann::ordered_json::array();
    for (const Formula& part : formula.parts) json["parts"].push_back(to_json(part));
    return json;
}

}  // namespace blossom::worked
