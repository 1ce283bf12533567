#pragma once

#include "maps/map.hpp"

namespace blossom::cli {

/// {"kind": "polynomial", "coefficients" or "text", "degree"?, "denominator"?, "homogeneous"?}
Map read_polynomial(Fields& fields, const Limits& limits);
Json polynomial_to_json(const PolynomialCurve& curve, const PointForm& form);

/// {"kind": "bezier", "control_points", "interval"?, "weights"?, "degree"?, "homogeneous"?}
Map read_bezier(Fields& fields, const Limits& limits);
Json bezier_to_json(const BezierCurve& curve, const PointForm& form);

}  // namespace blossom::cli
