#pragma once

#include <blossom/core/maps/polynomial_map.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "description/members.hpp"
#include "map.hpp"

/// The description of a kind of map: how it is read, written and shown to a person, and how it is made of
/// other curves.

namespace blossom::protocol {

/// A value of the field "kind".
struct KindWord {
    std::string_view word;
    Map (*read)(Fields& fields, const Limits& limits) = nullptr;
    Members (*members)() = nullptr;       ///< its fields besides "kind"
    std::string_view documentation = "";  ///< one sentence
    std::string_view field = "";          ///< a field that only this kind has
};

/// "bspline", or "bspline with degrees" if `between` is " with " and a field identifies the kind.
inline std::string title_of(const KindWord& word, std::string_view between) {
    return std::string(word.word) + (word.field.empty() ? "" : std::string(between).append(word.field));
}

/// A field of `convert` that is read by one target only.
struct TargetField {
    std::string_view name;
    std::string_view value;  ///< the name of its value in the help
    std::string_view help;
    bool is_list = false;     ///< numbers, not one
    bool has_points = false;  ///< a number for a curve, a point for a patch
};

/// How a curve that is one polynomial becomes a map of this kind: a value of the field "to" of `convert`.
struct Target {
    /// `own` is the interval of the map, or [0, 1].
    using Convert =
        std::function<AnyMap(const PolynomialMap& map, const Interval& own, const Limits& limits)>;

    std::string_view word;
    Convert (*read)(Fields& request, const Limits& limits) = nullptr;
    bool over_interval = false;  ///< whether it reads the field "interval"
    TargetField field = {};      ///< named if the target has a field of its own
};

struct Kind {
    std::string_view name;          ///< its name in messages, or those of its maps
    std::array<KindWord, 4> words;  ///< see `words_of`
    Json (*write)(const Map& map);
    std::string (*formula)(const Map& map, std::string_view name);
    Target target = {};                                     ///< named if curves can be converted to this kind
    std::string (*degree_text)(const Map& map) = nullptr;   ///< what its formula does not show, ", degree 3"
    std::string_view (*name_of)(const Map& map) = nullptr;  ///< where its maps have several names
};

inline const Kind& kind_of(const Map& map) { return *Kinds::all[map.value.index()]; }

/// What the map is called in messages.
inline std::string_view name_of(const Map& map) {
    const Kind& kind = kind_of(map);
    return kind.name_of ? kind.name_of(map) : kind.name;
}

/// The words of a kind, without the empty ones that fill its array.
constexpr std::span<const KindWord> words_of(const Kind& kind) {
    return {kind.words.begin(), std::ranges::find(kind.words, std::string_view(), &KindWord::word)};
}

/// The kind that the field "kind" of a map names; among several with this name, the one whose field is
/// present. Errors: `wrong_kind`.
const KindWord& word_of(const Fields& fields, const Json& word);

/// `Kind::write` and `Kind::formula` made from functions on the type of the maps.
template <class Value, Json (*write)(const Value& value, const PointForm& form)>
Json write_value(const Map& map) {
    return write(std::get<Value>(map.value), map.form);
}
template <class Value, std::string (*formula)(const Value& value, const Map& map, std::string_view name)>
std::string formula_of_value(const Map& map, std::string_view name) {
    return formula(std::get<Value>(map.value), map, name);
}

/// The fields for weights of this shape, or for points with the weight as last coordinate.
Choice weights_or_homogeneous(Shape weights);

/// A list, which may be written as a text in a request: see `read_written_list`.
Shape written_list(ValueKind element, std::size_t least = 0);

/// The fields of a curve with control points besides its knots.
Members control_point_members(FieldList others);

/// The field "interval" of a conversion.
inline std::optional<Interval> read_wanted_interval(Fields& request, const Limits& limits) {
    return request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
}

}  // namespace blossom::protocol
