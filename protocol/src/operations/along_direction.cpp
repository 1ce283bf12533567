#include "along_direction.hpp"

#include <numeric>
#include <string>

#include "map_options.hpp"

namespace blossom::protocol {

namespace {

/// The number of directions of a tensor product; none of other maps.
std::optional<std::size_t> direction_count(const Map& map) {
    if (const auto* spline = std::get_if<TensorBSpline>(&map.value)) return spline->directions();
    const auto* patch = std::get_if<Patch>(&map.value);
    return patch && patch->tensor ? std::optional(patch->shape().factors()) : std::nullopt;
}

}  // namespace

Field direction_field(std::string documentation) {
    return optional("direction", ValueKind::count, std::move(documentation));
}

Option direction_option() { return field_option("--direction", "direction", "D", count); }

std::optional<std::size_t> read_direction(Fields& request, const Map& map, const Limits& limits) {
    const auto directions = direction_count(map);
    if (!directions) return std::nullopt;
    return request.optional("direction", [&](const Json& value) {
        const std::size_t direction = read_index(value, limits);
        if (direction < *directions) return direction;
        throw Error(ErrorCode::wrong_arity, "there is no direction " + std::to_string(direction) + ": the " +
                                                std::to_string(*directions) +
                                                " directions are numbered from 0");
    });
}

std::optional<std::size_t> require_direction(Fields& request, const Map& map, const Limits& limits) {
    const auto direction = read_direction(request, map, limits);
    if (!direction && direction_count(map)) request.missing("direction");
    return direction;
}

std::vector<std::size_t> directions_or_all(std::optional<std::size_t> direction, const Map& map) {
    if (direction) return {*direction};
    std::vector<std::size_t> all(direction_count(map).value_or(0));
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

void require_tensor(const Patch& patch) {
    if (patch.tensor) return;
    throw Error(ErrorCode::wrong_kind, "a simplex has no directions; a tensor product is needed here",
                Place{"map"});
}

PlacedPatch placed_tensor(const Patch& patch, const Limits& limits) {
    require_tensor(patch);
    Patch net = as_net(patch, limits);
    return {std::get<BezierPatch>(std::move(net.map)), std::move(net.frames)};
}

Patch tensor_patch(PlacedPatch placed) {
    return {std::move(placed.patch), true, std::move(placed.frames), {}};
}

}  // namespace blossom::protocol
