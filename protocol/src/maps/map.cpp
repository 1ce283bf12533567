#include "map.hpp"

#include <blossom/rational/number_text.hpp>

#include "json/nearest_name.hpp"
#include "kind.hpp"

namespace blossom::protocol {

namespace {

using ReadMap = Map (*)(Fields& fields, const Limits& limits);

/// Of several kinds with the word in question, the one whose field is there counts. Errors: `wrong_kind`.
ReadMap reader(const Fields& fields, const Json& value) {
    const std::string& written = read_text(value);
    std::vector<std::string_view> names;
    std::string list;
    ReadMap found = nullptr;
    for (const Kind* kind : Kinds::all) {
        for (const auto& [word, read, field] : kind->words) {
            if (word == written && (field.empty() ? !found : fields.has(field))) found = read;
            if (word.empty() || !field.empty()) continue;
            names.push_back(word);
            list += (list.empty() ? "" : ", ") + std::string(word);
        }
    }
    if (found) return found;
    throw Error(ErrorCode::wrong_kind, "the kind of map " + quoted(written) + " is not known" +
                                           suggestion(written, names) + "; known are: " + list);
}

}  // namespace

std::size_t dimension_of(const Map& map) {
    return std::visit([](const auto& value) { return value.dimension(); }, map.value);
}

Map read_map(const Json& value, const Limits& limits) {
    Fields fields(value);
    const ReadMap read = fields.required("kind", [&](const Json& word) { return reader(fields, word); });
    Map map = read(fields, limits);
    fields.finish();
    return map;
}

Json to_json(const Map& map) { return kind_of(map).write(map); }

std::string formula(const Map& map, std::string_view name) { return kind_of(map).formula(map, name); }

std::string description(const Map& map) {
    const Kind& kind = kind_of(map);
    return formula(map, "P") + (kind.degree_text ? kind.degree_text(map) : "") +
           (map.form.homogeneous ? ", points with their weight last" : "");
}

}  // namespace blossom::protocol
