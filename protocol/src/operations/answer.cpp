#include "answer.hpp"

namespace blossom::protocol {

Answer answer_of(Map map, std::string_view cause) {
    Answer answer(Json::Object{{"map", within(cause, [&] { return to_json(map); })}});
    answer.maps.push_back(std::move(map));
    return answer;
}

Answer answer_of(std::vector<Map> maps, std::string_view cause) {
    Json::Array list;
    list.reserve(maps.size());
    for (const Map& map : maps) list.push_back(within(cause, [&] { return to_json(map); }));
    Answer answer(Json::Object{{"maps", std::move(list)}});
    answer.maps = std::move(maps);
    return answer;
}

const Map& Request::map(const Limits& limits) {
    given_.push_back(required("map", [&](const Json& value) { return read_map(value, limits); }));
    return given_.back();
}

}  // namespace blossom::protocol
