#include <blossom/worked/document.hpp>

#include <algorithm>

#include "overloaded.hpp"

namespace blossom::worked {

std::string said_of(const Check& check) { return check.holds ? check.verdict : "This does NOT hold."; }

std::size_t largest_degree(const Document& document) {
    std::size_t degree = 0;
    for (const NamedMap& map : document.maps) {
        const auto of_polynomial = [](const PolynomialMap& one) {
            return std::visit([](const auto& curve) { return curve.degree(); }, one);
        };
        const auto of_spline = [](const BSplineCurve& spline) { return spline.degree(); };
        const auto of_triangle = [](const TriangleMap& triangle) { return triangle.net.shape()[0].degree; };
        const auto of_symbols = [](const SymbolicMap& any) { return any.coefficients.size() - 1; };
        degree = std::max(degree, std::visit(Overloaded{of_polynomial, of_spline, of_triangle, of_symbols},
                                             map.definition));
    }
    return degree;
}

}  // namespace blossom::worked
