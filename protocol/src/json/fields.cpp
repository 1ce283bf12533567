#include "fields.hpp"

#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "nearest_name.hpp"

namespace blossom::protocol {

namespace {

[[noreturn]] void wrong_kind(std::string_view expected, const Json& value) {
    throw Error(ErrorCode::wrong_kind,
                "expected " + std::string(expected) + ", found " + std::string(type_name(value)));
}

bool is_integer_text(std::string_view text) { return text.find_first_of(".eE") == std::string_view::npos; }

/// An integer from 0 to the limit `most`.
std::size_t read_whole(const Json& value, const Limits& limits, std::size_t most, std::string_view name) {
    const Rational number = read_number(value, limits);
    if (!number.is_integer() || number.sign() < 0) {
        throw Error(ErrorCode::wrong_kind, to_string(number) + " is not an integer of at least 0");
    }
    const auto small = number.numerator().to_int64();
    if (!small || static_cast<std::size_t>(*small) > most) {
        throw limit_error(to_string(number) + " exceeds", name, most);
    }
    return static_cast<std::size_t>(*small);
}

}  // namespace

Fields::Fields(const Json& value) : object_(value) {
    if (!value.object()) wrong_kind("an object", value);
}

bool Fields::is_asked(std::string_view name) const {
    return std::ranges::find(asked(), name) != asked().end();
}

const Json* Fields::ask(std::string_view name) {
    const Json* member = object_.find(name);
    if (!is_asked(name)) {
        asked_.at(asked_count_++) = name;
        if (member) ++found_count_;
    }
    return member;
}

void Fields::missing(std::string_view name) const {
    std::string message = "the field \"" + std::string(name) + "\" is missing";
    const std::string_view names[] = {name};
    for (const auto& [written, value] : *object_.object()) {
        if (is_asked(written) || suggestion(written, names).empty()) continue;
        message += "; was it meant by " + quoted(written) + "?";
        break;
    }
    throw Error(ErrorCode::missing_field, message, Place{std::string(name)});
}

void Fields::finish() const {
    if (found_count_ == object_.object()->size()) return;
    for (const auto& [name, value] : *object_.object()) {
        if (is_asked(name)) continue;
        throw Error(ErrorCode::unknown_field,
                    "the field " + quoted(name) + " is not known here" + suggestion(name, asked()),
                    Place{std::string(name)});
    }
}

Rational read_number(const Json& value, const Limits& limits) {
    if (const Rational* exact = value.exact()) return *exact;  // of an answer
    if (const std::string* text = value.text()) return parse_rational(*text, limits);
    const Json::Number* number = value.number();
    if (!number) {
        throw Error(ErrorCode::not_a_number, "expected a number, found " + std::string(type_name(value)));
    }
    if (!is_integer_text(number->text)) {
        throw Error(ErrorCode::inexact_number,
                    "the JSON number " + quoted(number->text) +
                        " is not an integer; write it as a string to have it exact, or say with "
                        "\"floats\": \"decimal\" or \"double\" what the JSON numbers of the request are");
    }
    return parse_integer(number->text, limits);
}

std::size_t read_count(const Json& value, const Limits& limits) {
    return read_whole(value, limits, limits.degree, "degree");
}

std::size_t read_index(const Json& value, const Limits& limits) {
    return read_whole(value, limits, limits.numbers, "numbers");
}

bool read_boolean(const Json& value) {
    if (const bool* truth = value.boolean()) return *truth;
    wrong_kind("true or false", value);
}

const std::string& read_text(const Json& value) {
    if (const std::string* text = value.text()) return *text;
    wrong_kind("a string", value);
}

std::size_t read_alternative(const Json& value, std::span<const std::string_view> names,
                             std::string_view what) {
    const std::string& written = read_text(value);
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == written) return i;
        list += (i == 0 ? "" : ", ") + std::string(names[i]);
    }
    throw Error(ErrorCode::wrong_kind, quoted(written) + " is not " + std::string(what) +
                                           suggestion(written, names) + "; there are: " + list);
}

const Json::Array& read_array(const Json& value) {
    if (const Json::Array* elements = value.array()) return *elements;
    wrong_kind("an array", value);
}

std::vector<Rational> read_numbers(const Json& value, const Limits& limits) {
    return read_list(value, [&](const Json& element) { return read_number(element, limits); });
}

Interval read_interval(const Json& value, const Limits& limits) {
    const std::vector<Rational> ends = read_numbers(value, limits);
    if (ends.size() != 2) {
        throw Error(ErrorCode::wrong_arity, "an interval has 2 ends, not " + std::to_string(ends.size()));
    }
    return {ends[0], ends[1]};
}

Json to_json(const Interval& interval) { return Json::Array{interval.a(), interval.b()}; }

Argument read_argument(const Json& value, const Limits& limits) {
    const auto affine = [&](const Json& member, int mass) {
        return Argument(read_number(member, limits), mass);
    };
    const auto homogeneous = [&](const Json& member) {
        const std::vector<Rational> pair = read_numbers(member, limits);
        if (pair.size() == 2) return Argument(pair[0], pair[1]);
        throw Error(ErrorCode::wrong_arity, "a homogeneous argument is a pair [u, mass], not " +
                                                std::to_string(pair.size()) + " numbers");
    };
    return read_argument(value, affine, homogeneous);
}

}  // namespace blossom::protocol
