#include <fmt/format.h>
#include <blossom/core/blossom/polar.hpp>

#include <algorithm>

#include "common_domain.hpp"
#include "listing.hpp"
#include "map_list.hpp"
#include "map_options.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

constexpr std::size_t outer_place = 0;
constexpr std::size_t inner_place = 1;

CommonMaps map_at(const std::vector<Map>& maps, std::size_t i, const Limits& limits) {
    try {
        return on_own_domain(maps[i], limits);
    } catch (const Error& error) {
        throw error.at(Place{"maps"} / i);
    }
}

/// The homogeneous argument of each factor of `outer` at a point u = (u_1, ..., u_d) of mass 1, or at (w u,
/// w): linear in its coordinates.
CoordinateSums argument_sums(const Patch& outer, bool rational) {
    const std::size_t dimension = outer.shape().dimension();
    const CoordinateProduct mass = rational ? CoordinateProduct{{{0, dimension}}} : CoordinateProduct{};
    CoordinateSums sums;
    std::size_t coordinate = 0;
    for (std::size_t f = 0; f < outer.shape().factors(); ++f) {
        const std::size_t own = outer.shape()[f].dimension;
        Coordinates u(own);
        std::vector<Coordinates> columns{engine_argument(outer, f, u, 1)};  // of the mass, u_1, u_2, ...
        for (Rational& number : u) {
            number = 1;
            columns.push_back(engine_argument(outer, f, u, 0));
            number = 0;
        }
        for (std::size_t k = 0; k <= own; ++k) {
            CoordinateSum& sum = sums.emplace_back();
            for (std::size_t j = 0; j < columns.size(); ++j) {
                CoordinateProduct product = j == 0 ? mass : CoordinateProduct{{{0, coordinate + j - 1}}};
                product.factor = columns[j][k];
                if (!product.factor.is_zero()) sum.push_back(std::move(product));
            }
        }
        coordinate += own;
    }
    return sums;
}

/// The segment of a B-spline in which all values of the inner map lie, by its control points.
Patch segment_with_values(const TensorBSpline& outer, const CommonMaps& inner, const Limits& limits) {
    if (std::holds_alternative<std::vector<PolynomialPatch>>(inner.maps)) {
        throw Error(
            ErrorCode::outside_domain,
            "a polynomial takes values outside the domain of a B-spline; over an interval or a box it "
            "can be composed with one",
            Place{"maps"} / inner_place);
    }
    std::vector<std::vector<Rational>> values(outer.directions());
    for (const PlacedPatch& piece : nets_of(inner, limits)) {
        for (const Coordinates& point : piece.patch.control_net().to_points()) {
            const Rational weight = inner.forms.front().rational ? point.back() : Rational(1);
            if (weight.sign() <= 0) {
                throw Error(ErrorCode::zero_weight,
                            "weights that are not positive do not bound the values of the inner map",
                            Place{"maps"} / inner_place);
            }
            for (std::size_t d = 0; d < values.size(); ++d) values[d].push_back(point[d] / weight);
        }
    }
    std::vector<std::size_t> spans;
    for (std::size_t d = 0; d < values.size(); ++d) {
        const KnotVector& knots = outer.knots(d);
        const auto [least, greatest] = std::ranges::minmax_element(values[d]);
        const std::size_t span = [&] {
            try {
                return knots.span_at(*least);
            } catch (const Error& error) {
                throw error.at(Place{"maps"} / inner_place);
            }
        }();
        if (*greatest > knots[span + 1]) {
            throw Error(
                ErrorCode::outside_domain,
                fmt::format("the control points of the inner map reach from {} to {} in direction {}, "
                            "across the knot {} of the outer one; its parts on one side can be composed",
                            to_string(*least), to_string(*greatest), d, to_string(knots[span + 1])),
                Place{"maps"} / inner_place);
        }
        spans.push_back(span);
    }
    return segment(outer, spans, limits);
}

/// The map with the weight 1.
PatchMap with_weight_one(const PatchMap& map, const Limits& limits) {
    const auto extended = [&](const auto& one) -> PatchMap {
        const std::vector<Rational> factors{1};
        CoordinateSums sums = linear_combination(factors, one.dimension());
        sums.push_back({CoordinateProduct{}});
        const auto raised = combined(std::span(&one, 1), sums, limits);
        return raised;
    };
    return std::visit(extended, map);
}

Answer answer_compose(Request& request, const Limits& limits) {
    const std::vector<Map> maps = read_maps_field(request, limits);
    request.finish();
    if (maps.size() != 2) {
        throw Error(ErrorCode::wrong_arity,
                    fmt::format("a composition is one of two maps, not of {}", maps.size()), Place{"maps"});
    }
    const CommonMaps outer = map_at(maps, outer_place, limits);
    const CommonMaps inner = map_at(maps, inner_place, limits);
    const auto* splines = std::get_if<std::vector<TensorBSpline>>(&outer.maps);
    if (!splines && patch_of(outer).is_barycentric()) {
        throw Error(ErrorCode::wrong_kind,
                    "the parameters of the outer map are barycentric; \"vertices\" make them points",
                    Place{"maps"} / outer_place);
    }
    if (inner.dimension(0) != parameters_of(outer)) {
        throw Error(ErrorCode::mismatched_dimensions,
                    fmt::format("the inner map has {} coordinates, and the outer one {} parameters",
                                inner.dimension(0), parameters_of(outer)),
                    Place{"maps"} / inner_place);
    }
    Patch patch = splines ? segment_with_values(splines->front(), inner, limits) : patch_of(outer);
    const bool rational = inner.forms.front().rational;
    PointForm form = outer.forms.front();
    if (rational && !form.rational) patch.map = with_weight_one(patch.map, limits);
    form.rational = form.rational || rational;
    const CoordinateSums sums = argument_sums(patch, rational);
    const auto compose = [&](const auto& one, const auto& list) -> CommonMap {
        const auto arguments = combined(std::span(&list.front(), 1), sums, limits);
        return composed(one, arguments, limits);
    };
    return answer_of(
        within("maps", [&] { return map_of(inner, std::visit(compose, patch.map, inner.maps), form); }),
        "maps");
}

}  // namespace

Operation compose_operation() {
    return {
        .summary =
            "Compose two maps: a curve with a change of parameter, or a patch with a curve in its domain",
        .documentation =
            "The degree is the product of the degree of the inner map and all degrees of the outer one "
            "together.",
        .request = {{maps_field(
            "the outer map, and the inner one, whose points are parameters of the outer")}},
        .result = {{map_member("the composition, over the domain of the inner map")}},
        .example = {"compose", R"({"kind": "bezier", "control_points": [[0, 0], [1, 2], [3, 0]]})", "t^2"},
        .options = {maps_option("MAP",
                                "the two maps, the outer one first: polynomials, maps of the protocol, a "
                                "list of them, or the output of other commands")},
        .answer = answer_compose,
        .render = described_listing,
        .plot = plot_of_result,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
