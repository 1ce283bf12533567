#include "readable.hpp"

#include <fmt/format.h>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "rounding.hpp"

namespace blossom::protocol {

namespace {

std::string leaf_text(const Json& value) {
    if (const Rational* exact = value.exact()) return to_string(*exact);
    if (const std::string* text = value.text()) return *text;
    if (const Json::Number* number = value.number()) return number->text;
    return protocol::to_text(value);
}

const Json* rounded_twin(const Json& result, std::string_view name) {
    for (const Rounding rounding : {Rounding::binary64, Rounding::hexadecimal}) {
        if (const Json* twin = result.find(std::string(name) + std::string(rounding_suffix(rounding))))
            return twin;
    }
    return nullptr;
}

std::string bare_text(const Json& point) {
    const Json::Array* coordinates = point.array();
    if (!coordinates) return leaf_text(point);
    const std::string text =
        joined(*coordinates, [&](const Json& coordinate) { return bare_text(coordinate); });
    return "(" + text + ")";
}

std::string argument_text(const Json& argument) {
    if (const Json::Array* list = argument.array()) {
        return "(" + joined(*list, argument_text) + ")";
    }
    if (const Json* direction = argument.find("vector")) {
        const std::string value = bare_text(*direction);
        return value == "1" ? "delta" : "vector " + value;
    }
    if (const Json* pair = argument.find("homogeneous")) return bare_text(*pair);
    return leaf_text(argument);
}

}  // namespace

std::string Style::in(std::string_view code, std::string_view text) const {
    return coloured_ ? fmt::format("\033[{}m{}\033[0m", code, text) : std::string(text);
}

std::string point_text(const Json& point, const Json* twin) {
    return twin ? bare_text(point) + " ≈ " + bare_text(*twin) : bare_text(point);
}

std::string member_text(const Json& result, std::string_view name) {
    return point_text(*result.find(name), rounded_twin(result, name));
}

std::vector<std::string> member_texts(const Json& result, std::string_view name) {
    const Json* twins = rounded_twin(result, name);
    std::vector<std::string> texts;
    const Json::Array& points = *result.find(name)->array();
    texts.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        texts.push_back(point_text(points[i], twins ? &(*twins->array())[i] : nullptr));
    }
    return texts;
}

std::string parameter_text(const Json& parameter) {
    return parameter.array() ? bare_text(parameter) : "(" + bare_text(parameter) + ")";
}

std::string arguments_text(const Json& arguments) { return joined(*arguments.array(), argument_text); }

std::string table_text(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t j = 0; j < row.size(); ++j) widths[j] = std::max(widths[j], row[j].size());
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t j = 0; j < row.size(); ++j) text += fmt::format("  {:>{}}", row[j], widths[j]);
        text += "\n";
    }
    return text;
}

}  // namespace blossom::protocol
