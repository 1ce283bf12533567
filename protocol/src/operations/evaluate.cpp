#include <fmt/format.h>

#include "map_options.hpp"
#include "maps/parameters.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "pyramid.hpp"
#include "shared_fields.hpp"
#include "table.hpp"
#include "values.hpp"

namespace blossom::protocol {

namespace {

Answer answer_evaluate(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const ParameterForm form = parameter_form(map);
    const Parameters parameters = read_parameters(request, form, limits);
    const bool pyramid = request.optional("pyramid", read_boolean).value_or(false);
    request.finish();

    Json result = Json::Object{{"values", written_at(values_at(map, parameters, limits), map.form)}};
    if (pyramid) add_pyramids(result, map, parameters, limits);
    return result;
}

std::string render_evaluate(const Answered& answered) {
    std::string text = description(answered.given()) + "\n\n";
    const Json::Array& parameters = *answered.request.find("at")->array();
    const std::vector<std::string> values = member_texts(answered.result(), "values");
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += fmt::format("  P{} = {}\n", parameter_text(parameters[i]), answered.style.bold(values[i]));
    }
    return text + pyramids_text(answered);
}

}  // namespace

Operation evaluate_operation() {
    return {
        .summary = "Compute the exact values of a map at parameters",
        .documentation = "A spline can be evaluated in its domain, every other curve anywhere.",
        .request = {{map_field(), required("at", parameters_shape(), "the parameters"),
                     optional("pyramid", ValueKind::boolean,
                              "show every point of de Casteljau's or de Boor's algorithm")}},
        .result = {{values_member(),
                    optional("pyramids", Shape::list(Shape::list(Shape::list(ValueKind::point))),
                             "for each parameter the levels of the algorithm, from the control points to the "
                             "value, each in the "
                             "order of the control net; of a tensor product the last direction comes first"),
                    optional("pyramid_weights", Shape::list(Shape::list(numbers_shape())),
                             "the weights of these points, where the map has weights")}},
        .example = {"evaluate", "1 + 1/2t^2; t - 3t^2", "--at", "0,1/3,-0.25"},
        .options = with_map_options({
            field_option("--at", "at", "T1,T2,...", number_list, patch_parameters,
                         "the parameters, any rational numbers; for a patch points, separated by ';'"),
            flag_option("--pyramid", "pyramid"),
        }),
        .answer = answer_evaluate,
        .render = render_evaluate,
        .plot = plot_of_values,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
