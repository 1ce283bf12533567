#include "blossom_arguments.hpp"

#include <blossom/rational/lists.hpp>

#include <numeric>

#include "map_options.hpp"
#include "maps/parameters.hpp"

namespace blossom::protocol {

namespace {

void require_mass(const Rational& mass, const PointForm& form) {
    if (!mass.is_zero() || !form.separate_weights()) return;
    throw Error(ErrorCode::zero_weight,
                "the argument has mass 0, and so has the value, which for a rational map is not a point; "
                "\"homogeneous\": true gives it with its weight");
}

Argument read_argument_of(const Json& value, const PointForm& form, const Limits& limits) {
    Argument argument = read_argument(value, limits);
    require_mass(argument.mass, form);
    return argument;
}

Coordinates read_simplex_argument(const Json& value, const Patch& patch, const PointForm& form,
                                  const Limits& limits) {
    const std::size_t count = patch.parameters();
    const bool sum_is_mass = patch.is_barycentric();
    const auto affine = [&](const Json& member, int mass) {
        return std::pair(read_tuple(member, count, limits), Rational(mass));
    };
    const auto homogeneous = [&](const Json& member) {
        std::vector<Rational> numbers = read_tuple(member, count + (sum_is_mass ? 0 : 1), limits);
        Rational mass =
            sum_is_mass ? std::accumulate(numbers.begin(), numbers.end(), Rational()) : numbers.back();
        numbers.resize(count);
        return std::pair(std::move(numbers), std::move(mass));
    };
    const auto [numbers, mass] = read_argument(value, affine, homogeneous);
    require_mass(mass, form);
    if (sum_is_mass) require_sum(numbers, mass);
    return engine_argument(patch, 0, numbers, mass);
}

}  // namespace

std::vector<Argument> read_arguments(const Json& value, const PointForm& form, const Limits& limits) {
    return read_list(value, [&](const Json& element) { return read_argument_of(element, form, limits); });
}

PatchArguments read_arguments(const Json& value, const Patch& patch, const PointForm& form,
                              const Limits& limits) {
    if (!patch.tensor) {
        return {read_list(
            value, [&](const Json& element) { return read_simplex_argument(element, patch, form, limits); })};
    }
    std::size_t direction = 0;
    return read_each_direction(value, patch.shape().factors(), "lists of arguments", [&](const Json& list) {
        const std::size_t f = direction++;
        return read_list(list, [&](const Json& element) {
            const Argument argument = read_argument_of(element, form, limits);
            return engine_argument(patch, f, std::span(&argument.u, 1), argument.mass);
        });
    });
}

std::vector<std::string_view> construction_names() { return mapped(all_constructions, construction_name); }

Construction read_construction(const Json& value) {
    return all_constructions[read_alternative(value, construction_names(), "a construction")];
}

Field arguments_field(Presence presence, std::string documentation) {
    const Shape of_curve = Shape::list(ValueKind::argument);
    return {"arguments",
            Shape::one_of({of_curve, Shape::list(ValueKind::point_argument), Shape::list(of_curve)}),
            presence, std::move(documentation)};
}

Option arguments_option(std::string help) {
    return field_option("--at", "arguments", "U1,U2,...", argument_list, patch_arguments, std::move(help));
}

}  // namespace blossom::protocol
