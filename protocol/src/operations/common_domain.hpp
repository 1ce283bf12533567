#pragma once

#include <blossom/core/patch/combined_maps.hpp>
#include <blossom/core/patch/patch_contact.hpp>

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
/// both at the index of the map in "maps"; `wrong_kind`.
CommonMaps on_common_domain(std::span<const Map> maps, const Limits& limits);
/// One map, the field "map".
CommonMaps on_own_domain(const Map& map, const Limits& limits);

/// A map and its partial derivatives. Errors: `wrong_kind` at "map" for barycentric coordinates.
CommonMaps with_partial_derivatives(const CommonMaps& given, const Limits& limits);

/// The number of parameters; of barycentric ones without the last.
std::size_t parameters_of(const CommonMaps& given);

/// A map that is no B-spline as a patch.
Patch patch_of(const CommonMaps& given);

/// The map over its own domain, or over the unit box or simplex, in pieces that are control nets. Barycentric
/// coordinates are points of a space.
std::vector<PlacedPatch> nets_of(const CommonMaps& given, const Limits& limits);

/// Errors: `mismatched_dimensions` at "maps" unless the points of all maps have as many coordinates.
void require_points_alike(const CommonMaps& given);

/// One of the representations.
using CommonMap = std::variant<PolynomialPatch, BezierPatch, TensorBSpline>;

/// The map of a result on the domain of the given maps, a curve where these are curves. A rational one has
/// its weights apart unless a control point has the weight 0 or the form is homogeneous.
Map map_of(const CommonMaps& given, CommonMap value, PointForm form);

/// The map with these coordinates, which are polynomials in the coordinates of the points of the given maps.
/// It is rational where one of them is, see `projective`, and homogeneous where one of them is.
Map combined_map(const CommonMaps& given, CoordinateSums sums, bool scalar, const Limits& limits);
/// The same where the last of these coordinates is the weight of the result.
Map combined_rational_map(const CommonMaps& given, const CoordinateSums& sums, bool scalar,
                          const Limits& limits);

}  // namespace blossom::protocol
