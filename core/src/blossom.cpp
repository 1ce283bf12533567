#include <blossom/core/blossom.hpp>
#include <blossom/rational/error.hpp>

#include <string>

#include "run_construction.hpp"

namespace blossom {

namespace {

/// Normalised coefficients, or the control points.
PointArray prepared(const PolynomialMap& map) {
    if (const auto* bezier = std::get_if<BezierCurve>(&map)) return bezier->control_points();
    const PointArray& coefficients = std::get<PolynomialCurve>(map).coefficients();
    std::vector<Quotients<Integer>> rows;
    for (const auto row : coefficients.rows()) rows.push_back(constructions::normalised_coefficients(row));
    return point_array(rows, coefficients.denominator());
}

void require_bits(const PolynomialMap& map, const ClearedArguments& arguments, const Limits& limits) {
    std::size_t bits = greatest_bit_length(numbers_of(map).numbers().numerators()) + arguments.bits;
    if (const auto* bezier = std::get_if<BezierCurve>(&map)) {
        bits += arguments.pairs.size() * cleared(bezier->interval()).bits();
    }
    require_result_bits(bits, limits);
}

}  // namespace

std::string_view construction_name(Construction construction) {
    switch (construction) {
        case Construction::symmetric:
            return "symmetric";
        case Construction::polarization:
            return "polarization";
        case Construction::casteljau:
            return "casteljau";
    }
    return "";
}

void require_arity(const PolynomialMap& map, std::size_t arguments) {
    if (arguments == degree_of(map)) return;
    throw Error(ErrorCode::wrong_arity,
                "the blossom of a map of formal degree " + std::to_string(degree_of(map)) + " takes " +
                    std::to_string(degree_of(map)) + " arguments, not " + std::to_string(arguments),
                "/arguments");
}

std::size_t polarization_terms(std::span<const std::size_t> multiplicities, std::size_t limit) {
    std::size_t terms = 1;
    for (const std::size_t multiplicity : multiplicities) {
        if (terms > limit / (multiplicity + 1)) return limit + 1;
        terms *= multiplicity + 1;
    }
    return terms;
}

Blossom::Blossom(PolynomialMap map, Limits limits)
    : map_(std::move(map)), limits_(limits), prepared_(prepared(map_)) {
    require_within(degree(), limits_.degree, "degree", "the formal degree", "/degree");
}

std::size_t Blossom::degree() const { return degree_of(map_); }

std::size_t Blossom::dimension() const { return prepared_.dimension(); }

Coordinates Blossom::operator()(std::span<const Argument> arguments) const {
    require_arity(map_, arguments.size());
    const ClearedArguments cleared_arguments = cleared_one_by_one(arguments);
    require_bits(map_, cleared_arguments, limits_);
    const std::span<const HomogeneousPair<Integer>> pairs = cleared_arguments.pairs;

    Quotients<Integer> value;
    if (const auto* bezier = std::get_if<BezierCurve>(&map_)) {
        const auto [a, b, q] = cleared(bezier->interval());
        value = constructions::bernstein_sums<Integer>(prepared_.rows(), a, b, q, pairs);
    } else {
        value.numerators = constructions::symmetric_function_sums<Integer>(prepared_.rows(), pairs);
    }
    value.denominator *= prepared_.denominator();
    return reduced(value, cleared_arguments.denominator());
}

Coordinates blossom_value(const PolynomialMap& map, std::span<const Argument> arguments,
                          Construction construction, const Limits& limits) {
    require_arity(map, arguments.size());
    const ClearedArguments cleared = construction == Construction::polarization
                                         ? cleared_together(arguments, limits)
                                         : cleared_one_by_one(arguments);
    require_bits(map, cleared, limits);
    const std::span<const HomogeneousPair<Integer>> pairs = cleared.pairs;
    if (construction == Construction::polarization) {
        require_within(polarization_terms(multiplicities(pairs), limits.polarization_terms),
                       limits.polarization_terms, "polarization_terms",
                       "the number of terms of polarization, at least", "/arguments");
    }
    return reduced(run_construction(map, construction, pairs, limits), cleared.denominator());
}

Coordinates blossom_from_values(const std::function<Coordinates(const Rational&)>& map,
                                std::span<const Parameter> arguments, const Limits& limits) {
    if (arguments.empty()) return map(0);
    std::vector<HomogeneousPair<Rational>> points;
    points.reserve(arguments.size());
    for (const Parameter& argument : arguments) points.push_back({argument.value, 1});
    const std::span<const HomogeneousPair<Rational>> pairs = points;
    require_within(polarization_terms(multiplicities(pairs), limits.polarization_terms),
                   limits.polarization_terms, "polarization_terms",
                   "the number of terms of polarization, at least", "/arguments");

    const auto scaled_value_at_mean = [&](const HomogeneousPair<Rational>& sum,
                                          std::size_t count) -> Coordinates {
        if (count == 0) return {};
        Coordinates value = map(sum.u / Rational(count));
        const Rational weight = pow(Integer(count), arguments.size());
        for (Rational& coordinate : value) coordinate *= weight;
        return value;
    };
    Coordinates value = constructions::alternating_sum<Rational>(constructions::grouped(pairs), {0, 0}, 0,
                                                                 scaled_value_at_mean);
    const Rational divisor = factorial(arguments.size());
    for (Rational& coordinate : value) coordinate /= divisor;
    return value;
}

}  // namespace blossom
