#pragma once

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/rational/error.hpp>

#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "map.hpp"

/// How an operation says which kinds of map it serves.

namespace blossom::protocol {

/// One function object of several, chosen by the type of the argument.
template <class... Functions>
struct Overloads : Functions... {
    using Functions::operator()...;
};

/// A curve that is one polynomial, in a representation that the engine takes everywhere.
/// Cost: a conversion for the last two. Errors: `limit_exceeded`.
inline PolynomialMap polynomial_map(const PolynomialCurve& curve, const Limits&) { return curve; }
inline PolynomialMap polynomial_map(const BezierCurve& curve, const Limits&) { return curve; }
PolynomialMap polynomial_map(const TaylorCurve& curve, const Limits& limits);
PolynomialMap polynomial_map(const ProgressiveCurve& curve, const Limits& limits);

/// By monomial coefficients.
PolynomialCurve monomial_curve(const PolynomialMap& map, const Limits& limits);

/// One polynomial a coordinate.
std::vector<Polynomial> coordinates_of(const PolynomialCurve& curve);

/// The kinds for which `polynomial_map` is defined.
template <class Value>
concept OnePolynomial = requires(const Value& value, const Limits& limits) {
    { polynomial_map(value, limits) } -> std::same_as<PolynomialMap>;
};

/// The interval that a curve brings with it; [0, 1] where it brings none.
inline Interval own_interval(const PolynomialCurve&) { return {}; }
inline Interval own_interval(const TaylorCurve&) { return {}; }
inline Interval own_interval(const BezierCurve& curve) { return curve.interval(); }
inline Interval own_interval(const BSplineCurve& curve) { return curve.knots().domain(); }
inline Interval own_interval(const Samples& samples) { return samples.interval; }
Interval own_interval(const ProgressiveCurve& curve);

/// The names of the kinds that `Function` can be called with, "bezier, bspline".
template <class Function, std::size_t... Indices>
std::string served_names(std::index_sequence<Indices...>) {
    std::string names;
    const auto add = [&](bool served, std::string_view name) {
        if (served) names += (names.empty() ? "" : ", ") + std::string(name);
    };
    (add(std::is_invocable_v<const Function&, const std::variant_alternative_t<Indices, AnyMap>&>,
         map_names[Indices]),
     ...);
    return names;
}

/// function(value) for the kinds of map that it can be called with.
/// Errors: `wrong_kind` for every other kind, naming those it can be called with; `place` is the map's.
template <class Result, class Function>
Result serve(const Map& map, const Function& function, const Place& place = Part::map) {
    const auto serve_kind = [&](const auto& value) -> Result {
        if constexpr (std::is_invocable_v<const Function&, decltype(value)>) {
            return function(value);
        } else {
            constexpr auto kinds = std::make_index_sequence<std::variant_size_v<AnyMap>>();
            throw Error(ErrorCode::wrong_kind,
                        "a map of kind " + std::string(map_names[map.value.index()]) +
                            " is not taken here; taken are: " + served_names<Function>(kinds),
                        place);
        }
    };
    return std::visit(serve_kind, map.value);
}

/// What the inverse formula makes of samples. Errors: `missing_sample`; `limit_exceeded`.
BezierCurve curve_of_samples(const Samples& samples, const Limits& limits);

/// A map of a kind that is one polynomial. Errors: `wrong_kind`.
PolynomialMap one_polynomial(const Map& map, const Limits& limits);

}  // namespace blossom::protocol
