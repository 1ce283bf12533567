#include "readable.hpp"

#include <fmt/format.h>
#include <blossom/core/polynomial_text.hpp>

#include "rounding.hpp"

namespace blossom::cli {

namespace {

std::string leaf_text(const Json& value) {
    if (const Rational* exact = value.exact()) return to_string(*exact);
    if (const std::string* text = value.text()) return *text;
    if (const Json::Number* number = value.number()) return number->text;
    return cli::to_text(value);
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
    std::string text;
    for (const Json& coordinate : *coordinates) text += (text.empty() ? "" : ", ") + bare_text(coordinate);
    return "(" + text + ")";
}

std::string argument_text(const Json& argument) {
    if (const Json* direction = argument.find("vector")) {
        const std::string value = leaf_text(*direction);
        return value == "1" ? "delta" : "vector " + value;
    }
    if (const Json* pair = argument.find("homogeneous")) return bare_text(*pair);
    return leaf_text(argument);
}

std::string tuple_of_polynomials(const PolynomialCurve& curve, std::size_t first, std::size_t last,
                                 bool scalar, std::string_view variable) {
    std::string text;
    for (std::size_t j = first; j < last; ++j) {
        text += (j == first ? "" : ", ") + blossom::to_text(curve.coordinate(j), variable);
    }
    return scalar ? text : "(" + text + ")";
}

std::string polynomial_text(const PolynomialCurve& curve, const PointForm& form, std::string_view variable) {
    const std::size_t dimension = curve.dimension();
    if (!form.rational || form.homogeneous)
        return tuple_of_polynomials(curve, 0, dimension, form.scalar, variable);
    const std::string numerators = tuple_of_polynomials(curve, 0, dimension - 1, form.scalar, variable);
    return fmt::format("{} / ({})", form.scalar ? "(" + numerators + ")" : numerators,
                       blossom::to_text(curve.coordinate(dimension - 1), variable));
}

std::string polygon_text(const BezierCurve& curve, const PointForm& form) {
    const Json map = to_json({curve, form, "t"});
    std::string text;
    for (const std::string& point : member_texts(map, "control_points"))
        text += (text.empty() ? "" : ", ") + point;
    if (map.find("weights")) {
        text += ", weights ";
        std::string weights;
        for (const std::string& weight : member_texts(map, "weights")) {
            weights += (weights.empty() ? "" : ", ") + weight;
        }
        text += weights;
    }
    return text;
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

std::string arguments_text(const Json& arguments) {
    std::string text;
    for (const Json& argument : *arguments.array())
        text += (text.empty() ? "" : ", ") + argument_text(argument);
    return text;
}

std::string formula(const Map& map, std::string_view name) {
    if (const auto* curve = std::get_if<PolynomialCurve>(&map.curve)) {
        return fmt::format("{}({}) = {}", name, map.variable,
                           polynomial_text(*curve, map.form, map.variable));
    }
    const auto& curve = std::get<BezierCurve>(map.curve);
    return fmt::format("{}: control points over [{}, {}]: {}", name, to_string(curve.interval().a()),
                       to_string(curve.interval().b()), polygon_text(curve, map.form));
}

std::string description(const Map& map) {
    return fmt::format("{}, {}degree {}{}", formula(map, "P"),
                       std::holds_alternative<PolynomialCurve>(map.curve) ? "formal " : "", degree_of(map),
                       map.form.homogeneous ? ", points with their weight last" : "");
}

}  // namespace blossom::cli
