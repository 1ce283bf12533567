#pragma once

#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/core/patch/patch_agreement.hpp>
#include <blossom/rational/limits.hpp>

#include <string>
#include <vector>

#include "json/fields.hpp"
#include "points.hpp"

namespace blossom::protocol {

/// A map on a product of simplices or in several variables: kinds tensor and simplex, and polynomials with
/// "variables".
struct Patch {
    PatchMap map;
    bool tensor = false;  ///< one number a direction, and one list of arguments a direction
    /// The simplices of a control net, one a factor; none where parameters are barycentric.
    std::vector<BarycentricFrame> frames;
    std::vector<std::string> variables;  ///< of a polynomial

    const NetShape& shape() const;
    std::size_t dimension() const;
    bool is_polynomial() const { return std::holds_alternative<PolynomialPatch>(map); }
    bool is_barycentric() const { return !is_polynomial() && frames.empty(); }
    /// The numbers that make up a parameter.
    std::size_t parameters() const;
};

/// The numbers of a parameter, a direction or a vertex: `count` of them. Errors: `mismatched_dimensions`.
std::vector<Rational> read_tuple(const Json& value, std::size_t count, const Limits& limits);

/// Numbers of a parameter as the engine's arguments, one a factor: barycentric for a net, with the mass in
/// front for a polynomial. Errors: `not_affine` for barycentric numbers whose sum is not the mass.
PatchPoint engine_arguments(const Patch& patch, std::span<const Rational> numbers, const Rational& mass);

/// The arguments of a blossom: for a simplex or a total degree a list of points [..], {"vector": [..]} or
/// {"homogeneous": [.., mass]}; for a tensor product one list of numbers, {"vector": x} or {"homogeneous":
/// [u, mass]} a direction. Errors: `zero_weight` for a mass of 0 where the values are divided.
PatchArguments read_patch_arguments(const Json& value, const Patch& patch, const PointForm& form,
                                    const Limits& limits);

/// The coefficients or control points.
inline const PointArray& numbers_of(const PolynomialPatch& patch) { return patch.coefficients(); }
inline const PointArray& numbers_of(const BezierPatch& patch) { return patch.control_net(); }

/// Runs `action`; where the engine names factor 0 of a simplex, the request has no such level.
template <class Action>
auto at_arguments(const Patch& patch, const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        const Place of_factor = Part::arguments / 0;
        if (patch.tensor || !error.place().begins_with(of_factor)) throw;
        throw error.at(Place(Part::arguments).around(error.place().inside(of_factor)));
    }
}

/// What the engine's arguments, points all of them, are in the request's terms.
Json patch_arguments_json(const PatchArguments& arguments, bool tensor);

/// The domain simplices, those of the unit box or the standard simplex where there are none.
std::vector<BarycentricFrame> domain_or_standard(const Patch& patch);

/// A list of vertices, each an array of numbers. Errors: those of `BarycentricFrame`.
BarycentricFrame read_vertices(const Json& value, const Limits& limits);
/// A list of intervals as simplices of dimension 1.
std::vector<BarycentricFrame> read_intervals(const Json& value, const Limits& limits);

}  // namespace blossom::protocol
