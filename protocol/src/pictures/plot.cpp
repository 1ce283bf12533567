#include "plot.hpp"

#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>
#include <blossom/worked/render.hpp>

#include <algorithm>
#include <array>

#include "drawn_curve.hpp"
#include "maps/parameters.hpp"
#include "operations/listing.hpp"
#include "surface_picture.hpp"

namespace blossom::protocol {

namespace {

using worked::Role;

bool is_surface(const Map& map) { return !parameter_form(map).scalar; }

/// The interval on which the curve is given, or none for a polynomial in any form.
std::optional<Interval> given_interval(const Map& map) {
    const auto own = [](const auto& value) -> std::optional<Interval> {
        if constexpr (requires { own_interval(value); }) return own_interval(value);
        return std::nullopt;
    };
    return std::visit(own, map.value);
}

/// From the least to the greatest parameter of all curves that have an interval.
std::optional<Interval> hull(const std::vector<Map>& maps) {
    std::optional<Interval> all;
    for (const Map& map : maps) {
        const auto interval = given_interval(map);
        if (!interval) continue;
        const Rational& least = std::min(interval->a(), interval->b());
        const Rational& greatest = std::max(interval->a(), interval->b());
        all = all ? Interval(std::min(all->a(), least), std::max(all->b(), greatest))
                  : Interval(least, greatest);
    }
    return all;
}

/// Errors: `wrong_arity` for no map.
bool are_surfaces(const std::vector<Map>& maps) {
    if (maps.empty()) throw Error(ErrorCode::wrong_arity, "there is nothing to draw: the answer has no map");
    return is_surface(maps.front());
}

const std::string& operation_of(const Answered& answered) { return *answered.request.find("op")->text(); }

worked::Picture begun(const std::string& caption) {
    worked::Picture picture;
    picture.caption = caption;
    picture.grid = true;
    picture.width = picture_width;
    return picture;
}

std::string with_results(worked::Picture picture, const Answered& answered) {
    const std::vector<Map>& maps = answered.answer.maps;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        constexpr std::array roles{Role::control, Role::result, Role::second};
        const std::string alone = picture.curves.empty() ? "" : "after";
        const std::string name = maps.size() == 1 ? alone : fmt::format("part {}", i + 1);
        draw_curve(picture, maps[i], std::nullopt, roles[i % roles.size()], i < most_names ? name : "",
                   answered.limits);
    }
    return worked::render_svg(picture);
}

SurfacePicture surfaces(const std::string& title, const std::vector<Map>& maps, const Limits& limits) {
    SurfacePicture picture;
    for (const Map& map : maps) picture.meshes.push_back(mesh_of(map, limits));
    picture.title =
        maps.size() == 1 ? formula(maps.front(), title) : fmt::format("{}: {} patches", title, maps.size());
    return picture;
}

/// Whether the net of the map can be painted below that of the result.
bool has_net(const Map& map) {
    const auto* patch = std::get_if<Patch>(&map.value);
    return is_surface(map) && !(patch && patch->is_polynomial());
}

std::string surface_of_values(const Answered& answered, const Json::Array& values) {
    const Map& map = answered.given();
    SurfacePicture picture = surfaces("P", {map}, answered.limits);
    const Json::Array& parameters = *answered.request.find("at")->array();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto place = place_of_value(map, parameters[i], values[i], answered.limits);
        if (place) picture.points.push_back({*place, "P" + point_text(parameters[i])});
    }
    return svg_of(picture);
}

}  // namespace

std::string plot_of_values(const Answered& answered) {
    const Map& map = answered.given();
    const Json::Array& values = *answered.result().find("values")->array();
    if (is_surface(map)) return surface_of_values(answered, values);
    worked::Picture picture = begun("P");
    const std::vector<Rational> parameters = read_numbers(*answered.request.find("at"), answered.limits);
    std::optional<Interval> where;
    if (!given_interval(map) && !parameters.empty()) {
        const auto [least, greatest] = std::ranges::minmax(parameters);
        where = Interval(std::min(least, Rational(0)), std::max(greatest, Rational(1)));
    }
    draw_curve(picture, map, where, Role::control, "", answered.limits);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto place = placed(answered_point(values[i]), map.form.homogeneous, {parameters[i]});
        const auto label = parameters.size() <= most_names
                               ? worked::call("P", {worked::number(parameters[i])})
                               : worked::words("");
        if (place) picture.points.push_back({{place->x, place->y}, label, Role::result});
    }
    return worked::render_svg(picture);
}

std::string plot_of_maps(const Answered& answered) {
    const std::vector<Map>& results = answered.answer.maps;
    const Map* before = answered.has_given() ? &answered.given() : nullptr;
    if (are_surfaces(results)) {
        SurfacePicture picture = surfaces(operation_of(answered), results, answered.limits);
        if (before && has_net(*before)) picture.before = mesh_of(*before, answered.limits);
        return svg_of(picture);
    }
    worked::Picture picture = begun(operation_of(answered));
    if (before && !std::holds_alternative<Samples>(before->value))
        draw_curve(picture, *before, hull(results), Role::before, "before", answered.limits);
    return with_results(std::move(picture), answered);
}

std::string plot_of_result(const Answered& answered) {
    const std::vector<Map>& results = answered.answer.maps;
    if (are_surfaces(results)) return svg_of(surfaces(operation_of(answered), results, answered.limits));
    return with_results(begun(operation_of(answered)), answered);
}

}  // namespace blossom::protocol
