#include <fmt/format.h>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/nurbs/rational_patch.hpp>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/patch/patch_derivative.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include <algorithm>
#include <map>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "maps/parameters.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The order of a derivative in each direction, and what multiplies it.
struct PartialOrders {
    std::vector<std::size_t> orders;
    Rational factor = 1;
};

PartialOrders partial_orders(std::size_t count, std::span<const Coordinates> directions) {
    PartialOrders result{std::vector<std::size_t>(count), 1};
    for (const Coordinates& direction : directions) {
        const auto nonzero = [](const Rational& x) { return !x.is_zero(); };
        const auto first = std::ranges::find_if(direction, nonzero);
        if (std::ranges::count_if(direction, nonzero) > 1) {
            throw Error(
                ErrorCode::wrong_kind,
                "the derivative of B-splines is again a map of this kind along one parameter only, "
                "with all entries but one 0; at parameters, with \"at\", it is given in any direction",
                Place{"direction"});
        }
        if (first == direction.end()) {
            result.factor = 0;
        } else {
            result.factor *= *first;
            ++result.orders[static_cast<std::size_t>(first - direction.begin())];
        }
    }
    return result;
}

/// What is wanted of a map: its derivative in some directions, of a curve as often as there are directions.
struct Derivative {
    std::span<const Coordinates> directions;
    bool divided;  ///< of the map divided by its weight
    const Limits& limits;

    std::size_t order() const { return directions.size(); }
    std::vector<PatchPoint> vectors(const Patch& patch) const {
        std::vector<PatchPoint> list;
        for (const Coordinates& direction : directions) list.push_back(engine_arguments(patch, direction, 0));
        return list;
    }
};

struct DerivativeMap : Derivative {
    AnyMap operator()(const OnePolynomial auto& curve) const {
        const PolynomialMap map = polynomial_map(curve, limits);
        const PolynomialMap derived =
            divided ? rational_derivative_map(map, order(), limits) : derivative_map(map, order());
        return std::visit([](const auto& one) { return AnyMap(one); }, derived);
    }
    AnyMap operator()(const TaylorCurve& curve) const {
        const AnyMap derived = (*this)(monomial_form(curve, limits));
        return taylor_form(std::get<PolynomialCurve>(derived), curve.center, limits);
    }
    AnyMap operator()(const BSplineCurve& curve) const {
        return divided ? rational_derivative_curve(curve, order(), limits)
                       : derivative_curve(curve, order(), limits);
    }
    AnyMap operator()(Patch patch) const {
        const std::vector<PatchPoint> along = vectors(patch);
        const auto derived = [&](const auto& one) -> PatchMap {
            return divided ? rational_derivative_patch(one, along, limits)
                           : directional_derivative_patch(one, along, limits);
        };
        patch.map = std::visit(derived, patch.map);
        return patch;
    }
    AnyMap operator()(const TensorBSpline& spline) const {
        if (divided) {
            throw Error(
                ErrorCode::wrong_kind,
                R"(the derivative of rational B-splines in several directions is given at parameters, )"
                R"("at" is missing; or take the derivatives of its segments)",
                Place{"map"});
        }
        const auto [orders, factor] = partial_orders(spline.directions(), directions);
        const TensorBSpline derived = derivative_spline(spline, orders, limits);
        std::vector<Coordinates> points = derived.control_points();
        for (Coordinates& point : points) {
            for (Rational& coordinate : point) coordinate *= factor;
        }
        return TensorBSpline(derived.knots(), std::move(points));
    }
};

struct DerivativeValues : Derivative {
    const Parameters& parameters;

    std::vector<Coordinates> operator()(const OnePolynomial auto& curve) const {
        return on_line(polynomial_map(curve, limits));
    }
    std::vector<Coordinates> operator()(const BSplineCurve& curve) const { return on_line(curve); }
    std::vector<Coordinates> operator()(const Patch& patch) const {
        const std::vector<PatchPoint> along = vectors(patch);
        return at_each(parameters,
                       [&](std::span<const Rational> numbers) { return value(patch, along, numbers); });
    }
    std::vector<Coordinates> operator()(const TensorBSpline& spline) const {
        std::map<std::vector<std::size_t>, Patch> pieces;
        return at_each(parameters, [&](std::span<const Rational> numbers) {
            const auto spans = as_parameter(Part::at, [&] { return spans_at(spline, numbers); });
            auto piece = pieces.find(spans);
            if (piece == pieces.end()) piece = pieces.emplace(spans, segment(spline, spans, limits)).first;
            return value(piece->second, vectors(piece->second), numbers);
        });
    }

private:
    Coordinates value(const Patch& patch, std::span<const PatchPoint> along,
                      std::span<const Rational> numbers) const {
        const PatchPoint at = engine_arguments(patch, numbers, 1);
        return divided ? rational_derivative(patch.map, along, at, limits)
                       : directional_derivative(patch.map, along, at, limits);
    }
    std::vector<Coordinates> on_line(const auto& curve) const {
        return at_each(parameters, [&](std::span<const Rational> t) {
            return divided ? rational_derivative(curve, order(), t.front(), limits)
                           : derivative(curve, order(), t.front(), limits);
        });
    }
};

Answer derivative_of(Fields& request, const Map& map, const Limits& limits) {
    const ParameterForm parameter = parameter_form(map);
    const std::vector<Coordinates> directions = read_directions(request, parameter, limits);
    std::optional<Parameters> parameters;
    if (request.has("at")) parameters = read_parameters(request, parameter, limits);
    request.finish();
    const bool divided = map.form.separate_weights();
    const Derivative wanted{directions, divided, limits};
    if (!parameters) return answer_of(like(map, dispatch_on_kind<AnyMap>(map, DerivativeMap{wanted})));
    // The derivative of a rational map comes divided.
    const PointForm form = divided ? PointForm{.scalar = map.form.scalar} : map.form;
    within("at", [&] { require_numbers(parameters->size(), dimension_of(map), limits); });
    const auto values =
        dispatch_on_kind<std::vector<Coordinates>>(map, DerivativeValues{wanted, *parameters});
    return Json::Object{{"values", written_at(values, form)}};
}

Answer answer_derivative(Request& request, const Limits& limits) {
    return derivative_of(request, request.map(limits), limits);
}

/// P', P'', P''', P^(4), ...
std::string derivative_name(std::size_t order) {
    return order <= 3 ? "P" + std::string(order, '\'') : fmt::format("P^({})", order);
}

std::string render_derivative(const Answered& answered) {
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
    Answer derived = derivative_of(fields, answered.given(), answered.limits);
    derived.given = answered.answer.given;
    return show({answered.request, derived, answered.limits, answered.style});
}

}  // namespace

Operation derivative_operation() {
    return {
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
        .answer = answer_derivative,
        .render = render_derivative,
        .plot = of_derived_map<plot_of_result>,
        .mesh = of_derived_map<obj_of>,
    };
}

}  // namespace blossom::protocol
