#pragma once

#include <functional>
#include <vector>

#include "operation.hpp"

/// Values of curves of every kind at parameters.

namespace blossom::protocol {

/// What a parameter is mapped to, in the coordinates of the engine. It refers to the map and limits that it
/// is made of.
using Evaluator = std::function<Coordinates(const Rational& t)>;

/// The map itself, prepared if it will be asked at many parameters. Errors: `wrong_kind`.
Evaluator value_evaluator(const Map& map, std::size_t parameters, const Limits& limits);
/// Its derivative; of a rational map whose weights stand apart, that of the divided map, divided.
/// Errors: `wrong_kind`.
Evaluator derivative_evaluator(const Map& map, std::size_t order, const Limits& limits);

/// value(i) for each of `count` elements of the field "at". Errors: those of `value` and of writing, at the
/// element.
template <class Value>
Json written_at(std::size_t count, const PointForm& form, const Value& value) {
    return within("at", [&] {
        Json::Array values;
        values.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            values.push_back(within(i, [&] { return to_json(value(i), form); }));
        return values;
    });
}

/// One point for each number of the field "at". Errors: those of the evaluator, at the field;
/// `limit_exceeded` for too many.
Json values_at(const Evaluator& evaluator, const std::vector<Rational>& parameters, const PointForm& form,
               std::size_t dimension, const Limits& limits);

}  // namespace blossom::protocol
