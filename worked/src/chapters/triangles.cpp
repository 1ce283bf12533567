#include "triangles.hpp"

#include <algorithm>

#include "curve_pictures.hpp"

namespace blossom::worked {

TrianglePyramid triangle_by(const TriangleRule& rule, std::string caption) {
    TrianglePyramid triangle{std::move(caption), {}};
    for (std::size_t r = 0; r <= rule.degree; ++r) {
        std::vector<PyramidNode>& level = triangle.levels.emplace_back();
        for (std::size_t i = 0; i + r <= rule.degree; ++i) {
            const std::vector<Argument> label = rule.label(r, i);
            PyramidNode node{rule.name(label), point_formula(rule.value(label)), {}, {}};
            if (r > 0) {
                const auto [left, right] = rule.weights(r, i);
                node.left_weight = number(left);
                node.right_weight = number(right);
            }
            level.push_back(std::move(node));
        }
    }
    return triangle;
}

std::vector<Argument> ordered(std::vector<Argument> arguments) {
    if (all_points(arguments)) std::ranges::sort(arguments, {}, &Argument::u);
    return arguments;
}

}  // namespace blossom::worked
