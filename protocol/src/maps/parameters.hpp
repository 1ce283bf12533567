#pragma once

#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "map.hpp"

/// Parameters in requests: one number for a curve, one number per direction for a tensor
/// product, the coordinates of a point for a simplex.

namespace blossom::protocol {

/// The form in which the parameters of a map are written.
struct ParameterForm {
    bool scalar = true;        ///< a parameter of a curve: a number, not an array
    std::size_t numbers = 1;   ///< numbers per parameter
    std::size_t factors = 1;   ///< factors of the domain, one per direction
    bool barycentric = false;  ///< the numbers of a point add up to 1, those of a vector to 0
};

ParameterForm parameter_form(const Map& map);

/// The numbers of all parameters, one parameter after the other.
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

/// The directions of a derivative: "directions", or "direction" repeated "order" times; for a curve the unit
/// vector. Errors: `missing_field`, `limit_exceeded`.
std::vector<Coordinates> read_directions(Fields& request, const ParameterForm& form, const Limits& limits);

/// One number or null per direction.
std::vector<std::optional<Rational>> read_some_directions(const Json& value, std::size_t directions,
                                                          const Limits& limits);

/// f(parameter) for each parameter; errors get its place in the field "at".
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

/// The values at the parameters of the field "at", as an answer lists them.
Json written_at(std::span<const Coordinates> values, const PointForm& form);

}  // namespace blossom::protocol
