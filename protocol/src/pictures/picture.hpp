#pragma once

#include <string>
#include <vector>

#include "drawn_curve.hpp"

namespace blossom::protocol {

/// A curve and how it is painted.
struct PictureLayer {
    DrawnCurve curve;
    std::string name;  ///< for the legend
    bool faint;        ///< what was before
};

struct Picture {
    std::string title;
    std::vector<PictureLayer> layers;  ///< painted in this order
    std::vector<Mark> points;          ///< on top
    bool equal_scales = true;          ///< the same length on both axes
};

/// The picture as an SVG document. Numbers are rounded to hundredths of a pixel in the last step.
std::string svg_of(const Picture& picture);

}  // namespace blossom::protocol
