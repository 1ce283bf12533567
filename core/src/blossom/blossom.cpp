#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "polarization.hpp"
#include "run_construction.hpp"
#include "values_in_words.hpp"

namespace blossom {

std::string_view construction_name(Construction construction) {
    switch (construction) {
        case Construction::symmetric:
            return "symmetric";
        case Construction::polarization:
            return "polarization";
        case Construction::regrouped_polarization:
            return "regrouped-polarization";
        case Construction::casteljau:
            return "casteljau";
    }
    return "";
}

void throw_wrong_arity(std::size_t degree, std::size_t arguments) {
    const std::string expected = std::to_string(degree);
    throw Error(ErrorCode::wrong_arity,
                "the blossom of a map of formal degree " + expected + " takes " + expected +
                    " arguments, not " + std::to_string(arguments),
                Part::arguments);
}

Coordinates blossom_value(const PolynomialMap& map, std::span<const Argument> arguments,
                          Construction construction, const Limits& limits) {
    require_arity(degree_of(map), arguments.size());
    if (auto value = value_in_words(map, arguments, construction, limits)) return *std::move(value);
    if (construction == Construction::symmetric) {
        if (const auto* bezier = std::get_if<BezierCurve>(&map))
            return Blossom(monomial_form(*bezier, limits), limits)(arguments);
        return Blossom(map, limits)(arguments);
    }
    if (construction != Construction::casteljau)
        return polarization_value(map, arguments, construction, limits);
    const ClearedArguments cleared = cleared_one_by_one(arguments);
    require_result_bits(numerator_bits(map) + cleared.bits + arguments.size() * frame_bits(map), limits);
    return reduced(run_construction(map, construction, cleared.pairs, limits), cleared.denominator());
}

Coordinates blossom_from_values(const std::function<Coordinates(const Rational&)>& map,
                                std::span<const Parameter> arguments, const Limits& limits) {
    PatchArguments points(1);
    for (const Parameter& argument : arguments)
        points[0].push_back({Rational(1) - argument.value, argument.value});
    return blossom_from_values(
        NetShape::simplex(1, arguments.size()), [&](const PatchPoint& point) { return map(point[0][1]); },
        points, limits);
}

}  // namespace blossom
