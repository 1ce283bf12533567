#pragma once

#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/worked/chapters.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "formulas_of_values.hpp"

namespace blossom::worked {

/// A map into the plane for pictures: a plane map itself, a scalar one as its graph (t, P(t)); none for
/// constants, whose graph has no control points, and for more than two coordinates.
struct PlaneMap {
    PolynomialMap map;
    bool graph = false;
};
std::optional<PlaneMap> plane_map(const PolynomialMap& map, const Limits& limits);

PlanePoint place_of(const Coordinates& point);
std::vector<PlanePoint> places_of(const PointArray& points);

/// Adds the polygon through `points`, the control points of `curve` in the plane, with their blossom values
/// as names where it is `named`.
void add_polygon(Picture& picture, const BezierCurve& curve, const PointArray& points, Role role,
                 const Naming& name, bool named = true);

/// Whether all arguments are points, so that every node of a pyramid is a point.
bool all_points(std::span<const Argument> arguments);

/// A triangle of blossom values: node i of level r is the value at `label`, a combination
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

/// De Casteljau's algorithm as a triangle of blossom values.
TrianglePyramid casteljau_triangle(const BezierCurve& curve, std::span<const Argument> arguments,
                                   std::string caption, const Limits& limits);

/// The geometric construction of p(arguments): control polygon, all intermediate points with their blossom
/// labels, curve. None where there is no plane map, or an argument is not a point.
std::optional<Picture> construction_picture(const PolynomialMap& map, std::span<const Argument> arguments,
                                            std::string caption, const Limits& limits);

}  // namespace blossom::worked
