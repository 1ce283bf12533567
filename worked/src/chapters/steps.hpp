#pragma once

#include <blossom/worked/chapters.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curve_pictures.hpp"
#include "formulas_of_values.hpp"

namespace blossom::worked {

/// A step with its blocks; those that are optional and absent are left out.
class StepBuilder {
public:
    explicit StepBuilder(std::string title) : step_{std::move(title), {}} {}

    StepBuilder& say(Text text) {
        step_.blocks.emplace_back(Paragraph{std::move(text)});
        return *this;
    }
    StepBuilder& show(std::vector<Formula> formulas) {
        step_.blocks.emplace_back(Display{std::move(formulas)});
        return *this;
    }
    StepBuilder& add(Block block) {
        step_.blocks.push_back(std::move(block));
        return *this;
    }
    StepBuilder& add_if(std::optional<Picture> picture) {
        if (picture) step_.blocks.emplace_back(std::move(*picture));
        return *this;
    }
    Step done() { return std::move(step_); }

private:
    Step step_;
};

/// p(a^(n-k), b^k) = P_k for all control points.
std::vector<Formula> control_point_equations(const BezierCurve& curve, const std::string& blossom = "p");

/// The equation of the map by its coefficients, for a check: P(t) = ....
Formula polynomial_equation(const PolynomialMap& map, const std::string& variable, const Limits& limits);

/// The division of the first coordinates by the last: its inverse times a point.
Formula division(const Coordinates& homogeneous);

}  // namespace blossom::worked
