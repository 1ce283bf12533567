#include "typed_numbers.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <optional>

#include "text/characters.hpp"

namespace blossom::protocol {

namespace {

/// The number that a text is, if it is one.
std::optional<Rational> number_in(std::string_view text) {
    constexpr std::size_t longest = 40;
    const bool may_be = !text.empty() && text.size() <= longest &&
                        std::string_view("+*/^").find(text.front()) == std::string_view::npos;
    const bool is_word = may_be && text.front() >= 'A' && text.front() <= 'z';
    if (!may_be || is_word) return std::nullopt;
    try {
        return parse_rational(text);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// The text of the first number of a request that is `wanted`.
std::optional<std::string> typed(const Json& value, const Json& exact, const Rational& wanted) {
    if (const Json::Array* elements = value.array()) {
        for (std::size_t i = 0; i < elements->size(); ++i) {
            if (auto text = typed((*elements)[i], (*exact.array())[i], wanted)) return text;
        }
    } else if (const Json::Object* members = value.object()) {
        for (std::size_t i = 0; i < members->size(); ++i) {
            if ((*members)[i].first == "id") continue;
            if (auto text = typed((*members)[i].second, (*exact.object())[i].second, wanted)) return text;
        }
    } else if (value.number() || value.text()) {
        const std::string& text = value.number() ? value.number()->text : *value.text();
        const auto number = exact.exact() ? std::optional(*exact.exact()) : number_in(text);
        if (number == wanted) return text;
    }
    return std::nullopt;
}

/// The length of "-1/2" at the front of a text.
std::size_t number_length(std::string_view text) {
    const auto digits_from = [&](std::size_t begin) {
        return static_cast<std::size_t>(
            std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), is_digit) -
            text.begin());
    };
    const std::size_t begin = text.starts_with('-') ? 1 : 0;
    const std::size_t whole = digits_from(begin);
    if (whole == begin) return 0;
    const bool has_denominator = whole + 1 < text.size() && text[whole] == '/' && is_digit(text[whole + 1]);
    return has_denominator ? digits_from(whole + 1) : whole;
}

}  // namespace

std::string with_typed_numbers(std::string_view message, const Json& request, const Json& exact) {
    std::string result;
    while (!message.empty()) {
        const std::size_t length = number_length(message);
        if (length == 0) {
            result += message.front();
            message.remove_prefix(1);
            continue;
        }
        const std::string_view number = message.substr(0, length);
        result += typed(request, exact, parse_rational(number)).value_or(std::string(number));
        message.remove_prefix(length);
    }
    return result;
}

}  // namespace blossom::protocol
