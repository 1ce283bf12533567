#include "surface_plot.hpp"

#include <fmt/format.h>

#include "operations/patch_answers.hpp"
#include "surface_picture.hpp"

namespace blossom::protocol {

namespace {

SurfacePicture picture_of(const std::string& title, const std::vector<Map>& maps, const Limits& limits) {
    SurfacePicture picture;
    for (const Map& map : maps) picture.meshes.push_back(mesh_of(map, limits));
    picture.title =
        maps.size() == 1 ? formula(maps.front(), title) : fmt::format("{}: {} patches", title, maps.size());
    return picture;
}

const std::string& operation_of(const Answered& answered) { return *answered.request.find("op")->text(); }

/// Whether the map has a net of its own to be painted before another.
bool has_net(const Map& map) {
    const Patch* patch = patch_of(map);
    return tensor_bspline_of(map) || (patch && !patch->is_polynomial());
}

}  // namespace

bool is_surface(const Map& map) { return patch_of(map) || tensor_bspline_of(map); }

std::string surface_of_values(const Answered& answered) {
    const Map& map = answered.given();
    SurfacePicture picture = picture_of("P", {map}, answered.limits);
    const Json::Array& parameters = *answered.request.find("at")->array();
    const Json::Array& values = *answered.result().find("values")->array();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto place = place_of_value(map, parameters[i], values[i], answered.limits);
        if (place) picture.points.push_back({*place, fmt::format("P{}", point_text(parameters[i]))});
    }
    return svg_of(picture);
}

std::string surfaces_of_maps(const Answered& answered, const std::vector<Map>& results) {
    SurfacePicture picture = picture_of(operation_of(answered), results, answered.limits);
    if (answered.has_given()) {
        const Map& before = answered.given();
        if (has_net(before)) picture.before = mesh_of(before, answered.limits);
    }
    return svg_of(picture);
}

std::string surfaces_of_result(const Answered& answered, const std::vector<Map>& results) {
    return svg_of(picture_of(operation_of(answered), results, answered.limits));
}

}  // namespace blossom::protocol
