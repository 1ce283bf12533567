#include <blossom/core/blossom/blossom.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "blossom_bits.hpp"
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
    return reduced(run_construction<Integer>(map, construction, cleared.pairs, limits),
                   cleared.denominator());
}

Coordinates blossom_from_values(const std::function<Coordinates(const Rational&)>& map,
                                std::span<const Parameter> arguments, const Limits& limits) {
    if (arguments.empty()) return map(0);
    std::vector<HomogeneousPair<Rational>> points;
    points.reserve(arguments.size());
    for (const Parameter& argument : arguments) points.push_back({argument.value, 1});
    const std::span<const HomogeneousPair<Rational>> pairs = points;
    require_terms_of_polarization(pairs, limits);

    const auto scaled_value_at_mean = [&](const HomogeneousPair<Rational>& sum,
                                          std::size_t count) -> Coordinates {
        if (count == 0) return {};
        Coordinates value = map(sum.u / Rational(count));
        const Rational weight = pow(Integer(count), arguments.size());
        for (Rational& coordinate : value) coordinate *= weight;
        return value;
    };
    Coordinates value = constructions::alternating_sum<Rational, HomogeneousPair<Rational>>(
        constructions::grouped(pairs), {0, 0}, 0, scaled_value_at_mean);
    const Rational divisor = factorial(arguments.size());
    for (Rational& coordinate : value) coordinate /= divisor;
    return value;
}

}  // namespace blossom
