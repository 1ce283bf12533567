#include <fmt/format.h>
#include <blossom/core/blossom/polar.hpp>
#include <blossom/core/patch/spline_restriction.hpp>

#include <algorithm>

#include "common_domain.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/parameters.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// The only map of a list in one of the representations.
CommonMap only_map(const CommonMaps& given) {
    return std::visit([](const auto& maps) -> CommonMap { return maps.front(); }, given.maps);
}

template <class Element>
void erase_at(std::vector<Element>& list, std::size_t index) {
    if (index < list.size()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

/// The map at t in direction d.
CommonMap fixed_at(const CommonMaps& given, std::size_t d, const Rational& t, const Limits& limits) {
    if (const auto* splines = std::get_if<std::vector<TensorBSpline>>(&given.maps))
        return within(d, [&] { return isoparametric(splines->front(), d, t, limits); });
    const Patch patch = patch_of(given);
    const Coordinates argument = engine_argument(patch, d, std::span(&t, 1), 1);
    return std::visit([&](const auto& one) -> CommonMap { return isoparametric(one, d, argument, limits); },
                      patch.map);
}

/// The map at one number in some directions.
Map isoparametric_map(CommonMaps given, std::span<const std::optional<Rational>> at, const PointForm& form,
                      const Limits& limits) {
    for (std::size_t d = at.size(); d-- > 0;) {
        if (!at[d]) continue;
        std::visit([&]<class One>(One one) { given.maps = std::vector<One>{std::move(one)}; },
                   fixed_at(given, d, *at[d], limits));
        erase_at(given.frames, d);
        erase_at(given.variables, d);
    }
    given.are_curves = std::ranges::count_if(at, [](const auto& number) { return !number; }) == 1;
    if (given.are_curves && !given.variables.empty()) given.variable = given.variables.front();
    return map_of(given, only_map(given), form);
}

Answer restrict_at(Request& request, const CommonMaps& given, const PointForm& form, const Limits& limits) {
    const std::size_t directions = parameters_of(given);
    const auto at = request.required("at", [&](const Json& value) {
        if (given.are_curves || !given.tensor) {
            throw Error(ErrorCode::wrong_kind,
                        "numbers in some directions are those of a tensor product; \"vertices\" restrict any "
                        "map");
        }
        auto numbers = read_some_directions(value, directions, limits);
        const auto is_free = [](const std::optional<Rational>& entry) { return !entry; };
        if (std::ranges::none_of(numbers, is_free) || std::ranges::all_of(numbers, is_free)) {
            throw Error(ErrorCode::wrong_arity,
                        "there is a number in some directions, and null in the others");
        }
        return numbers;
    });
    request.finish();
    return answer_of(within("at", [&] { return isoparametric_map(given, at, form, limits); }));
}

/// The box of spans that contains the simplex.
Patch segment_around(const TensorBSpline& spline, std::span<const Coordinates> vertices,
                     const Limits& limits) {
    Coordinates center(spline.directions());
    for (const Coordinates& vertex : vertices) {
        for (std::size_t d = 0; d < center.size(); ++d) center[d] += vertex[d] / Rational(vertices.size());
    }
    const std::vector<std::size_t> spans = as_parameter(Part::at, [&] { return spans_at(spline, center); });
    const std::vector<Interval> box = box_of(spline, spans);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        for (std::size_t d = 0; d < box.size(); ++d) {
            if (box[d].a() <= vertices[i][d] && vertices[i][d] <= box[d].b()) continue;
            throw Error(ErrorCode::outside_domain,
                        fmt::format("the simplex lies in several segments of the B-spline, and knot {} of "
                                    "direction {} divides it; only a line may cross knots",
                                    to_string(vertices[i][d] < box[d].a() ? box[d].a() : box[d].b()), d),
                        Place{i});
        }
    }
    return segment(spline, spans, limits);
}

/// On the simplex with these vertices; a segment is over the interval.
Map restricted_map(const CommonMaps& given, std::span<const Coordinates> vertices, const Interval& interval,
                   const PointForm& form, const Limits& limits) {
    CommonMaps domain;
    domain.are_curves = vertices.size() == 2;
    domain.tensor = domain.are_curves;
    if (domain.are_curves) domain.frames = {BarycentricFrame({{interval.a()}, {interval.b()}})};
    const auto* splines = std::get_if<std::vector<TensorBSpline>>(&given.maps);
    if (splines && domain.are_curves) {
        for (std::size_t i = 0; i < vertices.size(); ++i)
            within(i, [&] { as_parameter(Part::at, [&] { spans_at(splines->front(), vertices[i]); }); });
        const BSplineCurve curve = restricted(splines->front(), vertices[0], vertices[1], interval, limits);
        return map_of(domain, TensorBSpline({curve.knots()}, curve.control_points()), form);
    }
    const Patch patch = splines ? segment_around(splines->front(), vertices, limits) : patch_of(given);
    std::vector<PatchPoint> points;
    for (const Coordinates& vertex : vertices) points.push_back(engine_arguments(patch, vertex, 1));
    const auto restrict_one = [&](const auto& one) -> CommonMap { return restricted(one, points, limits); };
    return map_of(domain, std::visit(restrict_one, patch.map), form);
}

Answer restrict_to_simplex(Request& request, const CommonMaps& given, const Map& map, const Limits& limits) {
    const ParameterForm parameter = parameter_form(map);
    const auto vertices = request.required("vertices", [&](const Json& value) {
        auto list = read_list(
            value, [&](const Json& vertex) { return read_parameter(vertex, parameter, 1, limits); });
        if (list.size() >= 2) return list;
        throw Error(ErrorCode::wrong_arity, "a segment has two vertices, and a simplex more than two");
    });
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    request.finish();
    if (interval && vertices.size() > 2) {
        throw Error(ErrorCode::wrong_kind, "an interval is that of a curve, on a segment with two vertices",
                    Place{"interval"});
    }
    return answer_of(within("vertices", [&] {
        return restricted_map(given, vertices, interval.value_or(Interval()), map.form, limits);
    }));
}

Answer answer_restrict(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const CommonMaps given = on_own_domain(map, limits);
    return request.has("at") ? restrict_at(request, given, map.form, limits)
                             : restrict_to_simplex(request, given, map, limits);
}

Json vertices_of(std::string_view text) { return number_list(text); }
Json vertices_of_patch(std::string_view text, const Json&) { return tuple_list(text); }
Json numbers_or_free(std::string_view text) { return place_of_division(text, {}); }

}  // namespace

Operation restrict_operation() {
    return {
        .summary = "Restrict a map to a face, edge, diagonal, isoparametric curve, or any segment or simplex",
        .documentation = "The control points of the restriction are means of blossom values at its vertices.",
        .request = {{map_field()},
                    {{{required("vertices", parameters_shape(),
                                "points of the domain, the vertices of a segment, triangle or simplex"),
                       optional("interval", ValueKind::interval,
                                "of a segment: the interval of the curve; by default `[0, 1]`")},
                      {required("at", cut_shape(),
                                "of a tensor product: one number per direction, or null where the parameter "
                                "stays free")}}}},
        .result = {{map_member("the restriction")}},
        .example = {"restrict", "x^2*y + y", "--variables", "x,y", "--vertices", "0,0; 1,1"},
        .options = with_map_options({
            field_option("--vertices", "vertices", "V0;V1;...", vertices_of, vertices_of_patch),
            own_interval_option(
                "the interval of the given control points, by default 0,1, or else that of the curve on a "
                "segment"),
            field_option("--over", "interval", "A,B", number_list),
            field_option("--at", "at", "X,Y,...", numbers_or_free,
                         "of a tensor product: one number per direction, or - where the parameter stays "
                         "free"),
        }),
        .answer = answer_restrict,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
