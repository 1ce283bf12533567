#include <fmt/format.h>
#include <blossom/core/evaluation.hpp>

#include "operations/map_options.hpp"
#include "operations/table.hpp"

namespace blossom::cli {

namespace {

Json answer(Fields& request, const Limits& limits) {
    const Map map = read_map_field(request, limits);
    const auto parameters =
        request.required("at", [&](const Json& value) { return read_numbers(value, limits); });
    request.finish();
    require_numbers(parameters.size(), dimension_of(map), limits);

    Json::Array values;
    within("at", [&] {
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            within(i, [&] {
                const auto at = [&](const auto& curve) { return evaluate(curve, parameters[i], limits); };
                values.push_back(to_json(std::visit(at, map.curve), map.form));
            });
        }
    });
    return Json::Object{{"values", std::move(values)}};
}

std::string render(const Answered& answered) {
    std::string text = description(read_map(*answered.request.find("map"), answered.limits)) + "\n\n";
    const Json::Array& parameters = *answered.request.find("at")->array();
    const std::vector<std::string> values = member_texts(answered.result, "values");
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += fmt::format("  P({}) = {}\n", point_text(parameters[i]), answered.style.bold(values[i]));
    }
    return text;
}

}  // namespace

Operation evaluate_operation() {
    return {
        .name = "evaluate",
        .summary = "The values of a map at parameters, exactly",
        .example = {"evaluate", "1 + 1/2t^2; t - 3t^2", "--at", "0,1/3,-0.25"},
        .options = with_map_options(
            {field_option("--at", "at", "T1,T2,...", "the parameters; any rational numbers", number_list)}),
        .answer = answer,
        .render = render,
    };
}

}  // namespace blossom::cli
