#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/hermite_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/core/spline/progressive.hpp>

#include <variant>

#include "patch.hpp"
#include "samples.hpp"

/// The only list of the kinds of maps. A kind is registered by the type of its maps and its description,
/// which the file of the kind defines.

namespace blossom::protocol {

struct Kind;

extern const Kind polynomial_kind, bezier_kind, taylor_kind, bspline_kind, progressive_kind, hermite_kind,
    samples_kind, patch_kind, tensor_bspline_kind;

template <class Type, const Kind& kind>
struct Registered {};

template <class... Registrations>
struct KindList;

template <class... Types, const Kind&... kinds>
struct KindList<Registered<Types, kinds>...> {
    using Value = std::variant<Types...>;
    static constexpr const Kind* all[] = {&kinds...};
};

using Kinds = KindList<Registered<PolynomialCurve, polynomial_kind>,    //
                       Registered<BezierCurve, bezier_kind>,            //
                       Registered<TaylorCurve, taylor_kind>,            //
                       Registered<BSplineCurve, bspline_kind>,          //
                       Registered<ProgressiveCurve, progressive_kind>,  //
                       Registered<HermiteCurve, hermite_kind>,          //
                       Registered<Samples, samples_kind>,               //
                       Registered<Patch, patch_kind>,                   //
                       Registered<TensorBSpline, tensor_bspline_kind>>;

/// The value of a map of any kind.
using AnyMap = Kinds::Value;

}  // namespace blossom::protocol
