#include "jacobian.hpp"

#include <fmt/format.h>
#include <blossom/core/patch/partial_derivatives.hpp>

#include "listing.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view jacobian_names[] = {"determinant", "matrix"};

/// Sums of the coordinates of a map and its partial derivatives, which have a weight last if the map has one.
Map of_derivatives(const CommonMaps& derived, const CoordinateSums& sums, bool scalar, const Limits& limits) {
    if (derived.forms.front().rational) return combined_rational_map(derived, sums, scalar, limits);
    return combined_map(derived, sums, scalar, limits);
}

std::vector<Map> partial_derivatives_of(const CommonMaps& given, const Limits& limits) {
    const CommonMaps derived = with_partial_derivatives(given, limits);
    const PointForm& form = given.forms.front();
    std::vector<Map> maps;
    for (std::size_t i = 1; i < derived.size(); ++i) {
        maps.push_back(of_derivatives(derived, partial_derivative(i, given.dimension(0), form.rational),
                                      form.scalar, limits));
    }
    return maps;
}

Answer answer_jacobian(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const bool matrix =
        request
            .optional("as",
                      [](const Json& value) { return read_alternative(value, jacobian_names, "a form"); })
            .value_or(0) == 1;
    request.finish();
    const CommonMaps given = on_own_domain(map, limits);
    if (matrix) return answer_of(partial_derivatives_of(given, limits));
    return answer_of(jacobian_of(given, limits));
}

Answer answer_normal(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    request.finish();
    const CommonMaps given = on_own_domain(map, limits);
    const CommonMaps derived = with_partial_derivatives(given, limits);
    const std::size_t dimension = given.dimension(0);
    if (derived.size() != dimension) {
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("a map has a normal where it has one coordinate more than parameters; the "
                                "numbers of these are {} and {}",
                                dimension, derived.size() - 1),
                    Place{"map"});
    }
    return answer_of(of_derivatives(derived, normal_vector(dimension, given.forms.front().rational, limits),
                                    false, limits));
}

}  // namespace

Map jacobian_of(const CommonMaps& given, const Limits& limits) {
    const std::size_t dimension = given.dimension(0);
    if (parameters_of(given) != dimension) {
        throw Error(
            ErrorCode::mismatched_dimensions,
            fmt::format(
                "a determinant needs as many coordinates as parameters; the numbers of these are {} and {}",
                dimension, parameters_of(given)),
            Place{"map"});
    }
    const CoordinateSums sums = jacobian_determinant(dimension, given.forms.front().rational, limits);
    return of_derivatives(with_partial_derivatives(given, limits), sums, true, limits);
}

Operation jacobian_operation() {
    return {
        .summary = "Compute the Jacobian of a map: its determinant, or its columns, as maps",
        .documentation = "The determinant needs as many coordinates as parameters.",
        .request = {{map_field(),
                     optional("as", Shape::words(jacobian_names),
                              "`determinant`, the default, or `matrix`: the partial derivatives, which are "
                              "its columns")}},
        .result = {{},
                   {{{map_member("the determinant")},
                     {maps_member("with `matrix`: the partial derivatives")}}}},
        .example = {"jacobian", "x + x*y; y - x^2", "--variables", "x,y"},
        .options = with_map_options({word_option("--as", "as")}),
        .answer = answer_jacobian,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

Operation normal_operation() {
    return {
        .summary = "Compute the normal of a curve in the plane or a surface in space as a map",
        .documentation = "It is the cross product of the partial derivatives, and not of unit length.",
        .request = {{map_field()}},
        .result = {{map_member("the normal vector")}},
        .example = {"normal", "x; y; x*y", "--variables", "x,y", "--degrees", "1,1"},
        .options = with_map_options({}),
        .answer = answer_normal,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
