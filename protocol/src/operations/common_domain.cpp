#include "common_domain.hpp"

#include <fmt/format.h>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/patch/partial_derivatives.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>

#include <algorithm>
#include <numeric>

#include "text/readable.hpp"

namespace blossom::protocol {

namespace {

/// A map of any kind as one on a product of simplices.
struct OnFactors {
    CommonMap map;
    bool is_curve = false;
    bool tensor = true;
    std::vector<BarycentricFrame> frames = {};
    std::vector<std::string> variables = {};
};

std::vector<BarycentricFrame> frame_of(const Interval& interval) {
    return {BarycentricFrame({{interval.a()}, {interval.b()}})};
}

struct AsOnFactors {
    const Limits& limits;

    OnFactors operator()(const OnePolynomial auto& curve) const {
        const PolynomialMap map = polynomial_map(curve, limits);
        if (const auto* polynomial = std::get_if<PolynomialCurve>(&map)) return {as_patch(*polynomial), true};
        const auto& bezier = std::get<BezierCurve>(map);
        return {as_patch(bezier), true, true, frame_of(bezier.interval())};
    }
    OnFactors operator()(const BSplineCurve& curve) const {
        return {TensorBSpline({curve.knots()}, curve.control_points()), true};
    }
    OnFactors operator()(const Patch& patch) const {
        const auto as_common = [](const auto& one) -> CommonMap { return one; };
        return {std::visit(as_common, patch.map), false, patch.tensor, patch.frames, patch.variables};
    }
    OnFactors operator()(const TensorBSpline& spline) const { return {spline}; }
};

/// The dimension of each factor of the domain.
std::vector<std::size_t> dimensions_of(const CommonMap& map) {
    if (const auto* spline = std::get_if<TensorBSpline>(&map))
        return std::vector<std::size_t>(spline->directions(), 1);
    std::vector<std::size_t> dimensions;
    const NetShape& shape = std::holds_alternative<BezierPatch>(map) ? std::get<BezierPatch>(map).shape()
                                                                     : std::get<PolynomialPatch>(map).shape();
    for (std::size_t f = 0; f < shape.factors(); ++f) dimensions.push_back(shape[f].dimension);
    return dimensions;
}

std::string text_of_domain(std::span<const BarycentricFrame> frames) {
    std::string text;
    for (const BarycentricFrame& frame : frames) {
        std::string vertices;
        for (const Coordinates& vertex : frame.vertices()) {
            const std::string own = vertex.size() == 1
                                        ? to_string(vertex[0])
                                        : point_text(Json(Json::Array(vertex.begin(), vertex.end())));
            vertices += (vertices.empty() ? "" : ", ") + own;
        }
        text += fmt::format("{}[{}]", text.empty() ? "" : " x ", vertices);
    }
    return text;
}

/// The frames of the spans of a whole B-spline.
std::vector<BarycentricFrame> box_of_spline(const TensorBSpline& spline) {
    std::vector<BarycentricFrame> frames;
    for (const KnotVector& knots : spline.knots()) frames.push_back(frame_of(knots.domain()).front());
    return frames;
}

/// The domain of a map that has one; barycentric nets have none.
std::vector<BarycentricFrame> domain_of(const OnFactors& map) {
    const auto* spline = std::get_if<TensorBSpline>(&map.map);
    return spline ? box_of_spline(*spline) : map.frames;
}

bool is_free(const OnFactors& map) { return std::holds_alternative<PolynomialPatch>(map.map); }
bool is_spline(const OnFactors& map) { return std::holds_alternative<TensorBSpline>(map.map); }

bool are_same_simplices(std::span<const BarycentricFrame> left, std::span<const BarycentricFrame> right) {
    return std::ranges::equal(left, right, [](const BarycentricFrame& one, const BarycentricFrame& other) {
        return std::ranges::is_permutation(one.vertices(), other.vertices());
    });
}

std::string domain_text(std::span<const BarycentricFrame> frames) {
    return frames.empty() ? "a simplex without \"vertices\"" : text_of_domain(frames);
}

[[noreturn]] void refuse_domains(std::string_view own, std::span<const BarycentricFrame> others) {
    throw Error(ErrorCode::outside_domain,
                fmt::format("{} and {} are different domains; maps on one domain are needed",
                            domain_text(others), own));
}

/// The net over other frames of the same simplices. Errors: `outside_domain`.
BezierPatch net_over(const OnFactors& map, std::span<const BarycentricFrame> frames, const Limits& limits) {
    const auto* polynomial = std::get_if<PolynomialPatch>(&map.map);
    if (polynomial && !frames.empty()) return control_net(*polynomial, frames, limits);
    if (polynomial || !are_same_simplices(map.frames, frames)) {
        refuse_domains(polynomial ? "the domain of a polynomial" : domain_text(map.frames), frames);
    }
    BezierPatch net = std::get<BezierPatch>(map.map);
    for (std::size_t f = 0; f < frames.size(); ++f) {
        std::vector<Coordinates> elements;
        for (const Coordinates& vertex : frames[f].vertices())
            elements.push_back(map.frames[f].of_point(vertex));
        net = with_frame(net, f, elements, limits);
    }
    return net;
}

/// All maps as the function represents each; the place of an error is the index of the map.
template <class Represent>
auto each_as(std::span<const OnFactors> maps, const Place& place, const Represent& represent) {
    std::vector<std::invoke_result_t<const Represent&, const OnFactors&>> list;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        try {
            list.push_back(represent(maps[i]));
        } catch (const Error& error) {
            throw error.at(place / i);
        }
    }
    return list;
}

void require_same_parameters(std::span<const OnFactors> maps, const Place& place) {
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (dimensions_of(maps[i].map) == dimensions_of(maps[0].map) && maps[i].tensor == maps[0].tensor)
            continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("the domain of map {} is of another kind than that of map 0; curves go with "
                                "curves, boxes with boxes of as many directions, and simplices with "
                                "simplices of the same dimension",
                                i),
                    place / i);
    }
}

/// The weight of each map: that of the first map with the same weight.
template <class CommonRepresentation>
std::vector<std::optional<CoordinateOf>> weights_of(std::span<const CommonRepresentation> maps,
                                                    std::span<const PointForm> forms) {
    const auto weight_of = [](const auto& map) {
        const CoordinateSums last{{{{{0, map.dimension() - 1}}}}};
        return combined(std::span(&map, 1), last);
    };
    std::vector<std::optional<CoordinateOf>> weights(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (!forms[i].rational) continue;
        weights[i] = CoordinateOf{i, maps[i].dimension() - 1};
        for (std::size_t k = 0; k < i; ++k) {
            if (!weights[k] || weights[k]->map != k || weight_of(maps[k]) != weight_of(maps[i])) continue;
            weights[i] = weights[k];
            break;
        }
    }
    return weights;
}

bool has_point_at_infinity(const CommonMap& map) {
    const auto is_zero_weight = [](const Coordinates& point) { return point.back().is_zero(); };
    if (const auto* spline = std::get_if<TensorBSpline>(&map))
        return std::ranges::any_of(spline->control_points(), is_zero_weight);
    const auto* net = std::get_if<BezierPatch>(&map);
    return net && std::ranges::any_of(net->control_net().to_points(), is_zero_weight);
}

Map combined_in_form(const CommonMaps& given, std::span<const CoordinateSum> sums, PointForm form,
                     const Limits& limits) {
    const auto combine = [&](const auto& maps) -> CommonMap {
        return combined(std::span(maps), sums, limits);
    };
    CommonMap result = std::visit(combine, given.maps);
    form.homogeneous = std::ranges::any_of(given.forms, &PointForm::homogeneous);
    return map_of(given, std::move(result), form);
}

}  // namespace

std::size_t CommonMaps::dimension(std::size_t i) const {
    const std::size_t all = std::visit([&](const auto& list) { return list[i].dimension(); }, maps);
    return all - (forms[i].rational ? 1 : 0);
}

void require_points_alike(const CommonMaps& given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given.dimension(i) == given.dimension(0)) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("the points of map {} have {} coordinates, those of map 0 {}", i,
                                given.dimension(i), given.dimension(0)),
                    Place{"maps"} / i);
    }
}

CommonMaps on_common_domain(std::span<const Map> maps, const Limits& limits) {
    const Place place{"maps"};
    if (maps.empty()) throw Error(ErrorCode::wrong_arity, "at least one map is needed", place);
    std::vector<OnFactors> list;
    CommonMaps common;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const auto samples = [&](const Samples& one) {
            return AsOnFactors{limits}(curve_of_samples(one, limits));
        };
        const Overloads represent{AsOnFactors{limits}, samples};
        list.push_back(dispatch_on_kind<OnFactors>(maps[i], represent, place / i));
        common.forms.push_back(maps[i].form);
        common.are_curves = common.are_curves && list.back().is_curve;
        if (common.variables.empty()) common.variables = list.back().variables;
    }
    common.tensor = list.front().tensor;
    common.variable = maps.front().variable;
    require_same_parameters(list, place);
    const auto first_net = std::ranges::find_if_not(list, is_free);
    if (first_net == list.end()) {
        common.maps =
            each_as(list, place, [](const OnFactors& map) { return std::get<PolynomialPatch>(map.map); });
        return common;
    }
    const auto spline = std::ranges::find_if(list, is_spline);
    common.frames = domain_of(spline == list.end() ? *first_net : *spline);
    if (spline == list.end()) {
        common.maps =
            each_as(list, place, [&](const OnFactors& map) { return net_over(map, common.frames, limits); });
        return common;
    }
    common.maps = each_as(list, place, [&](const OnFactors& map) {
        if (!is_spline(map)) return bspline_of({net_over(map, common.frames, limits), common.frames}, limits);
        if (domain_of(map) != common.frames) refuse_domains(domain_text(domain_of(map)), common.frames);
        return std::get<TensorBSpline>(map.map);
    });
    return common;
}

CommonMaps on_own_domain(const Map& map, const Limits& limits) {
    try {
        return on_common_domain(std::span(&map, 1), limits);
    } catch (const Error& error) {
        throw error.at(Place{"map"});
    }
}

CommonMaps with_partial_derivatives(const CommonMaps& given, const Limits& limits) {
    CommonMaps result = given;
    const Overloads derive{
        [&](const PolynomialPatch& patch) { result.maps = with_partial_derivatives(patch, limits); },
        [&](const BezierPatch& patch) {
            if (given.frames.empty()) {
                throw Error(ErrorCode::wrong_kind,
                            "barycentric coordinates have no partial derivatives; \"vertices\" give points "
                            "their coordinates",
                            Place{"map"});
            }
            result.maps = with_partial_derivatives(patch, given.frames, limits);
        },
        [&](const TensorBSpline& spline) { result.maps = with_partial_derivatives(spline, limits); },
    };
    std::visit([&](const auto& maps) { derive(maps.front()); }, given.maps);
    const std::size_t count = std::visit([](const auto& maps) { return maps.size(); }, result.maps);
    result.forms.assign(count, given.forms.front());
    return result;
}

std::size_t parameters_of(const CommonMaps& given) {
    const auto dimensions =
        std::visit([](const auto& maps) { return dimensions_of(CommonMap(maps.front())); }, given.maps);
    return std::accumulate(dimensions.begin(), dimensions.end(), std::size_t{0});
}

Patch patch_of(const CommonMaps& given) {
    if (const auto* nets = std::get_if<std::vector<BezierPatch>>(&given.maps))
        return {nets->front(), given.tensor, given.frames, {}};
    return {std::get<std::vector<PolynomialPatch>>(given.maps).front(), given.tensor, {}, given.variables};
}

std::vector<PlacedPatch> nets_of(const CommonMaps& given, const Limits& limits) {
    std::vector<PlacedPatch> pieces;
    if (const auto* splines = std::get_if<std::vector<TensorBSpline>>(&given.maps)) {
        for (const auto& box : boxes_of(splines->front(), limits))
            pieces.push_back(placed_segment(splines->front(), box, limits));
        return pieces;
    }
    const Patch patch = patch_of(given);
    if (const auto* net = std::get_if<BezierPatch>(&patch.map); net && patch.frames.empty()) {
        std::vector<Coordinates> units(net->shape()[0].dimension + 1,
                                       Coordinates(net->shape()[0].dimension + 1));
        for (std::size_t k = 0; k < units.size(); ++k) units[k][k] = 1;
        return {{*net, {BarycentricFrame(std::move(units))}}};
    }
    const std::vector<BarycentricFrame> frames = domain_or_standard(patch);
    const Overloads as_net{
        [](const BezierPatch& net) { return net; },
        [&](const PolynomialPatch& polynomial) { return control_net(polynomial, frames, limits); },
    };
    return {{std::visit(as_net, patch.map), frames}};
}

Map map_of(const CommonMaps& given, CommonMap value, PointForm form) {
    form.homogeneous = form.rational && (form.homogeneous || has_point_at_infinity(value));
    form.scalar = form.scalar && !form.homogeneous;
    const auto as_any = Overloads{
        [&](PolynomialPatch patch) -> AnyMap {
            if (given.are_curves) return PolynomialCurve(patch.coefficients());
            return Patch{std::move(patch), given.tensor, {}, given.variables};
        },
        [&](BezierPatch patch) -> AnyMap {
            if (given.are_curves) {
                const auto& ends = given.frames.front().vertices();
                return BezierCurve(patch.control_net(), Interval(ends[0][0], ends[1][0]));
            }
            return Patch{std::move(patch), given.tensor, given.frames, {}};
        },
        [&](TensorBSpline spline) -> AnyMap {
            if (given.are_curves) return BSplineCurve(spline.knots(0), spline.control_points());
            return spline;
        },
    };
    return {std::visit(as_any, std::move(value)), form, given.variable};
}

Map combined_map(const CommonMaps& given, CoordinateSums sums, bool scalar, const Limits& limits) {
    const bool rational = std::ranges::any_of(given.forms, &PointForm::rational);
    if (!rational) return combined_in_form(given, sums, {.scalar = scalar}, limits);
    const auto weights =
        std::visit([&](const auto& maps) { return weights_of(std::span(maps), given.forms); }, given.maps);
    return combined_rational_map(given, projective(std::move(sums), weights), scalar, limits);
}

Map combined_rational_map(const CommonMaps& given, const CoordinateSums& sums, bool scalar,
                          const Limits& limits) {
    return combined_in_form(given, sums, {.scalar = scalar, .rational = true}, limits);
}

}  // namespace blossom::protocol
