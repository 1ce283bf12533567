#include "listing.hpp"

#include <fmt/format.h>

#include "json/json_text.hpp"
#include "rounding.hpp"

namespace blossom::protocol {

namespace {

constexpr std::size_t most_arguments = 6;

/// " = p(0, 0, 1)", or nothing for a degree that would make it unreadable.
std::string label(const std::vector<std::string>& arguments) {
    if (arguments.size() > most_arguments) return "";
    std::string text;
    for (const std::string& argument : arguments) text += (text.empty() ? "" : ", ") + argument;
    return " = p(" + text + ")";
}

std::vector<std::string> plain_texts(const Json& list) {
    std::vector<std::string> texts;
    for (const Json& element : *list.array()) texts.push_back(point_text(element));
    return texts;
}

/// The arguments a, ..., a, b, ..., b of control point k, with k copies of b.
std::vector<std::string> bezier_arguments(const std::vector<std::string>& ends, std::size_t degree,
                                          std::size_t k) {
    std::vector<std::string> arguments(degree - k, ends[0]);
    arguments.insert(arguments.end(), k, ends[1]);
    return arguments;
}

std::size_t degree_of(const Json& map) { return std::stoul(map.find("degree")->number()->text); }

/// The points, one per line; `arguments(k)` are those of point k.
template <class Arguments>
std::string lines_of_points(const Json& map, const Style& style, const Arguments& arguments) {
    const std::vector<std::string> points = member_texts(map, "control_points");
    const bool weighted = map.find("weights");
    const auto weights = weighted ? member_texts(map, "weights") : std::vector<std::string>{};
    std::string text;
    for (std::size_t k = 0; k < points.size(); ++k) {
        text += fmt::format("  P{}{} = {}{}\n", k, label(arguments(k)), style.bold(points[k]),
                            weighted ? ", weight " + weights[k] : "");
    }
    return text;
}

std::string bezier_listing(const Json& map, const Style& style) {
    const std::vector<std::string> shown_ends = member_texts(map, "interval");
    const std::vector<std::string> ends = plain_texts(*map.find("interval"));
    const std::size_t degree = degree_of(map);
    return fmt::format("Control points over [{}, {}]:\n", shown_ends[0], shown_ends[1]) +
           lines_of_points(map, style, [&](std::size_t k) { return bezier_arguments(ends, degree, k); });
}

/// Of a bspline or progressive map: point k stands at n consecutive knots.
std::string window_listing(const Json& map, const Style& style) {
    const std::vector<std::string> knots = plain_texts(*map.find("knots"));
    const std::size_t degree = degree_of(map);
    const std::size_t points = map.find("control_points")->array()->size();
    const std::size_t first = knots.size() == points + degree + 1 ? 1 : 0;
    const auto arguments = [&](std::size_t k) {
        const auto begin = knots.begin() + static_cast<std::ptrdiff_t>(k + first);
        return std::vector<std::string>(begin, begin + static_cast<std::ptrdiff_t>(degree));
    };
    return fmt::format("Control points of degree {} over the knots {}:\n", degree,
                       numbers_text(*map.find("knots"))) +
           lines_of_points(map, style, arguments);
}

/// A line a control point of nested arrays, "P(0, 1) = 3".
void add_nested(std::string& text, const Json& net, const Json* weights, std::string_view name,
                const std::string& index, std::size_t depth, const Style& style) {
    const Json::Array& entries = *net.array();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string own = index + (index.empty() ? "" : ", ") + std::to_string(i);
        const Json* weight = weights ? &(*weights->array())[i] : nullptr;
        if (depth > 1) {
            add_nested(text, entries[i], weight, name, own, depth - 1, style);
            continue;
        }
        text += fmt::format("  {}({}) = {}{}\n", name, own, style.bold(point_text(entries[i])),
                            weight ? ", weight " + point_text(*weight) : "");
    }
}

}  // namespace

std::vector<ShownMap> shown_maps(const Answered& answered) {
    const std::vector<Map>& maps = answered.answer.maps;
    const Json* list = answered.result().find("maps");
    std::vector<ShownMap> shown;
    shown.reserve(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i)
        shown.push_back({maps[i], list ? (*list->array())[i] : *answered.result().find("map")});
    return shown;
}

std::string line_of(const Map& map, std::string_view name, const Style& style) {
    return "  " + style.bold(formula(map, name)) + "\n";
}

std::string net_listing(const ShownMap& shown, std::string_view name, const Style& style) {
    const Json& map = shown.json;
    std::string text = formula(shown.map, name) + ":\n";
    if (const Json* knots = map.find("knots")) {
        const Json::Array& lists = *knots->array();
        for (std::size_t d = 0; d < lists.size(); ++d)
            text += fmt::format("  knots {}: {}\n", d, numbers_text(lists[d]));
    }
    const Json& net = *map.find("control_net");
    const Json* weights = map.find("weights");
    if (const Json* degrees = map.find("degrees")) {
        add_nested(text, net, weights, name, "", degrees->array()->size(), style);
        return text;
    }
    const Json::Array& entries = *net.array();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Json::Array& pair = *entries[i].array();
        const Json* weight = weights ? &(*(*weights->array())[i].array())[1] : nullptr;
        text += fmt::format("  {}{} = {}{}\n", name, point_text(pair[0]), style.bold(point_text(pair[1])),
                            weight ? ", weight " + point_text(*weight) : "");
    }
    return text;
}

std::string listing(const ShownMap& shown, const Style& style) {
    const Json& map = shown.json;
    if (map.find("control_net")) return net_listing(shown, "P", style);
    if (std::holds_alternative<BezierCurve>(shown.map.value)) return bezier_listing(map, style);
    if (map.find("knots")) return window_listing(map, style);
    return line_of(shown.map, "P", style);
}

std::string described_listing(const Answered& answered) {
    std::string text = answered.has_given() ? description(answered.given()) + "\n\n" : "";
    bool first = true;
    for (const ShownMap& map : shown_maps(answered)) {
        text += (first ? "" : "\n") + listing(map, answered.style);
        first = false;
    }
    return text;
}

}  // namespace blossom::protocol
