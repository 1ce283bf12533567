#include "plot.hpp"

#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "operations/listing.hpp"
#include "picture.hpp"
#include "surface_plot.hpp"

namespace blossom::protocol {

namespace {

bool is_graph(const Map& map) { return dimension_of(map) - (map.form.rational ? 1 : 0) == 1; }

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

std::string operation_name(const Answered& answered) { return *answered.request.find("op")->text(); }

void add_results(Picture& picture, const std::vector<Map>& maps, const Limits& limits) {
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::string alone = picture.layers.empty() ? "" : "after";
        const std::string name = maps.size() == 1 ? alone : fmt::format("part {}", i + 1);
        picture.layers.push_back({drawn(maps[i], std::nullopt, limits), name, false});
        picture.equal_scales = picture.equal_scales && !is_graph(maps[i]);
    }
}

}  // namespace

std::string plot_of_values(const Answered& answered) {
    const Map& map = answered.given();
    if (is_surface(map)) return surface_of_values(answered);
    Picture picture{"P", {}, {}, !is_graph(map)};
    const std::vector<Rational> parameters = read_numbers(*answered.request.find("at"), answered.limits);
    const Json::Array& values = *answered.result().find("values")->array();
    std::optional<Interval> where;
    if (!given_interval(map) && !parameters.empty()) {
        const auto [least, greatest] = std::ranges::minmax(parameters);
        where = Interval(std::min(least, Rational(0)), std::max(greatest, Rational(1)));
    }
    picture.layers.push_back({drawn(map, where, answered.limits), "", false});
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (const auto place = place_of(values[i], parameters[i], map.form))
            picture.points.push_back({*place, fmt::format("P({})", to_string(parameters[i]))});
    }
    return svg_of(picture);
}

std::string plot_of_maps(const Answered& answered) {
    const std::vector<Map>& results = answered.answer.maps;
    if (are_surfaces(results)) return surfaces_of_maps(answered, results);
    Picture picture{operation_name(answered), {}, {}, true};
    if (answered.has_given()) {
        const Map& before = answered.given();
        if (!std::holds_alternative<Samples>(before.value))
            picture.layers.push_back({drawn(before, hull(results), answered.limits), "before", true});
    }
    add_results(picture, results, answered.limits);
    return svg_of(picture);
}

std::string plot_of_result(const Answered& answered) {
    const std::vector<Map>& results = answered.answer.maps;
    if (are_surfaces(results)) return surfaces_of_result(answered, results);
    Picture picture{operation_name(answered), {}, {}, true};
    add_results(picture, results, answered.limits);
    return svg_of(picture);
}

}  // namespace blossom::protocol
