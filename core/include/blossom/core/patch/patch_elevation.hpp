#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>

namespace blossom {

/// The same map with degree n + r in one factor: its blossom is the mean of the old one over the n-subsets of
/// the arguments, so that one step makes P~_i = sum_k i_k / (n + 1) P_(i - e_k).
///
/// The homogeneous form is multiplied by (x_0 + ... + x_s)^r. Cost: C(n + s, s) C(r + s, s) multiply-adds a
/// coordinate and entry of the other factors. Errors: `limit_exceeded`. Source: DeRose, section 5.3.
/// Statements: derose-tri-raise, derose-tri-raise-points, derose-tensor-allresults.
BezierPatch elevate(const BezierPatch& patch, std::size_t factor, std::size_t r, const Limits& limits = {});

/// The same map with these degrees, one a factor. Errors: `degree_too_low` if one is below that of the patch;
/// `limit_exceeded`.
BezierPatch elevated_to(const BezierPatch& patch, std::span<const std::size_t> degrees,
                        const Limits& limits = {});

}  // namespace blossom
