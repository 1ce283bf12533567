#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "description/shape.hpp"

/// Orders of contact in results.

namespace blossom::protocol {

/// Infinite where there is none.
inline Json order_json(const std::optional<std::ptrdiff_t>& order) {
    return order ? Json(Json::Number{std::to_string(*order)}) : Json("infinite");
}
inline Shape order_shape() { return Shape::one_of({ValueKind::integer, Shape::words({"infinite"})}); }

}  // namespace blossom::protocol
