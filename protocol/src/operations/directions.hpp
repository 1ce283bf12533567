#pragma once

#include <vector>

#include "json/fields.hpp"
#include "maps/points.hpp"

namespace blossom::protocol {

/// The directions of a derivative of a patch: "directions", or "direction" as often as "order" says. Each is
/// through `read`, of `parameters` numbers. Errors: `missing_field`, `limit_exceeded`.
template <class Read>
auto read_directions(Fields& request, std::size_t parameters, const Limits& limits, const Read& read) {
    auto list = request.optional("directions", [&](const Json& value) { return read_list(value, read); });
    if (list) return std::move(*list);
    const auto direction = request.required("direction", read);
    const std::size_t order =
        request.optional("order", [&](const Json& value) { return read_count(value, limits); }).value_or(1);
    require_numbers(order, parameters, limits);
    return std::vector(order, direction);
}

}  // namespace blossom::protocol
