#pragma once

#include <blossom/core/maps/bspline_curve.hpp>

#include <cstddef>
#include <optional>

#include "operation.hpp"

/// Which polynomial of a B-spline is meant.

namespace blossom::protocol {

/// Field "segment", which only a bspline has: the index i of a knot span [t_i, t_(i+1)).
std::optional<std::size_t> read_span(Fields& request, const Map& map, const Limits& limits);

/// The span asked for, or the only one.
/// Errors: `outside_domain` if there is no such span, or if none is named and there are several.
std::size_t chosen_span(const BSplineCurve& curve, std::optional<std::size_t> span);

/// Field "segment".
Field segment_field();
/// --segment, for this field.
Option segment_option();

}  // namespace blossom::protocol
