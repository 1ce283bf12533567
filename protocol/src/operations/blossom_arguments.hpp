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

std::vector<std::string_view> construction_names();
inline Shape construction_shape() { return Shape::words(construction_names()); }

/// The construction of that name. Errors: `wrong_kind`.
Construction read_construction(const Json& value);

/// Field "arguments": numbers, vectors or pairs; of a patch points, or one list a direction.
Field arguments_field(Presence presence, std::string documentation);
/// --at, for this field.
Option arguments_option(std::string help);

}  // namespace blossom::protocol
