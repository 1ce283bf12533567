#pragma once

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "kind.hpp"

/// The choice of a function by the kind of a map.

namespace blossom::protocol {

/// One function object of several, chosen by the type of the argument.
template <class... Functions>
struct Overloads : Functions... {
    using Functions::operator()...;
};

/// The names of the kinds that `Function` can be called with, "bezier, bspline".
template <class Function, std::size_t... Indices>
std::string taken_names(std::index_sequence<Indices...>) {
    std::string names;
    const auto add = [&](bool taken, std::string_view name) {
        if (taken) names += (names.empty() ? "" : ", ") + std::string(name);
    };
    (add(std::is_invocable_v<const Function&, const std::variant_alternative_t<Indices, AnyMap>&>,
         Kinds::all[Indices]->name),
     ...);
    return names;
}

/// function(value) for the kinds of map that it can be called with.
/// Errors: `wrong_kind` for every other kind, naming those it can be called with; `place` is the map's.
template <class Result, class Function, class Where = Part>
Result dispatch_on_kind(const Map& map, const Function& function, const Where& place = Part::map) {
    const auto call = [&](const auto& value) -> Result {
        if constexpr (std::is_invocable_v<const Function&, decltype(value)>) {
            return function(value);
        } else {
            constexpr auto kinds = std::make_index_sequence<std::variant_size_v<AnyMap>>();
            throw Error(ErrorCode::wrong_kind,
                        "a map of kind " + std::string(name_of(map)) +
                            " is not accepted here; accepted are: " + taken_names<Function>(kinds),
                        place);
        }
    };
    return std::visit(call, map.value);
}

/// The curve through n + 1 samples; of any other number, the one that the inverse formula makes of them.
/// Errors: `missing_sample`; `limit_exceeded`.
BezierCurve curve_of_samples(const Samples& samples, const Limits& limits);

/// A map of a kind that is one polynomial. Errors: `wrong_kind`.
PolynomialMap one_polynomial(const Map& map, const Limits& limits);

}  // namespace blossom::protocol
