#pragma once

#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>

namespace blossom {

/// The integral of |P|^2 over the domain, summed over the coordinates; over the standard simplex where a
/// factor has no frame.
///
/// The integral of a polynomial over a simplex is the mean of its control points times the volume. Cost: the
/// square of each coordinate, one multiply-add per pair of control points. Errors: `limit_exceeded`.
Rational integral_of_square(const BezierPatch& patch, std::span<const BarycentricFrame> frames,
                            const Limits& limits = {});

struct PatchReduction {
    BezierPatch patch;
    Rational l2_squared;  ///< the integral of |P - Q|^2 over the domain, summed over the coordinates

    bool exact() const { return l2_squared.is_zero(); }
};

/// An approximation of a patch by one of the given degrees, one per factor, with the exact error.
///
/// A factor that is an interval is reduced like the curve along it, see `curve_along`, one after the other:
/// projections of different directions commute, so that `least_squares` gives the least error among all maps
/// of these degrees. Other simplices are reduced by `least_squares` only. There the best approximation is
/// the one whose control points, raised to the degree of the patch, are nearest to those of the patch in the
/// Euclidean sense.
///
/// `frames` is empty for barycentric parameters. Cost: that of curves; for a simplex with N control points of
/// the lower degree a system of N equations. Errors: those of `reduce` for curves; `wrong_arity` for another
/// number of degrees; `wrong_kind` for another method on a simplex, and for `uniform`; `limit_exceeded`.
/// Source: Peters and Reif, "Least squares approximation of Bezier coefficients provides best degree
/// reduction in the L2-norm", 2000.
PatchReduction reduce(const BezierPatch& patch, std::span<const BarycentricFrame> frames,
                      std::span<const std::size_t> degrees, ReductionMethod method,
                      const Limits& limits = {});

struct TensorReduction {
    TensorBSpline spline;
    Rational l2_squared;
};

/// The same of splines, see spline_reduction.hpp, one direction after the other. Errors: those of `reduce`
/// for splines; `wrong_arity`; `wrong_kind` for `uniform`.
TensorReduction reduce(const TensorBSpline& spline, std::span<const std::size_t> degrees,
                       ReductionMethod method, const Limits& limits = {});

}  // namespace blossom
