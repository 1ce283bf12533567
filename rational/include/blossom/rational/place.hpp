#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace blossom {

/// The parameters of the library's functions at which errors can lie.
enum class Part {
    arguments,
    at,
    by,
    coefficients,
    construction,
    control_net,
    control_points,
    count,
    degree,
    directions,
    elements,
    from,
    interval,
    knot,
    knots,
    left,
    level,
    map,
    maps,
    nodes,
    order,
    results,
    right,
    segment,
    statement,
    times,
    to,
    topic,
    values,
    vertices,
};

/// The name of the parameter in the declarations, for instance "control_points".
std::string_view part_name(Part part);

/// The place of an error in the input: the steps that lead to it from what was read or called. No steps mean
/// the whole input.
///
/// Functions of the library write `Part::arguments / f / i`. Only a reader of documents, whose members have
/// their own names, writes those names: `Place{"map", "kind"}`. A member with the name of a parameter is the
/// same step as the parameter.
class Place {
public:
    /// A parameter, an index into a list, or the name of a member of a document.
    using Step = std::variant<Part, std::size_t, std::string>;

    Place() = default;
    Place(Part part) : steps_{part} {}  // NOLINT(google-explicit-constructor)
    Place(std::initializer_list<Step> steps) : steps_(steps) {}

    const std::vector<Step>& steps() const { return steps_; }
    bool empty() const { return steps_.empty(); }

    bool begins_with(const Place& outer) const;
    /// The same place relative to `outer`, or the whole of it if this place does not lie in it.
    Place inside(const Place& outer) const;
    /// The place `inner`, which is relative to this place, relative to the same origin as this place.
    Place around(const Place& inner) const;

    friend bool operator==(const Place& one, const Place& other) {
        return one.steps_.size() == other.steps_.size() && one.begins_with(other);
    }

private:
    std::vector<Step> steps_;
};

inline Place operator/(Part outer, std::size_t index) { return {outer, index}; }
inline Place operator/(const Place& outer, std::size_t index) { return outer.around({index}); }
inline Place operator/(const Place& outer, Part part) { return outer.around(part); }
inline Place operator/(const Place& outer, std::string member) { return outer.around({std::move(member)}); }

}  // namespace blossom
