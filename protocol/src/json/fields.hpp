#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/parameter_range.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <array>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

using blossom::within;

/// Runs `action`; an error in it lies below the member `name`.
///
/// This is how every error gets its place in the request, those of the engine included: each level that goes
/// into a value adds its own step on the way out.
template <class Action>
decltype(auto) within(std::string_view name, const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        throw error.below({std::string(name)});
    } catch (const std::bad_alloc& problem) {
        throw resource_error(problem).below({std::string(name)});
    }
}

/// Runs `action`, which passes the value that is being read to the engine as its parameter `part`: a place in
/// this parameter is one in the value.
template <class Action>
decltype(auto) as_parameter(Part part, const Action& action) {
    try {
        return action();
    } catch (const Error& error) {
        throw error.at(error.place().inside(part));
    }
}

/// The members of a JSON object, asked for one by one; what nobody has asked for is an unknown field.
///
/// The names that are asked for must outlive the object.
class Fields {
public:
    /// Errors: `wrong_kind` unless `value` is an object.
    explicit Fields(const Json& value);

    bool has(std::string_view name) const { return index_of(name) < members_.size(); }

    /// read(member), with errors below it. Errors: `missing_field`.
    template <class Read>
    decltype(auto) required(std::string_view name, const Read& read) {
        const Json* member = ask(name);
        if (!member) missing(name);
        return within(name, [&]() -> decltype(auto) { return read(*member); });
    }
    template <class Read>
    auto optional(std::string_view name, const Read& read) {
        using Value = std::invoke_result_t<const Read&, const Json&>;
        const Json* member = ask(name);
        return member ? within(name, [&] { return std::optional<Value>(read(*member)); }) : std::nullopt;
    }

    /// Errors: `missing_field`, with the name that was probably meant.
    [[noreturn]] void missing(std::string_view name) const;
    /// Errors: `unknown_field` for the first member that was not asked for.
    void finish() const;

    /// The names that were asked for, in this order; one that was asked for again may stand there again.
    std::span<const std::string_view> asked() const { return {asked_.data(), asked_count_}; }

private:
    const Json* ask(std::string_view name);
    bool is_asked(std::string_view name) const;
    /// The count of members if there is none of this name.
    std::size_t index_of(std::string_view name) const;

    const Json::Object& members_;
    std::array<std::string_view, 48> asked_;  ///< more than any object has fields
    std::size_t asked_count_ = 0;
    std::uint64_t found_ = 0;  ///< a bit for each of the first 64 members that was asked for
    std::size_t next_ = 0;     ///< after the member that was found last
};

/// An exact number: a string as `parse_rational` takes it, or a JSON integer.
/// Errors: `inexact_number` for any other JSON number; those of `parse_rational`.
Rational read_number(const Json& value, const Limits& limits);

/// A count such as a degree, at most `limits.degree`. Errors: `wrong_kind`, `limit_exceeded`.
std::size_t read_count(const Json& value, const Limits& limits);

/// The index of something that a request lists, at most `limits.numbers`. Errors: `wrong_kind`,
/// `limit_exceeded`.
std::size_t read_index(const Json& value, const Limits& limits);

bool read_boolean(const Json& value);
const std::string& read_text(const Json& value);

/// The index of the word among `names`; `what` is what they are, "a method". Errors: `wrong_kind`.
std::size_t read_alternative(const Json& value, std::span<const std::string_view> names,
                             std::string_view what);

/// The elements of a list, each through `read`. Errors: `wrong_kind` unless it is an array.
const Json::Array& read_array(const Json& value);
template <class Read>
auto read_list(const Json& value, const Read& read) {
    const Json::Array& elements = read_array(value);
    std::vector<std::invoke_result_t<const Read&, const Json&>> list;
    list.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        list.push_back(within(i, [&] { return read(elements[i]); }));
    }
    return list;
}

/// A list with one element a direction; `what` are several of them. Errors: `wrong_arity`.
template <class Read>
auto read_each_direction(const Json& value, std::size_t directions, std::string_view what, const Read& read) {
    const std::size_t given = read_array(value).size();
    if (given == directions) return read_list(value, read);
    throw Error(ErrorCode::wrong_arity, std::to_string(given) + " " + std::string(what) + " for " +
                                            std::to_string(directions) + " directions");
}

std::vector<Rational> read_numbers(const Json& value, const Limits& limits);

/// Lists of numbers as they stand in answers.
template <class Lists>
Json::Array lists_json(const Lists& lists) {
    Json::Array written;
    for (const auto& list : lists) written.emplace_back(Json::Array(list.begin(), list.end()));
    return written;
}

/// [a, b]. Errors: `wrong_arity`, `empty_interval`.
Interval read_interval(const Json& value, const Limits& limits);
Json to_json(const Interval& interval);

/// [a, b] where "-inf" and "inf" stand for no end. Errors: `wrong_arity`, `empty_interval`.
ParameterRange read_range(const Json& value, const Limits& limits);
Json to_json(const ParameterRange& range);

/// A homogeneous argument: a point, {"vector": ..} or {"homogeneous": ..}. affine(value, mass) reads the
/// first two, homogeneous(value) what has its mass with it.
template <class Affine, class Homogeneous>
auto read_argument(const Json& value, const Affine& affine, const Homogeneous& homogeneous) {
    if (!value.object()) return affine(value, 1);
    Fields fields(value);
    if (auto vector = fields.optional("vector", [&](const Json& member) { return affine(member, 0); })) {
        fields.finish();
        return *std::move(vector);
    }
    if (!fields.has("homogeneous")) {
        fields.finish();
        fields.missing("vector");
    }
    auto argument = fields.required("homogeneous", homogeneous);
    fields.finish();
    return argument;
}

/// An argument of a blossom of one parameter: a number, {"vector": x} or {"homogeneous": [u, v]}.
Argument read_argument(const Json& value, const Limits& limits);

}  // namespace blossom::protocol
