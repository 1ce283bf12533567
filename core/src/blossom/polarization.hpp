#pragma once

// Values by the polarization inverse formula: with every term evaluated, or with combined terms.

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/maps/bezier_patch.hpp>

#include "maps/integer_frame.hpp"

namespace blossom {

/// The number of terms prod(m_i + 1) of polarization at these arguments, or `limit + 1` if it exceeds
/// `limit`.
std::size_t polarization_terms(std::span<const std::size_t> multiplicities, std::size_t limit);

/// The multiplicities of the distinct arguments.
template <class Argument>
std::vector<std::size_t> multiplicities(std::span<const Argument> arguments) {
    std::vector<std::size_t> counts;
    for (const auto& group : constructions::grouped(arguments)) counts.push_back(group.second);
    return counts;
}
/// The multiplicities in each factor.
std::vector<std::size_t> multiplicities(const PatchArguments& arguments);

/// Errors: `limit_exceeded` if there are more terms than `polarization_terms`.
void require_terms_of_polarization(std::span<const std::size_t> multiplicities, const Limits& limits);

/// The multiply-adds n^2 (n + 1)^2 / 4 of a regrouped polarization, or `limit + 1` if they exceed `limit`.
std::size_t regrouping_work(std::size_t n, std::size_t limit);

/// The value by either form of polarization. Errors: `limit_exceeded`.
Coordinates polarization_value(const PolynomialMap& map, std::span<const Argument> arguments,
                               Construction construction, const Limits& limits);

}  // namespace blossom
