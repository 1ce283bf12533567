#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/spline/spline_elevation.hpp>

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

struct Elevate {
    std::size_t by;
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        const auto raised = [&](const auto& one) -> AnyMap { return elevate(one, by, limits); };
        return std::visit(raised, polynomial_map(curve, limits));
    }
    AnyMap operator()(const BSplineCurve& curve) const { return elevate(curve, by, limits); }
    AnyMap operator()(const TaylorCurve& curve) const {
        return taylor_form(elevate(monomial_form(curve, limits), by, limits), curve.center, limits);
    }
};

Answer elevate_curve(Fields& request, const Map& map, const Limits& limits) {
    const std::size_t by =
        request.required("by", [&](const Json& value) { return read_count(value, limits); });
    request.finish();
    require_numbers(by, dimension_of(map), limits);
    return answer_of(like(map, dispatch_on_kind<AnyMap>(map, Elevate{by, limits})));
}

Json degrees_to_raise_by(std::string_view text, const Json&) {
    return text.find(',') == std::string_view::npos ? count(text) : number_list(text);
}

}  // namespace

Operation elevate_operation() {
    return {
        .name = "elevate",
        .summary = "Raise the degree of a map without changing it",
        .documentation =
            "The kind of the map stays, except that a progressive or hermite map becomes a bezier map.",
        .request = {{map_field(), required("by", Shape::one_of({ValueKind::count, counts_shape()}),
                                           "by how much to raise the degree; for a tensor product it may be "
                                           "one number per direction")}},
        .result = {{map_member("the same map with its degree raised")}},
        .example = {"elevate", "--control-points", "0; 3; 0", "--by", "2"},
        .options = with_map_options({field_option("--by", "by", "R", count, degrees_to_raise_by)}),
        .answer = answer_by_shape<elevate_curve, elevate_patch, elevate_tensor_bspline>,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
