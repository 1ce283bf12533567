#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/spline_elevation.hpp>

#include <algorithm>
#include <span>

#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "maps/parameters.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct Elevate {
    std::span<const std::size_t> by;  ///< one number per factor
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        const auto raised = [&](const auto& one) -> AnyMap { return elevate(one, by[0], limits); };
        return std::visit(raised, polynomial_map(curve, limits));
    }
    AnyMap operator()(const BSplineCurve& curve) const { return elevate(curve, by[0], limits); }
    AnyMap operator()(const TaylorCurve& curve) const {
        return taylor_form(elevate(monomial_form(curve, limits), by[0], limits), curve.center, limits);
    }
    AnyMap operator()(Patch patch) const {
        for (std::size_t f = 0; f < by.size(); ++f) {
            const auto raised = [&](const auto& one) -> PatchMap { return elevate(one, f, by[f], limits); };
            patch.map = std::visit(raised, patch.map);
        }
        return patch;
    }
    AnyMap operator()(TensorBSpline spline) const {
        for (std::size_t d = 0; d < by.size(); ++d) spline = elevate(spline, d, by[d], limits);
        return spline;
    }
};

/// A number, or one per direction.
std::vector<std::size_t> read_by(const Json& value, const ParameterForm& form, const Limits& limits) {
    const auto read = [&](const Json& element) { return read_count(element, limits); };
    if (form.scalar || !value.array()) return std::vector(form.factors, read(value));
    return read_each_direction(value, form.factors, "numbers", read);
}

Answer answer_elevate(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    const auto by = request.required(
        "by", [&](const Json& value) { return read_by(value, parameter_form(map), limits); });
    request.finish();
    require_numbers(std::ranges::max(by), dimension_of(map), limits);
    return answer_of(like(map, dispatch_on_kind<AnyMap>(map, Elevate{by, limits})));
}

Json degrees_to_raise_by(std::string_view text, const Json&) {
    return text.find(',') == std::string_view::npos ? count(text) : number_list(text);
}

}  // namespace

Operation elevate_operation() {
    return {
        .summary = "Raise the degree of a map without changing it",
        .documentation =
            "The kind of the map stays, except that a progressive or hermite map becomes a bezier map.",
        .request = {{map_field(), required("by", Shape::one_of({ValueKind::count, counts_shape()}),
                                           "by how much to raise the degree; for a tensor product it may be "
                                           "one number per direction")}},
        .result = {{map_member("the same map with its degree raised")}},
        .example = {"elevate", "--control-points", "0; 3; 0", "--by", "2"},
        .options = with_map_options({field_option("--by", "by", "R", count, degrees_to_raise_by)}),
        .answer = answer_elevate,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
