#include <blossom/worked/formula.hpp>

#include <algorithm>
#include <cctype>
#include <utility>

namespace blossom::worked {

namespace {

Formula node(FormulaKind kind, std::vector<Formula> parts, std::string name = "", Rational value = 0) {
    return {kind, std::move(value), std::move(name), std::move(parts)};
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace

Formula number(Rational value) { return node(FormulaKind::number, {}, "", std::move(value)); }

Formula symbol(std::string name) {
    const auto digits = std::ranges::find_if(name, is_digit);
    const bool indexed = digits == name.begin() + 1 && digits != name.end() &&
                         std::all_of(digits, name.end(), is_digit) && name.size() < 10;
    if (!indexed) return node(FormulaKind::symbol, {}, std::move(name));
    const std::size_t subscript = std::stoul(name.substr(1));
    return index(symbol(name.substr(0, 1)), number(subscript));
}

Formula sum(std::vector<Formula> parts) {
    if (parts.empty()) return number(0);
    return parts.size() == 1 ? std::move(parts.front()) : node(FormulaKind::sum, std::move(parts));
}

Formula product(std::vector<Formula> parts) {
    if (parts.empty()) return number(1);
    return parts.size() == 1 ? std::move(parts.front()) : node(FormulaKind::product, std::move(parts));
}

Formula power(Formula base, Formula exponent) {
    if (exponent == number(1)) return base;
    return node(FormulaKind::power, {std::move(base), std::move(exponent)});
}

Formula application(Formula head, std::vector<Formula> arguments) {
    arguments.insert(arguments.begin(), std::move(head));
    return node(FormulaKind::application, std::move(arguments));
}

Formula list_of(std::vector<Formula> parts, std::string separator) {
    if (parts.size() == 1) return std::move(parts.front());
    return node(FormulaKind::list, std::move(parts), std::move(separator));
}

Formula summation(Formula below, Formula of) {
    return node(FormulaKind::summation, {std::move(below), std::move(of)});
}

Formula summation(std::string sign, Formula below, std::optional<Formula> above, Formula of) {
    Formula result = node(FormulaKind::summation, {std::move(below), std::move(of)}, std::move(sign));
    if (above) result.parts.push_back(std::move(*above));
    return result;
}

Formula equation(std::vector<Formula> sides) { return relation("=", std::move(sides)); }

Formula relation(std::string sign, std::vector<Formula> sides) {
    if (sides.size() == 1) return std::move(sides.front());
    return node(FormulaKind::relation, std::move(sides), std::move(sign));
}

bool is_negative(const Formula& formula) {
    switch (formula.kind) {
        case FormulaKind::number:
            return formula.value.sign() < 0;
        case FormulaKind::product:
        case FormulaKind::fraction:
            return is_negative(formula.parts.front());
        default:
            return false;
    }
}

Formula without_sign(Formula formula) {
    if (!is_negative(formula)) return formula;
    if (formula.kind == FormulaKind::number) return number(-formula.value);
    // -1 t is written as -t.
    if (formula.kind == FormulaKind::product && formula.parts.front() == number(-1)) {
        formula.parts.erase(formula.parts.begin());
        return product(std::move(formula.parts));
    }
    formula.parts.front() = without_sign(std::move(formula.parts.front()));
    return formula;
}

}  // namespace blossom::worked
