#pragma once

#include <string>

#include "operations/operation.hpp"

namespace blossom::protocol {

/// The patches of a result, or of the request where the result has none, as meshes in the Wavefront OBJ
/// format: one object per patch, with quadrilaterals, triangles or polylines between places rounded to the
/// nearest doubles. A graph has its value as z, over a single parameter as y.
///
/// Errors: as for `mesh_of`; `overflow` for a coordinate beyond the range of doubles.
std::string obj_of(const Answered& answered);

}  // namespace blossom::protocol
