#pragma once

#include <blossom/protocol/json.hpp>

#include <string_view>
#include <utility>
#include <vector>

#include "json/fields.hpp"
#include "maps/map.hpp"

namespace blossom::protocol {

/// The result of an operation as a value. JSON, texts, pictures, certificates and
/// worked examples are made from it.
struct Answer {
    std::vector<Map> given;  ///< field "map" of the request
    std::vector<Map> maps;   ///< the maps of the result, in its order
    Json result;             ///< all of it, with exact numbers as numbers

    Answer(Json all) : result(std::move(all)) {}          // NOLINT(google-explicit-constructor)
    Answer(Json::Object all) : result(std::move(all)) {}  // NOLINT(google-explicit-constructor)
};

/// {"map": ...}. Errors: `zero_weight`, in the field `cause` of the request.
Answer answer_of(Map map, std::string_view cause = "map");
/// {"maps": [...]}, likewise.
Answer answer_of(std::vector<Map> maps, std::string_view cause = "map");

/// The members of a request, and its map, which is read once.
class Request : public Fields {
public:
    using Fields::Fields;

    /// Field "map". Errors: those of `read_map`.
    const Map& map(const Limits& limits);
    /// The map that `map` has read, for `Answer::given`; empty if `map` was not called.
    std::vector<Map> given() && { return std::move(given_); }

private:
    std::vector<Map> given_;
};

}  // namespace blossom::protocol
