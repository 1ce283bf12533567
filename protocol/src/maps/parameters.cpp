#include "parameters.hpp"

#include "dispatch_on_kind.hpp"

namespace blossom::protocol {

ParameterForm parameter_form(const Map& map) {
    const auto of_curve = [](const auto&) { return ParameterForm(); };
    const auto of_patch = [](const Patch& patch) {
        return ParameterForm{false, patch.parameters(), patch.shape().factors(), patch.is_barycentric()};
    };
    const auto of_splines = [](const TensorBSpline& spline) {
        return ParameterForm{false, spline.directions(), spline.directions()};
    };
    return std::visit(Overloads{of_curve, of_patch, of_splines}, map.value);
}

std::vector<Rational> read_parameter(const Json& value, const ParameterForm& form, int mass,
                                     const Limits& limits) {
    if (form.scalar) return {read_number(value, limits)};
    std::vector<Rational> numbers = read_tuple(value, form.numbers, limits);
    if (form.barycentric) require_sum(numbers, mass);
    return numbers;
}

Parameters read_parameters(Fields& request, const ParameterForm& form, const Limits& limits) {
    return request.required("at", [&](const Json& value) {
        if (form.scalar) return Parameters{read_numbers(value, limits)};
        Parameters list{{}, form.numbers};
        for (auto& point :
             read_list(value, [&](const Json& element) { return read_parameter(element, form, 1, limits); }))
            list.numbers.insert(list.numbers.end(), point.begin(), point.end());
        return list;
    });
}

std::vector<Coordinates> read_directions(Fields& request, const ParameterForm& form, const Limits& limits) {
    const auto read = [&](const Json& value) { return read_parameter(value, form, 0, limits); };
    if (!form.scalar) {
        auto list = request.optional("directions", [&](const Json& value) { return read_list(value, read); });
        if (list) return std::move(*list);
    }
    const Coordinates direction = form.scalar ? Coordinates{1} : request.required("direction", read);
    const std::size_t order =
        request.optional("order", [&](const Json& value) { return read_count(value, limits); }).value_or(1);
    require_numbers(order, form.numbers, limits);
    return std::vector(order, direction);
}

std::vector<std::optional<Rational>> read_some_directions(const Json& value, std::size_t directions,
                                                          const Limits& limits) {
    return read_each_direction(value, directions, "entries", [&](const Json& element) {
        return element.is_null() ? std::nullopt : std::optional(read_number(element, limits));
    });
}

Json written_at(std::span<const Coordinates> values, const PointForm& form) {
    return within("at", [&] {
        Json::Array written;
        written.reserve(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            written.push_back(within(i, [&] { return to_json(values[i], form); }));
        return written;
    });
}

}  // namespace blossom::protocol
