#include "map.hpp"

#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>

#include "json/nearest_name.hpp"
#include "kind.hpp"

namespace blossom::protocol {

const KindWord& word_of(const Fields& fields, const Json& word) {
    const std::string& written = read_text(word);
    const KindWord* found = nullptr;
    for (const Kind* kind : Kinds::all) {
        for (const KindWord& one : words_of(*kind)) {
            if (one.word == written && (one.field.empty() ? !found : fields.has(one.field))) found = &one;
        }
    }
    if (found) return *found;
    std::vector<std::string_view> names;
    for (const Kind* kind : Kinds::all) {
        for (const KindWord& one : words_of(*kind)) {
            if (one.field.empty()) names.push_back(one.word);
        }
    }
    throw Error(ErrorCode::wrong_kind, "the kind of map " + quoted(written) + " is not known" +
                                           suggestion(written, names) + "; known are: " + joined(names));
}

std::size_t dimension_of(const Map& map) {
    return std::visit([](const auto& value) { return value.dimension(); }, map.value);
}

Choice weights_or_homogeneous(Shape weights) {
    return {{homogeneous_field()},
            {optional("weights", std::move(weights),
                      "one number per control point, none of them 0: the map is rational"),
             optional("homogeneous", ValueKind::no, "")}};
}

Shape written_list(ValueKind element, std::size_t least) {
    return Shape::one_of({Shape::list(element, least), ValueKind::list_text});
}

Members control_point_members(FieldList others) {
    others.insert(others.begin(),
                  required("control_points", written_list(ValueKind::point, 1), "the control points"));
    return {std::move(others), {weights_or_homogeneous(Shape::list(ValueKind::number, 1))}};
}

Map read_map(const Json& value, const Limits& limits) {
    Fields fields(value);
    const KindWord& word =
        fields.required("kind", [&](const Json& kind) -> const KindWord& { return word_of(fields, kind); });
    Map map = word.read(fields, limits);
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
