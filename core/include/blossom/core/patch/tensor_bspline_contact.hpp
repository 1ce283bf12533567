#pragma once

#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>

#include <cstddef>

namespace blossom {

/// The least contact of the polynomials on the two sides of a parameter of one direction, over all boxes of
/// the other directions; infinite if the parameter is not a knot.
///
/// Cost: that of the contact of two Bezier patches per box along the parameter. Errors: `outside_domain`
/// unless the parameter is strictly inside the domain of the direction; `limit_exceeded`. Source: DeRose,
/// theorem 2 and section 5.
PatchContact contact(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                     const Limits& limits = {});

/// The same for a rational map, see `projected_contact` in patch_contact.hpp. Additional error:
/// `zero_weight`.
PatchContact projected_contact(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                               const Limits& limits = {});

/// The least contact of the end of the domain of a direction with its beginning, moved behind it, see
/// periodic_spline.hpp.
PatchContact seam_contact(const TensorBSpline& spline, std::size_t direction, const Limits& limits = {});
PatchContact projected_seam_contact(const TensorBSpline& spline, std::size_t direction,
                                    const Limits& limits = {});

}  // namespace blossom
