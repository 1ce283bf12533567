#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>

namespace blossom {

/// The map at a parameter of one direction, as a map in the other directions: the value of every row. Errors:
/// `outside_domain`; `wrong_arity` if there is no other direction.
TensorBSpline isoparametric(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                            const Limits& limits = {});

/// The map on the segment from one point of the domain to another, as a spline curve over an interval: on
/// each part of the segment that lies in one box of spans, `restricted` of this polynomial; then `join`.
/// Where the segment runs along knots, the map is that on the side of the greater parameters. Errors:
/// `outside_domain` at `Part::at / d`; those of `restricted` and `join`.
BSplineCurve restricted(const TensorBSpline& spline, std::span<const Rational> from,
                        std::span<const Rational> to, const Interval& interval, const Limits& limits = {});

}  // namespace blossom
