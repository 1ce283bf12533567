#include "blossom_arguments.hpp"

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

Construction read_construction(const Json& value) {
    std::vector<std::string_view> names;
    for (const Construction construction : all_constructions)
        names.push_back(construction_name(construction));
    return all_constructions[read_alternative(value, names, "a construction")];
}

Option arguments_option(std::string help) {
    return field_option("--at", "arguments", "U1,U2,...", std::move(help), argument_list, patch_arguments);
}

}  // namespace blossom::protocol
