#include "floats.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "formats/doubles.hpp"
#include "json/fields.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view kept[] = {"id", "computed", "document"};

/// The value with convert(leaf) for each value in it that is no container; members that `is_kept` names stay.
template <class IsKept, class Convert>
Json converted(const Json& value, const IsKept& is_kept, const Convert& convert) {
    if (value.array()) {
        return read_list(value, [&](const Json& element) { return converted(element, is_kept, convert); });
    }
    const Json::Object* members = value.object();
    if (!members) return convert(value);
    Json::Object result;
    result.reserve(members->size());
    for (const auto& [name, member] : *members) {
        within(name, [&] {
            result.emplace_back(name, is_kept(name) ? member : converted(member, is_kept, convert));
        });
    }
    return result;
}

/// Whether a JSON number is an integer, and a double as well.
bool is_short_integer(std::string_view text) {
    constexpr std::size_t most_digits = 15;
    return text.size() <= most_digits && text.find_first_of(".eE") == std::string_view::npos;
}

/// The value of a text that is a number; the text otherwise.
Json number_or_text(const Json& value, const Limits& limits) {
    try {
        return parse_rational(*value.text(), limits);
    } catch (const Error& error) {
        if (error.code() == ErrorCode::not_a_number) return value;
        throw;
    }
}

}  // namespace

std::vector<std::string_view> floats_names() { return {"decimal", "double"}; }

Floats read_floats(const Json& value) {
    constexpr Floats floats[] = {Floats::decimal, Floats::binary64};
    return floats[read_alternative(value, floats_names(), "a reading of JSON numbers")];
}

std::optional<Json> with_exact_floats(const Json& request, const Limits& limits) {
    const Json* written = request.find("floats");
    if (!written) return std::nullopt;
    const Floats floats = within("floats", [&] { return read_floats(*written); });
    const auto is_kept = [](std::string_view name) {
        return std::ranges::find(kept, name) != std::end(kept);
    };
    return converted(request, is_kept, [&](const Json& value) -> Json {
        const Json::Number* number = value.number();
        if (!number || is_short_integer(number->text)) return value;
        if (floats == Floats::binary64) return read_double(value);
        return parse_rational(number->text, limits);
    });
}

Json with_decimals(const Json& value, const Limits& limits) {
    const auto keep_none = [](std::string_view) { return false; };
    return converted(value, keep_none, [&](const Json& leaf) -> Json {
        if (const Json::Number* number = leaf.number()) return parse_rational(number->text, limits);
        return leaf.text() ? number_or_text(leaf, limits) : leaf;
    });
}

}  // namespace blossom::protocol
