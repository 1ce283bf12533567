#pragma once

#include <blossom/core/constructions/net_shape.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <concepts>
#include <variant>

namespace blossom {

/// A polynomial map into Q^d as points in the shape of a net on a product of simplices; a curve is one
/// segment. The points are control points, with respect to vertices, or coefficients, with respect to an
/// origin and unit vectors.
template <class Map>
concept OnSimplices = requires(const Map& map) {
    { map.dimension() } -> std::same_as<std::size_t>;
    { shape_of(map) } -> std::convertible_to<NetShape>;
    { points_of(map) } -> std::same_as<const PointArray&>;
};

/// The same for a map in one of several representations.
template <class... Maps>
decltype(auto) shape_of(const std::variant<Maps...>& map) {
    return std::visit([](const auto& one) -> decltype(auto) { return shape_of(one); }, map);
}
template <class... Maps>
const PointArray& points_of(const std::variant<Maps...>& map) {
    return std::visit([](const auto& one) -> const PointArray& { return points_of(one); }, map);
}

}  // namespace blossom
