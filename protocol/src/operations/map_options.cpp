#include "map_options.hpp"

#include <blossom/rational/lists.hpp>

#include <algorithm>

#include "formats/svg_path.hpp"
#include "given_answers.hpp"
#include "json/json_text.hpp"

namespace blossom::protocol {

namespace {

Json argument(std::string_view text) {
    constexpr std::string_view vector = "vector:";
    constexpr std::string_view pair = "pair:";
    if (text == "delta") return Json::Object{{"vector", "1"}};
    if (text.starts_with(vector)) return Json::Object{{"vector", text.substr(vector.size())}};
    if (!text.starts_with(pair)) return text;
    Json::Array numbers;
    for (std::string& number : split(text.substr(pair.size()), ':')) numbers.emplace_back(std::move(number));
    return Json::Object{{"homogeneous", std::move(numbers)}};
}

/// "1,2", "vector:1,0" or "pair:1,0,2".
Json point_argument(std::string_view text) {
    for (const auto& [prefix, member] : {std::pair{"vector:", "vector"}, {"pair:", "homogeneous"}}) {
        if (text.starts_with(prefix)) {
            return Json::Object{{member, number_list(text.substr(std::string_view(prefix).size()))}};
        }
    }
    return number_list(text);
}

/// Numbers as texts.
Json texts_of(const Json& numbers) {
    if (const Rational* number = numbers.exact()) return to_string(*number);
    Json::Array texts;
    for (const Json& element : *numbers.array()) texts.push_back(texts_of(element));
    return texts;
}

void apply_polynomial(Json& request, const std::vector<std::string>& values, const Limits&) {
    request["map"]["kind"] = "polynomial";
    request["map"]["text"] = polynomial_texts(values);
}

/// The control points of the one curve of an SVG path, and its weights.
void write_path(Json& map, std::string_view path, const Limits& limits) {
    const std::vector<Map> curves = svg_path_curves(path, Floats::decimal, limits);
    if (curves.size() != 1) {
        throw UsageError("the path has " + std::to_string(curves.size()) +
                         " curves, and one is expected; import --format svg reads them all");
    }
    const Json curve = to_json(curves.front());
    for (const char* field : {"control_points", "weights"}) {
        if (const Json* numbers = curve.find(field)) map[field] = texts_of(*numbers);
    }
}

void apply_control_points(Json& request, const std::vector<std::string>& values, const Limits& limits) {
    if (request.find("map"))
        throw UsageError("a map is given by a polynomial or by --control-points, not by both");
    request["map"]["kind"] = "bezier";
    if (is_svg_path(values.front())) {
        write_path(request["map"], values.front(), limits);
    } else {
        request["map"]["control_points"] = number_list(values.front());
    }
}

/// Knots make a B-spline of control points.
void apply_knots(Json& request, const std::vector<std::string>& values, const Limits&) {
    if (!has_control_points(request)) throw UsageError("--knots needs --control-points");
    request["map"]["kind"] = "bspline";
    request["map"]["knots"] = number_list(values.front());
}

/// The map of this index; without one, the only map.
Json the_map(std::vector<Json> maps, const std::optional<Json>& index) {
    if (!index && maps.size() == 1) return std::move(maps.front());
    const std::string last = std::to_string(maps.empty() ? 0 : maps.size() - 1);
    if (!index) {
        throw UsageError("there are " + std::to_string(maps.size()) +
                         " maps, and one is expected; --map-index chooses it, from 0 to " + last);
    }
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (index->number() && index->number()->text == std::to_string(i)) return std::move(maps[i]);
    }
    throw UsageError("--map-index is not one of the maps, from 0 to " + last);
}

void apply_map(Json& request, const std::vector<std::string>& values, const Limits& limits) {
    const Json* begun = request.find("map");
    const std::optional<Json> index = begun && !begun->object() ? std::optional<Json>(*begun) : std::nullopt;
    if (begun && !index) {
        throw UsageError(
            "a map is given by a polynomial, by --control-points or by --map, not by two of them");
    }
    request["map"] = the_map(maps_in(parse_json(values.front(), limits)), index);
}

/// Which of several maps --map takes.
void apply_map_index(Json& request, const std::vector<std::string>& values, const Limits&) {
    if (request.find("map")) throw UsageError("--map-index belongs to --map");
    request["map"] = count(values.front());
}

/// An option that adds a field to the map that another option has begun.
Option map_option(std::string name, const std::string& field, std::string value, std::string help,
                  Json (*read)(std::string_view text)) {
    const auto apply = [name, field, read](Json& request, const std::vector<std::string>& values,
                                           const Limits&) {
        const Json* map = request.find("map");
        if (!map || !map->object()) throw UsageError(name + " needs a map: a polynomial or --control-points");
        request["map"][field] = values.empty() ? Json(true) : read(values.front());
    };
    return {std::move(name), Place{"map", field}, std::move(value), std::move(help), apply};
}

std::vector<Option> map_options() {
    return {
        {"POLYNOMIAL",
         {"map"},
         "TEXT",
         "a polynomial, \"1 + 2t\"; for a point-valued map one per coordinate, repeated or separated by ';'",
         apply_polynomial},
        {"--control-points",
         {"map", "control_points"},
         "P0;P1;...",
         "the control points of a Bezier curve, \"0,0; 1,2; 3,0\"",
         apply_control_points},
        {"--knots",
         {"map", "knots"},
         "T0,T1,...",
         "with --degree: makes the control points those of a B-spline over these knots",
         apply_knots},
        {"--map-index", {"map"}, "N", "with --map: which of several maps it takes, from 0", apply_map_index},
        {"--map",
         {"map"},
         "JSON",
         "any map of the protocol, or the --json output of another command",
         apply_map},
        map_option("--variables", "variables", "X,Y,...", "makes the polynomial one in several variables",
                   number_list),
        map_option("--degrees", "degrees", "M,N,...",
                   "one formal degree per variable: a tensor product instead of a total degree", number_list),
        map_option("--degree", "degree", "N", "the formal degree; by default the actual one", count),
        map_option("--denominator", "denominator", "TEXT",
                   "makes the polynomial the numerator of a rational map", plain_text),
        map_option("--weights", "weights", "W0,W1,...", "the weights of the control points", number_list),
        map_option("--interval", "interval", "A,B",
                   "the interval of the given control points; by default 0,1", number_list),
        map_option("--homogeneous", "homogeneous", "", "points carry their weight as their last coordinate",
                   nullptr),
    };
}

}  // namespace

Json argument_list(std::string_view text) {
    Json::Array arguments;
    for (const std::string& part : split(text, ',')) arguments.push_back(argument(part));
    return arguments;
}

Json count(std::string_view text) {
    const bool digits =
        !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
    return digits ? Json(Json::Number{std::string(text)}) : Json(text);
}

Json plain_text(std::string_view text) { return text; }

Json polynomial_texts(const std::vector<std::string>& values) {
    if (values.size() == 1 && values.front().find(';') == std::string::npos) return values.front();
    Json::Array texts;
    for (const std::string& value : values) {
        for (std::string& text : split(value, ';')) texts.emplace_back(std::move(text));
    }
    return texts;
}

Option field_option(std::string name, const std::string& field, std::string value,
                    Json (*read)(std::string_view text), std::string help) {
    const auto apply = [field, read](Json& request, const std::vector<std::string>& values,
                                     const Limits& limits) {
        auto list = list_in_answer(values.front(), field, limits);
        request[field] = list ? *std::move(list) : read(values.front());
    };
    return {std::move(name), Place{field}, std::move(value), std::move(help), apply};
}

Option field_option(std::string name, const std::string& field, std::string value,
                    Json (*read)(std::string_view text),
                    Json (*read_patch)(std::string_view text, const Json& map), std::string help) {
    const auto apply = [field, read, read_patch](Json& request, const std::vector<std::string>& values,
                                                 const Limits& limits) {
        const std::string& text = values.front();
        auto list = list_in_answer(text, field, limits);
        request[field] = list                 ? *std::move(list)
                         : has_patch(request) ? read_patch(text, *request.find("map"))
                                              : read(text);
    };
    return {std::move(name), Place{field}, std::move(value), std::move(help), apply};
}

Option word_option(std::string name, const std::string& field) {
    return field_option(std::move(name), field, "", plain_text);
}

Option flag_option(std::string name, const std::string& field) {
    const auto apply = [field](Json& request, const std::vector<std::string>&, const Limits&) {
        request[field] = true;
    };
    return {std::move(name), Place{field}, "", "", apply};
}

std::vector<Option> completed(std::vector<Option> options, const Members& request) {
    const FieldList fields = all_fields(request);
    for (Option& option : options) {
        const auto field = std::ranges::find_if(
            fields, [&](const Field& one) { return option.field == Place{std::string(one.name)}; });
        if (field == fields.end()) continue;
        if (option.help.empty()) option.help = field->documentation;
        if (option.value.empty()) option.value = joined(field->shape.alternatives(), {}, "|");
    }
    return options;
}

std::vector<Option> with_map_options(std::vector<Option> others) {
    std::vector<Option> options;
    for (Option& option : map_options()) {
        const bool replaced = std::ranges::find(others, option.name, &Option::name) != others.end();
        if (!replaced) options.push_back(std::move(option));
    }
    std::ranges::move(others, std::back_inserter(options));
    return options;
}

Json curve_of_text(std::string_view text, const Limits& limits) {
    const std::string_view content = trimmed(text);
    if (content.starts_with('{')) {
        const Json given = parse_json(content, limits);
        const Json* of_response = at_place(given, {"result", "map"});
        return of_response ? *of_response : given;
    }
    const bool is_path = is_svg_path(content);
    if (!is_path && content.find(',') == std::string_view::npos)
        return Json::Object{{"kind", "polynomial"}, {"text", polynomial_texts({std::string(content)})}};
    Json map = Json::Object{{"kind", "bezier"}};
    if (is_path) {
        write_path(map, content, limits);
    } else {
        map["control_points"] = number_list(content);
    }
    return map;
}

Option other_map_option(std::string name, const std::string& field) {
    const auto apply = [field](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        request[field] = curve_of_text(values.front(), limits);
    };
    return {std::move(name), Place{field}, "MAP", "", apply};
}

Option other_maps_option(std::string name, const std::string& field) {
    const auto apply = [field](Json& request, const std::vector<std::string>& values, const Limits& limits) {
        Json::Array maps;
        for (const std::string& value : values) maps.push_back(curve_of_text(value, limits));
        request[field] = std::move(maps);
    };
    return {.name = std::move(name),
            .field = Place{field},
            .value = "MAP",
            .help = "",
            .apply = apply,
            .repeated = true};
}

Option own_interval_option(std::string help) {
    const auto apply = [](Json& request, const std::vector<std::string>& values, const Limits&) {
        Json& owner = has_control_points(request) && !has_knots(request) ? request["map"] : request;
        owner["interval"] = number_list(values.front());
    };
    return {.name = "--interval",
            .field = {"interval"},
            .value = "A,B",
            .help = std::move(help),
            .apply = apply,
            .of_map = true};
}

Option wanted_degrees_option() {
    const auto apply = [](Json& request, const std::vector<std::string>& values, const Limits&) {
        const Json* map = request.find("map");
        Json& owner = map && map->find("text") ? request["map"] : request;
        owner["degrees"] = number_list(values.front());
    };
    return {
        .name = "--degrees",
        .field = {"degrees"},
        .value = "M,N,...",
        .help =
            "for a polynomial, one formal degree per variable; for a patch given by --map, the new degrees",
        .apply = apply,
        .of_map = true};
}

Json place_of_division(std::string_view text, const Json&) {
    if (text == "midpoints") return text;
    Json parameters = number_list(text);
    for (Json& parameter : *parameters.array()) {
        if (*parameter.text() == "-") parameter = Json();
    }
    return parameters;
}

bool has_control_points(const Json& request) {
    const Json* map = request.find("map");
    return map && map->find("control_points");
}

bool has_patch(const Json& request) {
    const Json* map = request.find("map");
    if (!map) return false;
    const Json* kind = map->find("kind");
    const std::string* name = kind ? kind->text() : nullptr;
    return map->find("variables") || map->find("control_net") ||
           (name && (*name == "tensor" || *name == "simplex"));
}

bool is_tensor(const Json& map) { return map.find("degrees") != nullptr; }

Json patch_parameters(std::string_view text, const Json&) { return tuple_list(text); }

Json patch_arguments(std::string_view text, const Json& map) {
    Json::Array arguments;
    for (const std::string& part : split(text, ';')) {
        if (is_tensor(map)) {
            arguments.push_back(argument_list(part));
        } else if (!part.empty()) {
            arguments.push_back(point_argument(part));
        }
    }
    return arguments;
}

bool has_knots(const Json& request) {
    return has_control_points(request) && request.find("map")->find("knots");
}

}  // namespace blossom::protocol
