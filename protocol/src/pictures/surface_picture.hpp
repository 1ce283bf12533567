#pragma once

#include <string>
#include <vector>

#include "mesh.hpp"

namespace blossom::protocol {

/// A place on a surface with a text beside it.
struct SpaceMark {
    SpacePoint place;
    std::string label;
};

/// The contents of a picture of patches.
struct SurfacePicture {
    std::string title;
    std::vector<Mesh> meshes;
    std::optional<Mesh> before;  ///< only its control net is painted, faintly
    std::vector<SpaceMark> points;
};

/// The surfaces, lines of constant parameters on them and their control nets, as an SVG document: of maps
/// into the plane as they are, otherwise in an oblique view, x to the right, z up and y into the picture. A
/// graph is stretched to a box.
///
/// Cells are painted from the back to the front. Numbers are rounded to hundredths of a pixel
/// in the last step.
std::string svg_of(const SurfacePicture& picture);

}  // namespace blossom::protocol
