#include <fmt/format.h>
#include <blossom/core/derivative.hpp>

#include "operations/map_options.hpp"
#include "operations/table.hpp"

namespace blossom::cli {

namespace {

Map read_polynomial_map(Fields& request, const Limits& limits) {
    Map map = read_map_field(request, limits);
    if (map.form.rational) {
        throw Error(ErrorCode::wrong_kind,
                    "derivatives are known for polynomial maps, and this one is rational", "/map");
    }
    return map;
}

Json answer(Fields& request, const Limits& limits) {
    const Map map = read_polynomial_map(request, limits);
    const std::size_t order =
        request.optional("order", [&](const Json& value) { return read_count(value, limits); }).value_or(1);
    const auto parameters =
        request.optional("at", [&](const Json& value) { return read_numbers(value, limits); });
    request.finish();
    if (!parameters) {
        return Json::Object{{"map", to_json({derivative_map(map.curve, order), map.form, map.variable})}};
    }
    require_numbers(parameters->size(), dimension_of(map), limits);
    Json::Array values;
    within("at", [&] {
        for (std::size_t i = 0; i < parameters->size(); ++i) {
            within(i, [&] {
                values.push_back(to_json(derivative(map.curve, order, (*parameters)[i], limits), map.form));
            });
        }
    });
    return Json::Object{{"values", std::move(values)}};
}

/// P', P'', P''', P^(4), ...
std::string derivative_name(std::size_t order) {
    return order <= 3 ? "P" + std::string(order, '\'') : fmt::format("P^({})", order);
}

std::string render(const Answered& answered) {
    const Map map = read_map(*answered.request.find("map"), answered.limits);
    const Json* order = answered.request.find("order");
    const std::string name = derivative_name(order ? read_count(*order, answered.limits) : 1);
    std::string text = description(map) + "\n\n";
    if (!answered.result.find("values")) {
        const PolynomialMap derived =
            derivative_map(map.curve, order ? read_count(*order, answered.limits) : 1);
        return text + "  " + answered.style.bold(formula({derived, map.form, map.variable}, name)) + "\n";
    }
    const Json::Array& parameters = *answered.request.find("at")->array();
    const std::vector<std::string> values = member_texts(answered.result, "values");
    for (std::size_t i = 0; i < values.size(); ++i) {
        text +=
            fmt::format("  {}({}) = {}\n", name, point_text(parameters[i]), answered.style.bold(values[i]));
    }
    return text;
}

}  // namespace

Operation derivative_operation() {
    return {
        .name = "derivative",
        .summary = "A derivative of a map: its values at parameters, or the derived map",
        .example = {"derivative", "1 + 2t + 4t^2 - t^3", "--order", "2", "--at", "1/2"},
        .options = with_map_options({
            field_option("--order", "order", "K", "the order of the derivative; by default 1", count),
            field_option("--at", "at", "T1,T2,...", "the parameters; without them the derived map is given",
                         number_list),
        }),
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::cli
