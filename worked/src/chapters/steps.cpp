#include "steps.hpp"

namespace blossom::worked {

std::vector<Formula> control_point_equations(const BezierCurve& curve, const std::string& blossom) {
    std::vector<Formula> equations;
    const Interval& interval = curve.interval();
    for (std::size_t k = 0; k <= curve.degree(); ++k) {
        const auto arguments = end_arguments(interval.a(), interval.b(), curve.degree(), k);
        equations.push_back(
            equation({value_of_blossom(arguments, blossom), point_formula(curve.control_points()[k])}));
    }
    return equations;
}

Formula polynomial_equation(const PolynomialMap& map, const std::string& variable, const Limits& limits) {
    return definition_of({coefficient_form(map, limits), variable}).formulas.front();
}

Formula division(const Coordinates& homogeneous) {
    const Coordinates others(homogeneous.begin(), homogeneous.end() - 1);
    return product({number(Rational(1) / homogeneous.back()), point_formula(others)});
}

}  // namespace blossom::worked
