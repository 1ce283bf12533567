#pragma once

#include "mesh.hpp"

namespace blossom::protocol {

/// Adds the control net with the edges between points that differ in one argument. A control point of a
/// scalar map stands over the mean of its vertices or knots.
void add_net(Mesh& mesh, const Patch& patch, const PointForm& form);
void add_net(Mesh& mesh, const TensorBSpline& spline, const PointForm& form);

}  // namespace blossom::protocol
