#pragma once

#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/worked/document.hpp>

#include <optional>
#include <string>
#include <vector>

/// The chapters on triangles: each takes any map on a triangle.

namespace blossom::worked {

/// The greatest formal degree for which these pages are made: the number of nodes grows with its cube.
constexpr std::size_t triangle_page_degree = 5;

/// A map on a triangle with the vertices r, s, t.
struct GivenTriangle {
    PatchMap map;  ///< a polynomial in two variables is read over the origin and the ends of the unit vectors
    std::optional<BarycentricFrame> frame;  ///< the vertices of a control net, if they have coordinates
    std::vector<std::string> variables;     ///< of a polynomial
    bool weighted = false;                  ///< the last coordinate of the values is a weight
};

/// P(u) at barycentric coordinates u by de Casteljau's algorithm on a triangle, every node a blossom value,
/// checked by Bernstein polynomials. Errors: `wrong_kind` unless the domain is one triangle; `not_affine`,
/// `mismatched_dimensions` for u; `limit_exceeded`; `zero_weight`. Source: DeRose, section 5.2.
Document triangle_evaluation(const GivenTriangle& given, const Coordinates& u, const Limits& limits = {});

/// The control nets of the three triangles into which u divides the triangle, on three faces of the pyramid,
/// checked on the way back. Errors: besides, `degenerate_simplex` for u on a side. Source: DeRose,
/// section 5.2.
Document triangle_subdivision(const GivenTriangle& given, const Coordinates& u, const Limits& limits = {});

}  // namespace blossom::worked
