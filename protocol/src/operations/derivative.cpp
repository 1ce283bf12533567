#include <fmt/format.h>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include "evaluator.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct DerivativeMap {
    std::size_t order;
    bool divided;  ///< of the map divided by its weight
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        const PolynomialMap map = polynomial_map(curve, limits);
        const PolynomialMap derived =
            divided ? rational_derivative_map(map, order, limits) : derivative_map(map, order);
        return std::visit([](const auto& one) { return AnyMap(one); }, derived);
    }
    AnyMap operator()(const TaylorCurve& curve) const {
        const AnyMap derived = (*this)(monomial_form(curve, limits));
        return taylor_form(std::get<PolynomialCurve>(derived), curve.center, limits);
    }
    AnyMap operator()(const BSplineCurve& curve) const {
        return divided ? rational_derivative_curve(curve, order, limits)
                       : derivative_curve(curve, order, limits);
    }
};

Map derived_map(const Map& map, std::size_t order, const Limits& limits) {
    const DerivativeMap derive{order, map.form.separate_weights(), limits};
    return like(map, dispatch_on_kind<AnyMap>(map, derive));
}

Answer derivative_of_curve(Fields& request, const Map& map, const Limits& limits) {
    const std::size_t order =
        request.optional("order", [&](const Json& value) { return read_count(value, limits); }).value_or(1);
    const auto parameters =
        request.optional("at", [&](const Json& value) { return read_numbers(value, limits); });
    request.finish();
    if (!parameters) return answer_of(derived_map(map, order, limits));
    // The derivative of a rational map comes divided.
    const PointForm form = map.form.separate_weights() ? PointForm{.scalar = map.form.scalar} : map.form;
    return Json::Object{{"values", values_at(derivative_evaluator(map, order, limits), *parameters, form,
                                             dimension_of(map), limits)}};
}

/// P', P'', P''', P^(4), ...
std::string derivative_name(std::size_t order) {
    return order <= 3 ? "P" + std::string(order, '\'') : fmt::format("P^({})", order);
}

std::string render(const Answered& answered) {
    const Json* order = answered.request.find("order");
    const std::string name =
        has_patch(answered.request) ? "DP" : derivative_name(order ? read_count(*order, answered.limits) : 1);
    std::string text = description(answered.given()) + "\n\n";
    if (!answered.answer.maps.empty()) {
        const ShownMap derived = shown_maps(answered).front();
        return text + (derived.json.find("control_net") ? net_listing(derived, name, answered.style)
                                                        : line_of(derived.map, name, answered.style));
    }
    const Json::Array& parameters = *answered.request.find("at")->array();
    const std::vector<std::string> values = member_texts(answered.result(), "values");
    for (std::size_t i = 0; i < values.size(); ++i) {
        text +=
            fmt::format("  {}{} = {}\n", name, parameter_text(parameters[i]), answered.style.bold(values[i]));
    }
    return text;
}

/// `show` of the derived map, whether or not the request asks for values only.
template <std::string (*show)(const Answered&)>
std::string of_derived_map(const Answered& answered) {
    if (!answered.answer.maps.empty()) return show(answered);
    Json::Object members;
    for (const std::string_view name : {"order", "direction", "directions"}) {
        if (const Json* member = answered.request.find(name)) members.emplace_back(name, *member);
    }
    const Json without_parameters = std::move(members);
    Fields fields(without_parameters);
    Answer derived = answer_about<derivative_of_curve, derivative_of_patch, derivative_of_tensor_bspline>(
        fields, answered.given(), answered.limits);
    derived.given = answered.answer.given;
    return show({answered.request, derived, answered.limits, answered.style});
}

}  // namespace

Operation derivative_operation() {
    return {
        .name = "derivative",
        .summary = "Differentiate a map: values at parameters, or the derivative as a map",
        .documentation = "Rational maps are differentiated by the quotient rule.",
        .request = {{map_field(), optional("at", parameters_shape(),
                                           "the parameters; by default the derivative is returned as a map")},
                    {{{optional("order", ValueKind::count, "the order of the derivative; by default 1"),
                       optional("direction", numbers_shape(),
                                "for a patch: the direction, used as often as the order says")},
                      {optional("directions", tuples_shape(),
                                "for a patch: one direction per order of a mixed derivative")}}}},
        .result = {{}, {{{values_member()}, {map_member("without `at`: the derivative")}}}},
        .example = {"derivative", "1 + 2t + 4t^2 - t^3", "--order", "2", "--at", "1/2"},
        .options = with_map_options({
            field_option("--order", "order", "K", count),
            field_option("--at", "at", "T1,T2,...", number_list, patch_parameters),
            field_option("--direction", "direction", "X,Y,...", number_list),
            field_option("--directions", "directions", "D1;D2;...", tuple_list),
        }),
        .answer = answer_by_shape<derivative_of_curve, derivative_of_patch, derivative_of_tensor_bspline>,
        .render = render,
        .plot = of_derived_map<plot_of_result>,
        .mesh = of_derived_map<obj_of>,
    };
}

}  // namespace blossom::protocol
