#include "comparison.hpp"

#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "formats/doubles.hpp"
#include "json/fields.hpp"
#include "maps/net_fields.hpp"

namespace blossom::protocol {

namespace {

std::string size_text(const Json& value) {
    const Json::Array* list = value.array();
    return list ? std::to_string(list->size()) + " values" : value.object() ? "an object" : "one number";
}

[[noreturn]] void refuse_size(const Json& exact, const Json& computed) {
    throw Error(ErrorCode::mismatched_dimensions,
                "there are " + size_text(computed) + ", and " + size_text(exact) + " in the exact map");
}

/// The same shape with zeros.
Json zeros_like(const Json& value) {
    const Json::Array* elements = value.array();
    return elements ? Json(Json::Array(elements->size(), Rational(0))) : Json(Rational(0));
}

}  // namespace

bool is_indexed(const Json& value) {
    const Json::Array* entries = value.array();
    const Json::Array* pair = entries && !entries->empty() ? entries->front().array() : nullptr;
    const Json::Array* index = pair && pair->size() == 2 ? pair->front().array() : nullptr;
    return index && std::ranges::all_of(*index, [](const Json& entry) { return entry.number() != nullptr; });
}

Difference Comparison::operator()(const Json& exact, const Json& computed) {
    if (exact.object()) return of_members(exact, computed);
    if (!exact.array()) return of_numbers(exact, computed);
    if (!computed.array()) {
        if (computed.number() || computed.text() || computed.exact()) refuse_size(exact, computed);
        read_array(computed);
    }
    return is_indexed(exact) ? of_entries(exact, computed) : of_elements(exact, computed);
}

Difference Comparison::of_numbers(const Json& exact, const Json& computed) {
    if (computed.array()) refuse_size(exact, computed);
    const Rational& expected = *exact.exact();
    const Rational found = read_double(computed);
    const Rational nearest = exact_rational(nearest_double(expected));
    const Rational error = found - expected;
    const Rational ulps = abs(error) / unit_in_last_place(expected);
    greatest_ = std::max(greatest_, ulps);
    // A number that is no double, such as a decimal, counts as its nearest double.
    if (found != nearest && exact_rational(nearest_double(found)) != nearest) ++wrong_;
    ++count_;
    return {error, ulps};
}

Difference Comparison::of_elements(const Json& exact, const Json& computed) {
    const Json::Array& expected = *exact.array();
    const Json::Array& found = *computed.array();
    if (expected.size() != found.size()) refuse_size(exact, computed);
    Json::Array errors, ulps;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        Difference difference = within(i, [&] { return (*this)(expected[i], found[i]); });
        errors.push_back(std::move(difference.error));
        ulps.push_back(std::move(difference.ulps));
    }
    return {std::move(errors), std::move(ulps)};
}

Difference Comparison::of_members(const Json& exact, const Json& computed) {
    Fields fields(computed);
    Difference all;
    for (const auto& [name, expected] : *exact.object()) {
        Difference difference =
            fields.required(name, [&](const Json& found) { return (*this)(expected, found); });
        all.error[name] = std::move(difference.error);
        all.ulps[name] = std::move(difference.ulps);
    }
    fields.finish();
    return all;
}

Difference Comparison::of_entries(const Json& exact, const Json& computed) {
    const Json::Array& found = *computed.array();
    std::vector<std::size_t> places = places_of_entries(exact, found);
    const Json zeros = zeros_like((*exact.array()->front().array())[1]);
    Json::Array errors, ulps;
    const auto append = [&](const Json& index, const Difference& difference) {
        errors.emplace_back(Json::Array{index, difference.error});
        ulps.emplace_back(Json::Array{index, difference.ulps});
    };
    const auto value_at = [&](std::size_t place, const Json& expected) {
        return within(place, [&] {
            return within(std::size_t{1}, [&] { return (*this)(expected, (*found[place].array())[1]); });
        });
    };
    for (const Json& entry : *exact.array()) {
        const Json::Array& pair = *entry.array();
        const std::size_t place = places[errors.size()];
        append(pair[0], place < found.size() ? value_at(place, pair[1]) : (*this)(pair[1], zeros));
    }
    for (std::size_t i = errors.size(); i < places.size(); ++i) {
        append((*found[places[i]].array())[0], value_at(places[i], zeros));
    }
    return {std::move(errors), std::move(ulps)};
}

std::vector<std::size_t> Comparison::places_of_entries(const Json& exact, const Json::Array& found) const {
    std::map<std::vector<std::size_t>, std::size_t> known;
    for (const Json& entry : *exact.array()) known.emplace(read_index_of((*entry.array())[0]), known.size());
    std::vector<std::size_t> places(known.size(), found.size());
    const std::size_t length = known.begin()->first.size();
    for (std::size_t i = 0; i < found.size(); ++i) {
        within(i, [&] {
            const Json::Array& pair = read_array(found[i]);
            if (pair.size() != 2) refuse_net("an entry is a pair of an index and a value");
            within(std::size_t{0}, [&] {
                const auto [place, added] = known.emplace(read_index_of(pair[0]), known.size());
                if (added && (!sparse_ || place->first.size() != length))
                    refuse_net("the exact map has no such index");
                if (added) {
                    places.push_back(i);
                } else if (std::exchange(places[place->second], i) != found.size()) {
                    refuse_net("the index occurs twice");
                }
            });
        });
    }
    if (!sparse_ && std::ranges::find(places, found.size()) != places.end())
        refuse_net("there are " + std::to_string(found.size()) + " entries, and " +
                   std::to_string(places.size()) + " in the exact map");
    return places;
}

std::vector<std::size_t> Comparison::read_index_of(const Json& value) const {
    return read_list(value, [&](const Json& entry) { return read_count(entry, limits_); });
}

}  // namespace blossom::protocol
