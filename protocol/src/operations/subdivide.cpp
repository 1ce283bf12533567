#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/subdivision.hpp>
#include <blossom/core/spline/spline_split.hpp>

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

using TwoMaps = std::pair<AnyMap, AnyMap>;

struct Subdivide {
    const Rational& t;
    const Limits& limits;

    TwoMaps operator()(const BezierCurve& curve) const {
        return within("at", [&] { return subdivide(curve, t, limits); });
    }
    TwoMaps operator()(const OnePolynomial auto& curve) const {
        return (*this)(control_points(polynomial_map(curve, limits), interval_of(curve), limits));
    }
    TwoMaps operator()(const BSplineCurve& curve) const { return split(curve, t, limits); }
};

Answer subdivide_curve(Fields& request, const Map& map, const Limits& limits) {
    const Rational t = request.required("at", [&](const Json& value) { return read_number(value, limits); });
    request.finish();
    auto [left, right] = dispatch_on_kind<TwoMaps>(map, Subdivide{t, limits});
    return answer_of(std::vector{like(map, std::move(left)), like(map, std::move(right))}, "at");
}

}  // namespace

Operation subdivide_operation() {
    return {
        .name = "subdivide",
        .summary = "Split a curve or patch at a parameter",
        .documentation =
            "The parameter may lie outside the interval of a Bezier curve, but in the domain of a B-spline.",
        .request = {{map_field(),
                     required(
                         "at", Shape::one_of({ValueKind::number, Shape::words({"midpoints"}), cut_shape()}),
                         "the parameter; for a simplex a point or midpoints, for a tensor product a number "
                         "or null per direction")}},
        .result = {{maps_member("the parts")}},
        .example = {"subdivide", "--control-points", "0,0; 1,2; 3,0", "--at", "1/3"},
        .options = with_map_options({field_option(
            "--at", "at", "T", plain_text, place_of_division,
            "the parameter, which may lie outside the interval of a Bezier curve; for a simplex a point or "
            "\"midpoints\", for a tensor product a number or - per direction")}),
        .answer = answer_by_shape<subdivide_curve, subdivide_patch, subdivide_tensor_bspline>,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
