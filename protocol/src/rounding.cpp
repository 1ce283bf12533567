#include "rounding.hpp"

#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "formats/doubles.hpp"
#include "json/fields.hpp"

namespace blossom::protocol {

namespace {

bool has_exact_numbers(const Json& value) {
    if (value.exact()) return true;
    const Json::Array* elements = value.array();
    return elements && std::ranges::any_of(*elements, has_exact_numbers);
}

Json rounded(const Json& value, Rounding rounding) {
    if (const Rational* number = value.exact()) {
        if (rounding == Rounding::hexadecimal) return hexadecimal_float(*number);
        return double_number(*number);
    }
    const Json::Array* elements = value.array();
    if (!elements) return value;
    Json::Array twins;
    twins.reserve(elements->size());
    for (std::size_t i = 0; i < elements->size(); ++i) {
        twins.push_back(within(i, [&] { return rounded((*elements)[i], rounding); }));
    }
    return twins;
}

void add_twins(Json& value, Rounding rounding) {
    if (Json::Array* elements = value.array()) {
        for (std::size_t i = 0; i < elements->size(); ++i)
            within(i, [&] { add_twins((*elements)[i], rounding); });
    }
    Json::Object* members = value.object();
    if (!members) return;
    Json::Object with_twins;
    for (auto& [name, member] : *members) {
        within(name, [&] {
            if (has_exact_numbers(member)) {
                Json twin = rounded(member, rounding);
                with_twins.emplace_back(name, std::move(member));
                with_twins.emplace_back(name + std::string(rounding_suffix(rounding)), std::move(twin));
            } else {
                add_twins(member, rounding);
                with_twins.emplace_back(name, std::move(member));
            }
        });
    }
    *members = std::move(with_twins);
}

}  // namespace

std::vector<std::string_view> rounding_names() { return {"double", "hexfloat"}; }

Rounding read_rounding(const Json& value) {
    constexpr Rounding roundings[] = {Rounding::binary64, Rounding::hexadecimal};
    return roundings[read_alternative(value, rounding_names(), "a way to round")];
}

std::string_view rounding_suffix(Rounding rounding) {
    return rounding == Rounding::hexadecimal ? "_hex" : "_double";
}

bool is_rounded_twin(std::string_view name) {
    return name.ends_with(rounding_suffix(Rounding::binary64)) ||
           name.ends_with(rounding_suffix(Rounding::hexadecimal));
}

void add_rounded_numbers(Json& result, Rounding rounding) {
    if (rounding == Rounding::none) return;
    try {
        add_twins(result, rounding);
    } catch (const Error& error) {
        throw error.at(Place{"numbers"})
            .saying("in the result, at " + pointer_of(error.place()) + ", " + error.message());
    }
}

}  // namespace blossom::protocol
