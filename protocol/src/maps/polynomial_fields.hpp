#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "json/fields.hpp"
#include "points.hpp"

/// The fields of polynomials in one and in several variables: "text" or coefficients,
/// "denominator" and "homogeneous".

namespace blossom::protocol {

/// Calls texts(member) for the field "text", or coefficients(member) for the field `name`. Errors:
/// `wrong_kind` if both are present.
template <class Texts, class Coefficients>
auto read_polynomials(Fields& fields, std::string_view name, const Texts& texts,
                      const Coefficients& coefficients) {
    auto text = fields.optional("text", texts);
    if (!text) return fields.required(name, coefficients);
    if (!fields.has(name)) return std::move(*text);
    throw Error(ErrorCode::wrong_kind,
                "a polynomial is given by \"text\" or by \"" + std::string(name) + "\", not by both",
                Place{std::string(name)});
}

/// The form of polynomials, one per coordinate and perhaps a denominator; reads "homogeneous". Errors:
/// `mismatched_dimensions` where there is nothing but a weight.
PointForm read_polynomial_form(Fields& fields, std::size_t coordinates, bool scalar, bool has_denominator);

/// "(1 - t^2, 2t) / (1 + t^2)", from one text per coordinate.
std::string coordinates_text(std::vector<std::string> texts, const PointForm& form);

}  // namespace blossom::protocol
