#pragma once

#include <blossom/core/maps/polynomial_map.hpp>

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "map.hpp"

/// What each kind of map says of itself: how it is read, written, shown to a person, and made of other
/// curves.

namespace blossom::protocol {

/// A word of the field "kind".
struct KindWord {
    std::string_view word;
    Map (*read)(Fields& fields, const Limits& limits) = nullptr;
    std::string_view field = "";  ///< it is meant where there is this field
};

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
    TargetField field = {};  ///< with a name, where it has one beside "interval"
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

/// `Kind::write` and `Kind::formula` from functions about the type of the maps.
template <class Value, Json (*write)(const Value& value, const PointForm& form)>
Json write_value(const Map& map) {
    return write(std::get<Value>(map.value), map.form);
}
template <class Value, std::string (*formula)(const Value& value, const Map& map, std::string_view name)>
std::string formula_of_value(const Map& map, std::string_view name) {
    return formula(std::get<Value>(map.value), map, name);
}

/// The field "interval" of a conversion.
inline std::optional<Interval> read_wanted_interval(Fields& request, const Limits& limits) {
    return request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
}

}  // namespace blossom::protocol
