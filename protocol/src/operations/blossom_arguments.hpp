#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <string>
#include <vector>

#include "operation.hpp"

namespace blossom::protocol {

inline constexpr Construction all_constructions[] = {Construction::symmetric, Construction::polarization,
                                                     Construction::regrouped_polarization,
                                                     Construction::casteljau};

/// The arguments of a blossom of a map of this form.
/// Errors: those of `read_argument`; `zero_weight` for a vector, where the values are divided by their
/// weight: the blossom of a rational map has no point there.
std::vector<Argument> read_arguments(const Json& value, const PointForm& form, const Limits& limits);

/// "symmetric", "polarization", "regrouped-polarization" or "casteljau". Errors: `wrong_kind`.
Construction read_construction(const Json& value);

/// --at, for field "arguments".
Option arguments_option(std::string help);

}  // namespace blossom::protocol
