#pragma once

#include "common_domain.hpp"

namespace blossom::protocol {

/// The determinant of the partial derivatives of a map into a space of the dimension of its domain.
/// Errors: `mismatched_dimensions` at "map"; those of `with_partial_derivatives`.
Map jacobian_of(const CommonMaps& given, const Limits& limits);

}  // namespace blossom::protocol
