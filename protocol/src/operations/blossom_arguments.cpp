#include "blossom_arguments.hpp"

#include <blossom/rational/lists.hpp>

#include "map_options.hpp"

namespace blossom::protocol {

std::vector<Argument> read_arguments(const Json& value, const PointForm& form, const Limits& limits) {
    return read_list(value, [&](const Json& element) {
        Argument argument = read_argument(element, limits);
        if (argument.mass.is_zero() && form.rational && !form.homogeneous) {
            throw Error(
                ErrorCode::zero_weight,
                "the argument has mass 0, and so has the value, which for a rational map is no point; "
                "\"homogeneous\": true gives it with its weight");
        }
        return argument;
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
