#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/worked/document.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "formulas_of_values.hpp"

namespace blossom::worked {

/// What a triangle of blossom values is made from: node i of level r is the value at `label`, a combination
/// of nodes i and i + 1 of the level before with `weights`.
struct TriangleRule {
    std::size_t degree = 0;
    std::function<std::vector<Argument>(std::size_t level, std::size_t i)> label;
    std::function<std::pair<Rational, Rational>(std::size_t level, std::size_t i)> weights;
    std::function<Coordinates(std::span<const Argument> arguments)> value;
    Naming name;
};

TrianglePyramid triangle_by(const TriangleRule& rule, std::string caption);

/// Points in increasing order; with other arguments among them the order is kept.
std::vector<Argument> ordered(std::vector<Argument> arguments);

}  // namespace blossom::worked
