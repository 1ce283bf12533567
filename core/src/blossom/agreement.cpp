#include <blossom/core/blossom/agreement.hpp>

#include <algorithm>
#include <limits>
#include <string>

#include "compare_constructions.hpp"
#include "polarization.hpp"
#include "run_construction.hpp"

namespace blossom {

namespace {

/// The term operations of polarization on n distinct symbols: a power of a sum of N symbols has C(n + N, N)
/// terms.
Integer symbolic_work(std::size_t n) {
    Integer work;
    for (std::size_t size = 0; size <= n; ++size) work += binomial(n, size) * binomial(n + size, size);
    return work;
}

/// Bounds the bits of a coefficient of the blossom written out: a change of basis and the common denominator
/// of the binomials.
std::size_t coefficient_bits(const PolynomialMap& map) {
    const auto* bezier = std::get_if<BezierCurve>(&map);
    const std::size_t bits_a_degree = 4 + (bezier ? cleared(bezier->interval()).bits() : 0);
    return greatest_bit_length(numbers_of(map).numbers().numerators()) + degree_of(map) * bits_a_degree;
}

}  // namespace

std::string polarization_excess(std::size_t terms, const Limits& limits) {
    if (terms <= limits.polarization_terms) return {};
    return "more terms than the limit polarization_terms = " + std::to_string(limits.polarization_terms);
}

std::string symbolic_excess(const Integer& work, const Limits& limits) {
    if (work <= Integer(limits.expansion_work)) return {};
    return to_string(work) +
           " term operations, more than the limit expansion_work = " + std::to_string(limits.expansion_work);
}

std::vector<SparsePolynomial> quotients(Quotients<SparsePolynomial> value) {
    const Rational scale(1, value.denominator);
    for (SparsePolynomial& numerator : value.numerators) numerator *= scale;
    return std::move(value.numerators);
}

Agreement<Coordinates> agreement(const PolynomialMap& map, std::span<const Argument> arguments,
                                 const Limits& limits) {
    require_arity(degree_of(map), arguments.size());
    const ClearedArguments cleared = cleared_one_by_one(arguments);
    std::string strict = polarization_excess(
        polarization_terms(multiplicities(std::span<const HomogeneousPair<Integer>>(cleared.pairs)),
                           limits.polarization_terms),
        limits);
    const auto excess = [&](Construction construction) -> std::string {
        if (construction == Construction::polarization) return strict;
        if (construction != Construction::regrouped_polarization) return "";
        if (regrouping_work(arguments.size(), limits.regrouping_work) <= limits.regrouping_work) return "";
        return "more multiply-adds than the limit regrouping_work = " +
               std::to_string(limits.regrouping_work);
    };
    const auto run = [&](Construction construction) {
        return blossom_value(map, arguments, construction, limits);
    };
    if (strict.empty()) return collected_agreement<Coordinates>(excess, run);
    return collected_agreement<Coordinates>(excess, run,
                                            {Construction::symmetric, Construction::polarization,
                                             Construction::regrouped_polarization, Construction::casteljau});
}

Agreement<std::vector<SparsePolynomial>> agreement_for_all_arguments(const PolynomialMap& map,
                                                                     const Limits& limits) {
    const std::size_t n = degree_of(map);
    const std::size_t bits = std::numeric_limits<std::size_t>::digits - 1;
    require_within(std::size_t{1} << std::min(n, bits), limits.expansion_terms, "expansion_terms",
                   "the number of terms of the blossom of formal degree " + std::to_string(n) + ", at least");
    require_result_bits(coefficient_bits(map), limits, (std::size_t{1} << n) * numbers_of(map).dimension());

    std::vector<HomogeneousPair<SparsePolynomial>> symbols;
    symbols.reserve(n);
    for (std::size_t i = 0; i < n; ++i) symbols.push_back({SparsePolynomial::variable(i), 1});

    return symbolic_agreement(symbolic_work(n), limits, [&](Construction construction) {
        return run_construction<SparsePolynomial>(map, construction, symbols, limits);
    });
}

std::vector<SparsePolynomial> elementary_symmetric_form(const PolynomialMap& map, const Limits& limits) {
    require_result_bits(coefficient_bits(map), limits, numbers_of(map).numbers().size());
    const PolynomialCurve curve = monomial(map, limits);
    std::vector<SparsePolynomial> forms;
    for (const auto row : curve.coefficients().rows()) {
        const Quotients<Integer> normalised = constructions::normalised_coefficients(row);
        const Integer denominator = normalised.denominator * curve.coefficients().denominator();
        SparsePolynomial form;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const SparsePolynomial function =
                k == 0 ? SparsePolynomial(1) : SparsePolynomial::variable(k - 1);
            form += SparsePolynomial(Rational(normalised.numerators[k], denominator)) * function;
        }
        forms.push_back(std::move(form));
    }
    return forms;
}

}  // namespace blossom
