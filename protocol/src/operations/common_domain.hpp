#pragma once

#include <blossom/core/patch/combined_maps.hpp>

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "maps/dispatch_on_kind.hpp"

/// Maps on one domain, in one representation.

namespace blossom::protocol {

/// Maps in the representation of one of them: monomials if no map has a domain of its own, B-splines if one
/// of them is a B-spline, and control nets over one domain otherwise. Curves are patches on one segment.
struct CommonMaps {
    std::variant<std::vector<PolynomialPatch>, std::vector<BezierPatch>, std::vector<TensorBSpline>> maps;
    std::vector<PointForm> forms;
    bool are_curves = true;
    bool tensor = true;
    std::vector<BarycentricFrame> frames;  ///< of control nets
    std::vector<std::string> variables;    ///< of polynomials in several variables
    std::string variable = "t";            ///< of polynomial curves

    std::size_t size() const { return forms.size(); }
    /// The number of coordinates of a point of map i, without its weight.
    std::size_t dimension(std::size_t i) const;
};

/// Errors: `mismatched_dimensions` for another number of parameters, `outside_domain` for another domain,
/// both at the index of the map in `place`; `wrong_kind`.
CommonMaps on_common_domain(std::span<const Map> maps, const Limits& limits, const Place& place = {"maps"});

/// Errors: `mismatched_dimensions` at "maps" unless the points of all maps have as many coordinates.
void require_points_alike(const CommonMaps& given);

/// One of the representations.
using CommonMap = std::variant<PolynomialPatch, BezierPatch, TensorBSpline>;

/// The map of a result, a curve where the given maps are curves.
Map map_of(const CommonMaps& given, CommonMap value, const PointForm& form);

/// The map with these coordinates, which are polynomials in the coordinates of the points of the given maps.
/// It is rational where one of them is, see `projective`; with its weights apart unless a control point has
/// the weight 0 or a given map is homogeneous.
Map combined_map(const CommonMaps& given, CoordinateSums sums, bool scalar, const Limits& limits);
/// The same where the last of these coordinates is the weight of the result.
Map combined_rational_map(const CommonMaps& given, const CoordinateSums& sums, bool scalar,
                          const Limits& limits);

}  // namespace blossom::protocol
