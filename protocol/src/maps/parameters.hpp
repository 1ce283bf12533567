#pragma once

#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "map.hpp"

/// Parameters as they stand in requests: by one number for a curve, by one number per direction for a tensor
/// product, by the coordinates of a point for a simplex.

namespace blossom::protocol {

/// How the parameters of a map are written.
struct ParameterForm {
    bool scalar = true;        ///< those of a curve: as a number, not as an array
    std::size_t numbers = 1;   ///< that make up a parameter
    std::size_t factors = 1;   ///< of the domain: what there is one of a direction
    bool barycentric = false;  ///< the numbers of a point have the sum 1, those of a vector the sum 0
};

ParameterForm parameter_form(const Map& map);

/// The numbers of each parameter behind those of the one before.
struct Parameters {
    std::vector<Rational> numbers;
    std::size_t each = 1;

    std::size_t size() const { return numbers.size() / each; }
    std::span<const Rational> operator[](std::size_t i) const {
        return std::span(numbers).subspan(i * each, each);
    }
};

/// A point of the domain, of mass 1, or a vector, of mass 0. Errors: `mismatched_dimensions`; `not_affine`
/// for barycentric numbers of another sum.
std::vector<Rational> read_parameter(const Json& value, const ParameterForm& form, int mass,
                                     const Limits& limits);

/// The field "at", a list of points.
Parameters read_parameters(Fields& request, const ParameterForm& form, const Limits& limits);

/// What is differentiated along: "directions", or "direction" as often as "order" says, of a curve the unit
/// vector. Errors: `missing_field`, `limit_exceeded`.
std::vector<Coordinates> read_directions(Fields& request, const ParameterForm& form, const Limits& limits);

/// One number or null a direction.
std::vector<std::optional<Rational>> read_some_directions(const Json& value, std::size_t directions,
                                                          const Limits& limits);

/// f(parameter) for each of them, with errors at its place in the field "at".
template <class Function>
auto at_each(const Parameters& parameters, const Function& f) {
    return within("at", [&] {
        std::vector<std::invoke_result_t<const Function&, std::span<const Rational>>> values;
        values.reserve(parameters.size());
        for (std::size_t i = 0; i < parameters.size(); ++i)
            values.push_back(within(i, [&] { return f(parameters[i]); }));
        return values;
    });
}

/// One value for each parameter of the field "at", as they stand in an answer.
Json written_at(std::span<const Coordinates> values, const PointForm& form);

}  // namespace blossom::protocol
