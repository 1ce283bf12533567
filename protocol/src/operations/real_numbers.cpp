#include "real_numbers.hpp"

#include <fmt/format.h>
#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

#include "formats/doubles.hpp"

namespace blossom::protocol {

namespace {

/// The double nearest to the number: that of both ends of a narrow interval. None beyond the doubles.
std::optional<Json::Number> rounded_root(Root root, const Limits& limits) {
    constexpr std::size_t bits_more = 60;
    const auto bits = [](const Rational& number) {
        return std::bit_cast<std::uint64_t>(nearest_double(number));
    };
    try {
        while (bits(root.lower) != bits(root.upper)) {
            const Rational size = std::max(abs(root.lower), abs(root.upper));
            const Rational smaller = std::min(size, root.upper - root.lower);
            root = narrowed(root, smaller / Rational(Integer(1) << bits_more), limits);
        }
        return double_number(root.lower);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::overflow) throw;
        return std::nullopt;
    }
}

}  // namespace

Json::Object real_members(const Root& number, const Limits& limits) {
    Json::Object members;
    if (number.is_rational()) {
        members.emplace_back("value", number.lower);
    } else {
        members.emplace_back("interval", Json::Array{number.lower, number.upper});
    }
    if (auto rounded = rounded_root(number, limits)) members.emplace_back("double", *std::move(rounded));
    return members;
}

Json real_json(const Root& number, const Limits& limits) { return real_members(number, limits); }

Json real_json(std::span<const Root> numbers, const Limits& limits) {
    Json::Array list;
    for (const Root& number : numbers) list.push_back(real_json(number, limits));
    return list;
}

Members real_number_members(FieldList others, std::string_view what) {
    others.push_back(optional("double", ValueKind::nearest_double,
                              fmt::format("the double nearest to the {}; not there where that would be "
                                          "infinite",
                                          what)));
    return {std::move(others),
            {{{required("value", ValueKind::number, fmt::format("a rational {}", what))},
              {required("interval", ValueKind::interval,
                        fmt::format("an open interval with this {} and no other", what))}}}};
}

Shape real_shape() { return Shape::object(real_number_members({}, "number")); }

Field real_point_member() {
    return required("point", Shape::list(real_shape()), "the coordinates of the point");
}

std::string real_text(const Json& number) {
    if (const Json* value = number.find("value")) return point_text(*value);
    if (const Json* rounded = number.find("double")) return "≈ " + rounded->number()->text;
    return "in " + point_text(*number.find("interval"));
}

std::string real_equation(const Json& number, std::string_view name, const Style& style) {
    if (number.find("value")) return fmt::format("{} = {}", name, style.bold(member_text(number, "value")));
    const std::vector<std::string> ends = member_texts(number, "interval");
    const Json* rounded = number.find("double");
    return fmt::format("{} < {} < {}{}", ends[0], name, ends[1],
                       rounded ? fmt::format(", {} ≈ {}", name, rounded->number()->text) : "");
}

std::string real_point_text(const Json& point) {
    const Json::Array& coordinates = *point.array();
    if (coordinates.size() == 1) return real_text(coordinates.front());
    return "(" + joined(coordinates, real_text) + ")";
}

}  // namespace blossom::protocol
