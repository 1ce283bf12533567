#pragma once

#include <string>

#include "description/members.hpp"

/// Fields that several operations have.

namespace blossom::protocol {

inline Field map_field() { return required("map", ValueKind::map, "the map"); }

/// A result that is a map.
inline Field map_member(std::string documentation) {
    return required("map", ValueKind::map, std::move(documentation));
}
inline Field maps_member(std::string documentation) {
    return required("maps", Shape::list(ValueKind::map), std::move(documentation));
}

inline Shape numbers_shape() { return Shape::list(ValueKind::number); }
inline Shape tuples_shape() { return Shape::list(numbers_shape()); }
inline Shape counts_shape() { return Shape::list(ValueKind::count); }
/// A number for a curve, and one number or null per direction for a tensor product.
inline Shape cut_shape() { return Shape::list(Shape::one_of({ValueKind::number, ValueKind::null})); }
/// Parameters of a curve, or of a patch.
inline Shape parameters_shape() { return Shape::one_of({numbers_shape(), tuples_shape()}); }

inline Field values_member() {
    return required("values", Shape::list(ValueKind::point), "the values at the parameters, in their order");
}
inline Field degree_member() { return optional("degree", ValueKind::count, "the formal degree"); }
inline Field degrees_member() {
    return optional("degrees", counts_shape(), "instead of `degree`: the formal degrees of a tensor product");
}

/// The domain and the degrees of control points.
inline Field vertices_field() {
    return optional("vertices", tuples_shape(), "for a patch: the vertices of the new simplex");
}
inline Field intervals_field() {
    return optional("intervals", Shape::list(ValueKind::interval),
                    "for a patch: the new box, one interval per direction");
}
inline Field degrees_field() {
    return optional("degrees", counts_shape(), "for a tensor product: the new formal degrees");
}

}  // namespace blossom::protocol
