#pragma once

#include "map.hpp"

/// Polynomials in several variables, which a `Patch` holds like control nets.

namespace blossom::protocol {

/// {"kind": "polynomial", "variables", "text" or "terms", "degree" or "degrees"?, "denominator"?, ...}
Map read_several_variables(Fields& fields, const Limits& limits);
Members members_in_several_variables();
/// {"kind": "taylor", "variables", "center", "terms", "degree" or "degrees"?, "denominator"?, ...}
Map read_expansion(Fields& fields, const Limits& limits);
Members expansion_members();
Json write(const PolynomialPatch& polynomial, const Patch& patch, const PointForm& form);
std::string formula(const PolynomialPatch& polynomial, const Map& map, std::string_view name);
/// "formal degree 2", or "formal degrees 2, 1".
std::string degree_text(const Patch& patch);

}  // namespace blossom::protocol
