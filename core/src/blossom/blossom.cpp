#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "polarization.hpp"
#include "run_construction.hpp"
#include "values_in_words.hpp"

namespace blossom {

namespace {

Coordinates natural_value(const auto& curve, std::span<const Argument> arguments, const Limits& limits) {
    require_arity(curve.degree(), arguments.size());
    if (auto value = value_in_words(curve, arguments, limits)) return *std::move(value);
    return Blossom(curve, limits)(arguments);
}

}  // namespace

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

Coordinates blossom_value(const PolynomialCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits) {
    return natural_value(curve, arguments, limits);
}

Coordinates blossom_value(const BezierCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits) {
    return natural_value(curve, arguments, limits);
}

Coordinates blossom_value(const PolynomialMap& map, std::span<const Argument> arguments,
                          Construction construction, const Limits& limits) {
    require_arity(degree_of(map), arguments.size());
    const auto* curve = std::get_if<PolynomialCurve>(&map);
    const auto* bezier = std::get_if<BezierCurve>(&map);
    if (construction == Construction::symmetric) {
        return curve ? blossom_value(*curve, arguments, limits)
                     : blossom_value(monomial_form(*bezier, limits), arguments, limits);
    }
    if (construction != Construction::casteljau)
        return polarization_value(map, arguments, construction, limits);
    if (bezier) {
        if (auto value = value_in_words(*bezier, arguments, limits)) return *std::move(value);
    }
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
