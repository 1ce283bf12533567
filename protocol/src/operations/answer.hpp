#pragma once

#include <blossom/protocol/json.hpp>

#include <string_view>
#include <utility>
#include <vector>

#include "json/fields.hpp"
#include "maps/map.hpp"

namespace blossom::protocol {

/// What an operation found, as a value: what is written as JSON, shown to a person, drawn, certified or
/// explained is all made of it.
struct Answer {
    std::vector<Map> given;  ///< field "map" of the request
    std::vector<Map> maps;   ///< the maps that are the result, in the order in which it lists them
    Json result;             ///< all of it, with exact numbers as numbers

    Answer(Json all) : result(std::move(all)) {}          // NOLINT(google-explicit-constructor)
    Answer(Json::Object all) : result(std::move(all)) {}  // NOLINT(google-explicit-constructor)
};

/// {"map": ...}. Errors: `zero_weight`, in the field `cause` of the request.
Answer answer_of(Map map, std::string_view cause = "map");
/// {"maps": [...]}, likewise.
Answer answer_of(std::vector<Map> maps, std::string_view cause = "map");

/// The members of a request, and the map that they are about, which is read once.
class Request : public Fields {
public:
    using Fields::Fields;

    /// Field "map". Errors: those of `read_map`.
    const Map& map(const Limits& limits);
    /// The map that `map` has read, for `Answer::given`; none if it was not called.
    std::vector<Map> given() && { return std::move(given_); }

private:
    std::vector<Map> given_;
};

}  // namespace blossom::protocol
