#pragma once

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace blossom::worked {

/// The kind of the root of a formula.
enum class FormulaKind {
    number,       ///< `value`
    symbol,       ///< `name`, a letter or a word; "delta" and other Greek letters are drawn as such
    words,        ///< `name`, upright words within a formula
    sum,          ///< parts added; a negative part is subtracted
    product,      ///< parts multiplied
    fraction,     ///< parts[0] / parts[1]
    power,        ///< parts[0] ^ parts[1]
    index,        ///< parts[0] with subscript parts[1]
    call,         ///< the map `name` at parts
    application,  ///< parts[0], which is more than a name, at the other parts
    derivative,   ///< the derivative of order `value` of the map `name` at parts[0]
    blossom,      ///< the blossom `name` at parts, as many as its degree; of a spline that of a segment whose
                  ///< span has the index `value` - 1, or for 0 of any, where all agree
    elementary,   ///< the elementary symmetric function of order `value` of parts
    binomial,     ///< parts[0] over parts[1]
    factorial,    ///< parts[0]!
    tuple,        ///< (parts)
    list,         ///< parts with `name`, "," or ";", between them
    repeated,     ///< the argument parts[0], parts[1] times
    pair,         ///< <parts[0], parts[1]>
    size,         ///< |parts[0]|
    cases,        ///< parts[0] if parts[1] holds, otherwise parts[2]
    set,          ///< {parts}
    interval,     ///< [parts[0], parts[1]]
    summation,    ///< the sum, or as `name` says the product, over parts[0] of parts[1]; to parts[2] if there
                  ///< is one
    relation,     ///< parts connected by `name`, for instance "="
};

/// A formula as a tree of its meaning. Text, LaTeX and MathML are printed from it, and a test evaluates it
/// again: a relation between sides without free symbols is a claim about numbers.
struct Formula {
    FormulaKind kind = FormulaKind::number;
    Rational value;
    std::string name;
    std::vector<Formula> parts;

    friend bool operator==(const Formula&, const Formula&) = default;
};

Formula number(Rational value);
/// "t", "delta"; a letter followed by digits, "u12", is the letter with an index.
Formula symbol(std::string name);
inline Formula words(std::string text) { return {FormulaKind::words, 0, std::move(text), {}}; }
/// The sum of the parts: a single part unchanged, 0 if there are none.
Formula sum(std::vector<Formula> parts);
/// The product of the parts: a single part unchanged, 1 if there are none.
Formula product(std::vector<Formula> parts);
inline Formula fraction(Formula numerator, Formula denominator) {
    return {FormulaKind::fraction, 0, "", {std::move(numerator), std::move(denominator)}};
}
/// An exponent 1 is left out.
Formula power(Formula base, Formula exponent);
inline Formula index(Formula base, Formula subscript) {
    return {FormulaKind::index, 0, "", {std::move(base), std::move(subscript)}};
}
inline Formula call(std::string map, std::vector<Formula> arguments) {
    return {FormulaKind::call, 0, std::move(map), std::move(arguments)};
}
inline Formula derivative_of(std::string map, std::size_t order, Formula at) {
    return {FormulaKind::derivative, order, std::move(map), {std::move(at)}};
}
inline Formula blossom_of(std::string name, std::vector<Formula> arguments) {
    return {FormulaKind::blossom, 0, std::move(name), std::move(arguments)};
}
inline Formula elementary(std::size_t order, std::vector<Formula> arguments) {
    return {FormulaKind::elementary, order, "e", std::move(arguments)};
}
inline Formula binomial_of(Formula n, Formula k) {
    return {FormulaKind::binomial, 0, "", {std::move(n), std::move(k)}};
}
inline Formula factorial_of(Formula n) { return {FormulaKind::factorial, 0, "", {std::move(n)}}; }
Formula application(Formula head, std::vector<Formula> arguments);
inline Formula tuple(std::vector<Formula> parts) { return {FormulaKind::tuple, 0, "", std::move(parts)}; }
/// A single part is returned unchanged.
Formula list_of(std::vector<Formula> parts, std::string separator = ",");
inline Formula repeated(Formula argument, Formula times) {
    return {FormulaKind::repeated, 0, "", {std::move(argument), std::move(times)}};
}
inline Formula pair_of(Formula first, Formula second) {
    return {FormulaKind::pair, 0, "", {std::move(first), std::move(second)}};
}
inline Formula size_of(Formula set) { return {FormulaKind::size, 0, "", {std::move(set)}}; }
inline Formula cases_of(Formula value, Formula condition, Formula otherwise) {
    return {FormulaKind::cases, 0, "", {std::move(value), std::move(condition), std::move(otherwise)}};
}
inline Formula set_of(std::vector<Formula> parts) { return {FormulaKind::set, 0, "", std::move(parts)}; }
inline Formula interval_of(Formula begin, Formula end) {
    return {FormulaKind::interval, 0, "", {std::move(begin), std::move(end)}};
}
Formula summation(Formula below, Formula of);
/// The sum or product, by its sign "∑" or "∏", from `below` to `above`, if there is one.
Formula summation(std::string sign, Formula below, std::optional<Formula> above, Formula of);
/// sides[0] = sides[1] = ...; a single side is returned unchanged.
Formula equation(std::vector<Formula> sides);
Formula relation(std::string sign, std::vector<Formula> sides);

/// Whether the formula is written with a minus sign in front.
bool is_negative(const Formula& formula);
/// The formula without the minus sign in front.
Formula without_sign(Formula formula);

}  // namespace blossom::worked
