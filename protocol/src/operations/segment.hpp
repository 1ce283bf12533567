#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "operation.hpp"

/// The choice of one polynomial of a B-spline.

namespace blossom::protocol {

/// Field "segment": the index i of a knot span [t_i, t_(i+1)).
std::optional<std::size_t> read_span(Fields& request, const Limits& limits);
/// The same for a map that may not be a spline; then there is no such field.
std::optional<std::size_t> read_span(Fields& request, const Map& map, const Limits& limits);

/// The requested span, or the only one.
/// Errors: `outside_domain` if there is no such span, or if none is named and there are several.
std::size_t chosen_span(const BSplineCurve& curve, std::optional<std::size_t> span);

/// The polynomial on a box of spans, over this box.
Patch segment(const TensorBSpline& spline, std::span<const std::size_t> spans, const Limits& limits);

/// The polynomial of the field "segment", one index of a knot per direction; by default the only one. Errors:
/// as above.
Patch read_segment(Fields& request, const TensorBSpline& spline, const Limits& limits);

/// Field "segment".
Field segment_field();
/// The option --segment for this field.
Option segment_option();

}  // namespace blossom::protocol
