// Values of tensor products of B-splines: evaluation, blossoms, derivatives.

#include <fmt/format.h>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include <algorithm>
#include <map>

#include "directions.hpp"
#include "evaluator.hpp"
#include "patch_answers.hpp"

namespace blossom::protocol {

namespace {

/// The spans at parameters that stand at a place of the request of their own.
std::vector<std::size_t> spans_at_own_place(const TensorBSpline& spline, const Coordinates& parameters) {
    return as_parameter(Part::at, [&] { return spans_at(spline, parameters); });
}

/// f(parameters) for every entry of "at".
template <class Function>
Json values_at_each(Fields& request, const TensorBSpline& spline, const PointForm& form, const Limits& limits,
                    const Function& f) {
    const auto points = request.required("at", [&](const Json& value) {
        return read_list(
            value, [&](const Json& element) { return read_tuple(element, spline.directions(), limits); });
    });
    request.finish();
    require_numbers(points.size(), spline.dimension(), limits);
    return written_at(points.size(), form, [&](std::size_t i) { return f(points[i]); });
}

/// The order of a derivative in each direction, and what multiplies it.
struct PartialOrders {
    std::vector<std::size_t> orders;
    Rational factor = 1;
};

PartialOrders partial_orders(std::size_t count, const std::vector<Coordinates>& directions) {
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

Map derived_map(const Map& map, const std::vector<Coordinates>& directions, const Limits& limits) {
    const TensorBSpline& spline = *tensor_bspline_of(map);
    if (map.form.separate_weights()) {
        throw Error(ErrorCode::wrong_kind,
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
    return like(map, TensorBSpline(derived.knots(), std::move(points)));
}

}  // namespace

Patch segment_patch(const TensorBSpline& spline, std::span<const std::size_t> spans, const Limits& limits) {
    PlacedPatch placed = placed_segment(spline, spans, limits);
    return {std::move(placed.patch), true, std::move(placed.frames), {}};
}

Map chosen_segment(Fields& request, const Map& map, const Limits& limits) {
    const TensorBSpline& spline = *tensor_bspline_of(map);
    auto spans = request.optional("segment", [&](const Json& value) {
        auto list = read_list(value, [&](const Json& element) { return read_index(element, limits); });
        if (list.size() == spline.directions()) return list;
        throw Error(ErrorCode::wrong_arity,
                    fmt::format("{} indices of knots for {} directions", list.size(), spline.directions()));
    });
    if (!spans) {
        spans.emplace();
        for (const KnotVector& knots : spline.knots()) spans->push_back(only_span(knots));
    }
    return {segment_patch(spline, *spans, limits), map.form, map.variable};
}

Json evaluate_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    const TensorBSpline& spline = *tensor_bspline_of(map);
    return Json::Object{
        {"values", values_at_each(request, spline, map.form, limits, [&](const Coordinates& parameters) {
             spans_at_own_place(spline, parameters);
             return evaluate(spline, parameters, limits);
         })}};
}

Answer derivative_of_tensor_bspline(Fields& request, const Map& map, const Limits& limits) {
    const TensorBSpline& spline = *tensor_bspline_of(map);
    const std::size_t count = spline.directions();
    const std::vector<Coordinates> directions = read_directions(
        request, count, limits, [&](const Json& value) { return read_tuple(value, count, limits); });
    if (!request.has("at")) {
        request.finish();
        return answer_of(derived_map(map, directions, limits));
    }
    const bool divided = map.form.separate_weights();
    std::map<std::vector<std::size_t>, Patch> pieces;
    const auto value = [&](const Coordinates& parameters) {
        const std::vector<std::size_t> spans = spans_at_own_place(spline, parameters);
        auto piece = pieces.find(spans);
        if (piece == pieces.end()) piece = pieces.emplace(spans, segment_patch(spline, spans, limits)).first;
        std::vector<PatchPoint> vectors;
        vectors.reserve(directions.size());
        for (const Coordinates& direction : directions)
            vectors.push_back(engine_arguments(piece->second, direction, 0));
        return derivative_value(piece->second, vectors, engine_arguments(piece->second, parameters, 1),
                                divided, limits);
    };
    const PointForm form = divided ? PointForm{.scalar = map.form.scalar} : map.form;
    return Json::Object{{"values", values_at_each(request, spline, form, limits, value)}};
}

}  // namespace blossom::protocol
