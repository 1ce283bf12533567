#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shape.hpp"

/// How fields of requests and of maps, and members of results are described.

namespace blossom::protocol {

enum class Presence {
    required,
    optional,
    defaulted,  ///< may be left out of a request, and stands in every result
};

/// A field of a request or of a map, or a member of a result.
struct Field {
    std::string_view name;
    Shape shape;
    Presence presence;
    std::string documentation;
};

inline Field required(std::string_view name, Shape shape, std::string documentation) {
    return {name, std::move(shape), Presence::required, std::move(documentation)};
}
inline Field optional(std::string_view name, Shape shape, std::string documentation) {
    return {name, std::move(shape), Presence::optional, std::move(documentation)};
}
inline Field defaulted(std::string_view name, Shape shape, std::string documentation) {
    return {name, std::move(shape), Presence::defaulted, std::move(documentation)};
}

using FieldList = std::vector<Field>;

/// Several sets of fields of which an object has one.
using Choice = std::vector<FieldList>;

/// The members of an object.
struct Members {
    FieldList fields;
    std::vector<Choice> choices = {};
    bool some = false;  ///< at least one is there, where all are optional
};

/// All fields, each name once, with every shape that it has in one of the choices. Those that may be left out
/// are last.
FieldList all_fields(const Members& members);
/// When a field must be there: "yes", "no", or what it stands together with.
std::string presence_text(const Members& members, std::string_view name);

/// The JSON Schema of an object with these members after those in `first`, which are required; null where no
/// result has such an object.
Json object_schema(const Members& members, Side side, const Json::Object& first = {});

}  // namespace blossom::protocol
