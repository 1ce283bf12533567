#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <string>
#include <vector>

#include "maps/dispatch_on_kind.hpp"
#include "operation.hpp"

namespace blossom::protocol {

inline constexpr Construction all_constructions[] = {Construction::symmetric, Construction::polarization,
                                                     Construction::regrouped_polarization,
                                                     Construction::casteljau};

/// The arguments of the blossom of a curve of this form.
/// Errors: those of `read_argument`; `zero_weight` for a vector, where the values are divided by their
/// weight: the blossom of a rational map has no point there.
std::vector<Argument> read_arguments(const Json& value, const PointForm& form, const Limits& limits);
std::vector<Argument> read_arguments(const Json& value, const OnePolynomial auto&, const PointForm& form,
                                     const Limits& limits) {
    return read_arguments(value, form, limits);
}
/// The arguments for a patch: for a simplex or a total degree a list of points [..], {"vector": [..]} or
/// {"homogeneous": [.., mass]}; for a tensor product one list per direction as for a curve.
PatchArguments read_arguments(const Json& value, const Patch& patch, const PointForm& form,
                              const Limits& limits);

/// Runs `action`, and removes factor 0 of a simplex from the place of an error: the request has no such
/// level.
template <class Action>
auto at_arguments(const Patch& patch, const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        const Place of_factor = Part::arguments / 0;
        if (patch.tensor || !error.place().begins_with(of_factor)) throw;
        throw error.at(Place(Part::arguments).around(error.place().inside(of_factor)));
    }
}
template <class Action>
auto at_arguments(const OnePolynomial auto&, const Action& action) {
    return action();
}

std::vector<std::string_view> construction_names();
inline Shape construction_shape() { return Shape::words(construction_names()); }

/// The construction of that name. Errors: `wrong_kind`.
Construction read_construction(const Json& value);

/// Field "arguments": numbers, vectors or pairs; of a patch points, or one list per direction.
Field arguments_field(Presence presence, std::string documentation);
/// The option --at for this field.
Option arguments_option(std::string help);

}  // namespace blossom::protocol
