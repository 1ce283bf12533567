#include <blossom/rational/place.hpp>

#include <algorithm>
#include <array>

namespace blossom {

std::string_view part_name(Part part) {
    constexpr std::array<std::string_view, 30> names = {
        "arguments",      "at",    "by",     "coefficients", "construction", "control_net",
        "control_points", "count", "degree", "directions",   "elements",     "from",
        "interval",       "knot",  "knots",  "left",         "level",        "map",
        "maps",           "nodes", "order",  "results",      "right",        "segment",
        "statement",      "times", "to",     "topic",        "values",       "vertices",
    };
    static_assert(names.size() == static_cast<std::size_t>(Part::vertices) + 1);
    return names[static_cast<std::size_t>(part)];
}

namespace {

/// The name of a step; empty for an index.
std::string_view name_of(const Place::Step& step) {
    if (const Part* part = std::get_if<Part>(&step)) return part_name(*part);
    const std::string* member = std::get_if<std::string>(&step);
    return member ? std::string_view(*member) : std::string_view();
}

bool same_step(const Place::Step& one, const Place::Step& other) {
    const auto* index = std::get_if<std::size_t>(&one);
    const auto* other_index = std::get_if<std::size_t>(&other);
    if (index || other_index) return index && other_index && *index == *other_index;
    return name_of(one) == name_of(other);
}

}  // namespace

bool Place::begins_with(const Place& outer) const {
    return outer.steps_.size() <= steps_.size() &&
           std::equal(outer.steps_.begin(), outer.steps_.end(), steps_.begin(), same_step);
}

Place Place::inside(const Place& outer) const {
    Place rest;
    if (!begins_with(outer)) return rest;
    rest.steps_.assign(steps_.begin() + static_cast<std::ptrdiff_t>(outer.steps_.size()), steps_.end());
    return rest;
}

Place Place::around(const Place& inner) const {
    Place whole = *this;
    whole.steps_.insert(whole.steps_.end(), inner.steps_.begin(), inner.steps_.end());
    return whole;
}

}  // namespace blossom
