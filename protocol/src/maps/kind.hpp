#pragma once

#include <blossom/core/maps/polynomial_map.hpp>

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "description/members.hpp"
#include "map.hpp"

/// What each kind of map says of itself: how it is read, written, shown to a person, and made of other
/// curves.

namespace blossom::protocol {

/// A word of the field "kind".
struct KindWord {
    std::string_view word;
    Map (*read)(Fields& fields, const Limits& limits) = nullptr;
    Members (*members)() = nullptr;       ///< its fields besides "kind"
    std::string_view documentation = "";  ///< one sentence
    std::string_view field = "";          ///< it is meant where there is this field
};

/// "bspline", or with `between` " with ", "bspline with degrees" where the field says what is meant.
inline std::string title_of(const KindWord& word, std::string_view between) {
    return std::string(word.word) + (word.field.empty() ? "" : std::string(between).append(word.field));
}

/// A field of `convert` that is read by one target only.
struct TargetField {
    std::string_view name;
    std::string_view value;  ///< what help calls its value
    std::string_view help;
    bool is_list = false;  ///< numbers, not one
};

/// How a curve that is one polynomial becomes a map of a kind: a word of the field "to" of `convert`.
struct Target {
    /// `own` is the interval of the map, or [0, 1].
    using Convert =
        std::function<AnyMap(const PolynomialMap& map, const Interval& own, const Limits& limits)>;

    std::string_view word;
    Convert (*read)(Fields& request, const Limits& limits) = nullptr;
    bool over_interval = false;  ///< whether it reads the field "interval"
    TargetField field = {};      ///< with a name, where it has one more
};

struct Kind {
    std::string_view name;  ///< what messages call it
    std::array<KindWord, 3> words;
    Json (*write)(const Map& map);
    std::string (*formula)(const Map& map, std::string_view name);
    Target target = {};  ///< with a word, where curves are converted to this kind
    std::string (*degree_text)(const Map& map) = nullptr;  ///< what its formula leaves out, ", degree 3"
};

inline const Kind& kind_of(const Map& map) { return *Kinds::all[map.value.index()]; }

/// The word in the field "kind" of a map; of several with this word the one whose field is there counts.
/// Errors: `wrong_kind`.
const KindWord& word_of(const Fields& fields, const Json& word);

/// `Kind::write` and `Kind::formula` from functions about the type of the maps.
template <class Value, Json (*write)(const Value& value, const PointForm& form)>
Json write_value(const Map& map) {
    return write(std::get<Value>(map.value), map.form);
}
template <class Value, std::string (*formula)(const Value& value, const Map& map, std::string_view name)>
std::string formula_of_value(const Map& map, std::string_view name) {
    return formula(std::get<Value>(map.value), map, name);
}

/// Weights of points, of this shape, or points that have them as their last coordinates.
Choice weights_or_homogeneous(Shape weights);

/// The fields of a curve with control points besides its knots.
Members control_point_members(FieldList others);

/// The field "interval" of a conversion.
inline std::optional<Interval> read_wanted_interval(Fields& request, const Limits& limits) {
    return request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
}

}  // namespace blossom::protocol
