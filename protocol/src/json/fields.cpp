#include "fields.hpp"

#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <bit>

#include "nearest_name.hpp"

namespace blossom::protocol {

namespace {

[[noreturn]] void wrong_kind(std::string_view expected, const Json& value) {
    throw Error(ErrorCode::wrong_kind,
                "expected " + std::string(expected) + ", found " + std::string(type_name(value)));
}

const Json::Object& read_object(const Json& value) {
    if (const Json::Object* members = value.object()) return *members;
    wrong_kind("an object", value);
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

Fields::Fields(const Json& value) : members_(read_object(value)) {}

bool Fields::is_asked(std::string_view name) const {
    return std::ranges::find(asked(), name) != asked().end();
}

std::size_t Fields::index_of(std::string_view name) const {
    // Mostly members are asked for in their order.
    for (std::size_t i = next_; i < members_.size(); ++i)
        if (members_[i].first == name) return i;
    for (std::size_t i = 0; i < next_; ++i)
        if (members_[i].first == name) return i;
    return members_.size();
}

const Json* Fields::ask(std::string_view name) {
    asked_.at(asked_count_++) = name;
    const std::size_t i = index_of(name);
    if (i == members_.size()) return nullptr;
    if (i < 64) found_ |= std::uint64_t{1} << i;
    next_ = i + 1;
    return &members_[i].second;
}

void Fields::missing(std::string_view name) const {
    std::string message = "the field \"" + std::string(name) + "\" is missing";
    const std::string_view names[] = {name};
    for (const auto& [written, value] : members_) {
        if (is_asked(written) || suggestion(written, names).empty()) continue;
        message += "; was it meant by " + quoted(written) + "?";
        break;
    }
    throw Error(ErrorCode::missing_field, message, Place{std::string(name)});
}

void Fields::finish() const {
    if (static_cast<std::size_t>(std::popcount(found_)) == members_.size()) return;
    for (const auto& [name, value] : members_) {
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

namespace {

/// The two ends, each through `read`.
template <class Read>
auto read_ends(const Json& value, const Read& read) {
    auto ends = read_list(value, read);
    if (ends.size() == 2) return std::pair(std::move(ends[0]), std::move(ends[1]));
    throw Error(ErrorCode::wrong_arity, "an interval has 2 ends, not " + std::to_string(ends.size()));
}

/// An end of a range: 1 and -1 stand for the two infinities.
struct RangeEnd {
    int infinity = 0;
    std::optional<Rational> number = {};
};

RangeEnd read_range_end(const Json& value, const Limits& limits) {
    const std::string* text = value.text();
    if (text && *text == "inf") return {1};
    if (text && *text == "-inf") return {-1};
    return {0, read_number(value, limits)};
}

}  // namespace

Interval read_interval(const Json& value, const Limits& limits) {
    const auto [a, b] = read_ends(value, [&](const Json& end) { return read_number(end, limits); });
    return {a, b};
}

ParameterRange read_range(const Json& value, const Limits& limits) {
    auto [first, last] = read_ends(value, [&](const Json& end) { return read_range_end(end, limits); });
    if (first.infinity > last.infinity) std::swap(first, last);
    if (first.number && last.number) return Interval(*first.number, *last.number);
    if (first.infinity == last.infinity) {
        throw Error(ErrorCode::empty_interval, "an interval from an infinity to the same is empty");
    }
    return {std::move(first.number), std::move(last.number)};
}

Json to_json(const ParameterRange& range) {
    return Json::Array{range.lower ? Json(*range.lower) : Json("-inf"),
                       range.upper ? Json(*range.upper) : Json("inf")};
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
