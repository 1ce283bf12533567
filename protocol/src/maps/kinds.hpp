#pragma once

#include "map.hpp"

/// What each kind of map defines: how it is read, how it is written as JSON, and how a person reads it.

namespace blossom::protocol {

/// {"kind": "polynomial", "coefficients" or "text", "degree"?, "denominator"?, "homogeneous"?}
Map read_polynomial(Fields& fields, const Limits& limits);
Json write(const PolynomialCurve& curve, const PointForm& form);
std::string formula(const PolynomialCurve& curve, const Map& map, std::string_view name);

/// {"kind": "bezier", "control_points", "interval"?, "weights"?, "degree"?, "homogeneous"?}
Map read_bezier(Fields& fields, const Limits& limits);
Json write(const BezierCurve& curve, const PointForm& form);
std::string formula(const BezierCurve& curve, const Map& map, std::string_view name);

/// {"kind": "taylor", "center", "coefficients", "degree"?, "denominator"?, "homogeneous"?}
Map read_taylor(Fields& fields, const Limits& limits);
Json write(const TaylorCurve& curve, const PointForm& form);
std::string formula(const TaylorCurve& curve, const Map& map, std::string_view name);

/// {"kind": "bspline", "degree", "knots", "control_points", "weights"?, "homogeneous"?}
Map read_bspline(Fields& fields, const Limits& limits);
Json write(const BSplineCurve& curve, const PointForm& form);
std::string formula(const BSplineCurve& curve, const Map& map, std::string_view name);

/// {"kind": "bspline", "degrees", "knots", "control_net", "weights"?, "homogeneous"?}
Map read_tensor_bspline(Fields& fields, const Limits& limits);
Json write(const TensorBSpline& spline, const PointForm& form);
std::string formula(const TensorBSpline& spline, const Map& map, std::string_view name);

/// {"kind": "progressive", "knots", "control_points", "weights"?, "degree"?, "homogeneous"?}
Map read_progressive(Fields& fields, const Limits& limits);
Json write(const ProgressiveCurve& curve, const PointForm& form);
std::string formula(const ProgressiveCurve& curve, const Map& map, std::string_view name);

/// {"kind": "samples", "degree", "interval"?, "values": [[t, point], ...]}
Map read_samples(Fields& fields, const Limits& limits);
Json write(const Samples& samples, const PointForm& form);
std::string formula(const Samples& samples, const Map& map, std::string_view name);

/// {"kind": "polynomial", "variables", "text" or "terms", "degree" or "degrees"?, "denominator"?, ...}
Map read_several_variables(Fields& fields, const Limits& limits);
Json write(const PolynomialPatch& polynomial, const Patch& patch, const PointForm& form);
std::string formula(const PolynomialPatch& polynomial, const Map& map, std::string_view name);
/// "formal degree 2", or "formal degrees 2, 1".
std::string degree_text(const Patch& patch);

/// {"kind": "tensor", "degrees", "control_net", "intervals"?, "weights"?, "homogeneous"?}
Map read_tensor(Fields& fields, const Limits& limits);
/// {"kind": "simplex", "degree", "control_net", "vertices"?, "weights"?, "homogeneous"?}
Map read_simplex(Fields& fields, const Limits& limits);
Json write(const Patch& patch, const PointForm& form);
std::string formula(const Patch& patch, const Map& map, std::string_view name);

}  // namespace blossom::protocol
