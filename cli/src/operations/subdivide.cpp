#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/spline/spline_split.hpp>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/serve.hpp"
#include "patch_answers.hpp"
#include "surface/obj.hpp"
#include "svg/plot.hpp"
#include "table.hpp"

namespace blossom::cli {

namespace {

using TwoMaps = std::pair<AnyMap, AnyMap>;

struct Subdivide {
    const Rational& t;
    const Limits& limits;

    TwoMaps operator()(const BezierCurve& curve) const {
        return within("at", [&] { return subdivide(curve, t, limits); });
    }
    TwoMaps operator()(const OnePolynomial auto& curve) const {
        const PolynomialMap map = polynomial_map(curve, limits);
        return std::visit(
            [&](const auto& one) { return (*this)(control_points(one, own_interval(curve), limits)); }, map);
    }
    TwoMaps operator()(const BSplineCurve& curve) const { return split(curve, t, limits); }
};

Json answer(Fields& request, const Limits& limits) {
    const Map map = read_map_field(request, limits);
    if (patch_of(map)) return subdivide_patch(request, map, limits);
    if (tensor_bspline_of(map)) return subdivide_tensor_bspline(request, map, limits);
    const Rational t = request.required("at", [&](const Json& value) { return read_number(value, limits); });
    request.finish();
    const auto [left, right] = serve<TwoMaps>(map, Subdivide{t, limits});
    Json::Array maps;
    for (const AnyMap& part : {left, right}) {
        maps.push_back(within("at", [&] { return to_json(Map{part, map.form, map.variable}); }));
    }
    return Json::Object{{"maps", std::move(maps)}};
}

}  // namespace

Operation subdivide_operation() {
    return {
        .name = "subdivide",
        .summary = "Split a curve or patch at a parameter",
        .example = {"subdivide", "--control-points", "0,0; 1,2; 3,0", "--at", "1/3"},
        .options = with_map_options({field_option(
            "--at", "at", "T",
            "the parameter, which may lie outside the interval of a Bezier curve; for a simplex a point or "
            "\"midpoints\", for a tensor product a number or - per direction",
            plain_text, place_of_division)}),
        .answer = answer,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::cli
