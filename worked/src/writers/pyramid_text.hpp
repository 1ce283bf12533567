#pragma once

#include <blossom/worked/document.hpp>
#include <blossom/worked/notation.hpp>

#include <cstddef>
#include <string>

namespace blossom::worked {

/// The pyramid in columns, one per level, with the weights on the arrows; where that is wider than `width`,
/// every node as a combination of its two, level by level.
std::string pyramid_text(const TrianglePyramid& pyramid, const Notation& notation, std::size_t width);

/// A node written out: label = weight label + weight label = value.
Formula node_equation(const TrianglePyramid& pyramid, std::size_t level, std::size_t i);

}  // namespace blossom::worked
