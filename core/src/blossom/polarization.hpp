#pragma once

// Values by the polarization inverse formula, with every term evaluated or with terms taken together.

#include <blossom/core/blossom/blossom.hpp>

#include "maps/integer_frame.hpp"

namespace blossom {

/// The number of terms prod(m_i + 1) of polarization at these arguments, or `limit + 1` when it is greater
/// than `limit`.
std::size_t polarization_terms(std::span<const std::size_t> multiplicities, std::size_t limit);

/// The multiplicities of the distinct arguments.
template <class R>
std::vector<std::size_t> multiplicities(std::span<const HomogeneousPair<R>> pairs) {
    std::vector<std::size_t> counts;
    for (const auto& group : constructions::grouped(pairs)) counts.push_back(group.second);
    return counts;
}

/// Errors: `limit_exceeded` when there are more terms than `polarization_terms`.
template <class R>
void require_terms_of_polarization(std::span<const HomogeneousPair<R>> pairs, const Limits& limits) {
    require_within(polarization_terms(multiplicities(pairs), limits.polarization_terms),
                   limits.polarization_terms, "polarization_terms",
                   "the number of terms of polarization, at least", Part::arguments);
}

/// The multiply-adds n^2 (n + 1)^2 / 4 of a regrouped polarization, or `limit + 1` when they are more than
/// `limit`.
std::size_t regrouping_work(std::size_t n, std::size_t limit);

/// The value of one of the two polarizations. Errors: `limit_exceeded`.
Coordinates polarization_value(const PolynomialMap& map, std::span<const Argument> arguments,
                               Construction construction, const Limits& limits);

}  // namespace blossom
