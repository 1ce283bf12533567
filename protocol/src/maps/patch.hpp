#pragma once

#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/core/maps/patch_map.hpp>
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
    bool tensor = false;  ///< one number per direction, and one list of arguments per direction
    /// The simplices of a control net, one per factor; none where parameters are barycentric.
    std::vector<BarycentricFrame> frames;
    std::vector<std::string> variables;  ///< of a polynomial
    /// Of a polynomial in kind taylor: it is written in powers of the differences from here.
    Coordinates center = {};

    const NetShape& shape() const { return shape_of(map); }
    std::size_t dimension() const { return points_of(map).dimension(); }
    bool is_polynomial() const { return std::holds_alternative<PolynomialPatch>(map); }
    bool is_barycentric() const { return !is_polynomial() && frames.empty(); }
    /// The number of coordinates of a parameter.
    std::size_t parameters() const;
};

/// The numbers of a parameter, a direction or a vertex: `count` of them. Errors: `mismatched_dimensions`.
std::vector<Rational> read_tuple(const Json& value, std::size_t count, const Limits& limits);

/// Errors: `not_affine` unless the barycentric numbers have the sum `mass`.
void require_sum(std::span<const Rational> numbers, const Rational& mass);

/// (u, mass) in one factor as the engine's argument.
Coordinates engine_argument(const Patch& patch, std::size_t factor, std::span<const Rational> u,
                            const Rational& mass);
/// Numbers of a parameter as the engine's arguments, one per factor: barycentric for a net, with the mass in
/// front for a polynomial. Errors: `not_affine` for barycentric numbers whose sum is not the mass.
PatchPoint engine_arguments(const Patch& patch, std::span<const Rational> numbers, const Rational& mass);

/// One frame per factor.
std::vector<std::size_t> degrees_of(const NetShape& shape);
/// Writes "degrees", or "degree" for a simplex.
void write_degrees(Json& map, const Patch& patch);

/// The simplices of the domain; by default the unit box or the standard simplex.
std::vector<BarycentricFrame> domain_or_standard(const Patch& patch);

/// A list of vertices, each an array of numbers. Errors: those of `BarycentricFrame`.
BarycentricFrame read_vertices(const Json& value, const Limits& limits);
/// Those of a simplex of this dimension in a space of the same. Errors: as well `mismatched_dimensions`.
BarycentricFrame read_vertices(const Json& value, std::size_t dimension, const Limits& limits);
/// One interval per direction, as simplices of dimension 1. Errors: `wrong_arity`.
std::vector<BarycentricFrame> read_intervals(const Json& value, std::size_t directions, const Limits& limits);

}  // namespace blossom::protocol
