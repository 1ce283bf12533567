#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/spline_elevation.hpp>
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

struct ControlPoints {
    std::optional<std::size_t> degree;
    std::optional<Interval> interval;
    const Limits& limits;

    AnyMap operator()(const PolynomialCurve& curve) const {
        const std::size_t formal = degree.value_or(curve.degree());
        return control_points(
            formal == curve.degree() ? curve : PolynomialCurve(coordinates_of(curve), formal),
            interval.value_or(Interval()), limits);
    }
    AnyMap operator()(const BezierCurve& curve) const {
        const Interval wanted = interval.value_or(curve.interval());
        if (degree && *degree != curve.degree()) {
            return ControlPoints{degree, wanted, limits}(monomial_form(curve, limits));
        }
        return curve.interval() == wanted ? curve : control_points(curve, wanted, limits);
    }
    AnyMap operator()(const OnePolynomial auto& curve) const {
        return std::visit(*this, polynomial_map(curve, limits));
    }
    AnyMap operator()(const Samples& samples) const { return (*this)(curve_of_samples(samples, limits)); }
    /// A Bezier curve where there is only one polynomial, otherwise a spline.
    AnyMap operator()(const BSplineCurve& curve) const {
        BSplineCurve part =
            interval ? within("interval", [&] { return restricted(curve, *interval, limits); }) : curve;
        if (part.knots().spans().size() == 1) return (*this)(bezier_segments(part, limits).front());
        if (!degree || *degree == part.degree()) return part;
        if (*degree > part.degree()) return elevate(part, *degree - part.degree(), limits);
        throw Error(ErrorCode::degree_too_low, "the spline has degree " + std::to_string(part.degree()),
                    Place{"degree"});
    }
};

Answer control_points_of_curve(Fields& request, const Map& map, const Limits& limits) {
    const auto interval =
        request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    const auto degree =
        request.optional("degree", [&](const Json& value) { return read_count(value, limits); });
    request.finish();
    require_numbers(degree.value_or(0) + 1, dimension_of(map), limits);

    return answer_of(like(map, dispatch_on_kind<AnyMap>(map, ControlPoints{degree, interval, limits})));
}

/// A B-spline has to say its degree, so that --degree says this one.
void apply_degree(Json& request, const std::vector<std::string>& values, const Limits&) {
    Json& owner = has_knots(request) ? request["map"] : request;
    owner["degree"] = count(values.front());
}

}  // namespace

Operation control_points_operation() {
    return {
        .name = "control-points",
        .summary = "Compute the control points of a map over any interval, simplex or box",
        .documentation =
            "A spline becomes its part over the interval, a Bezier curve where this is one polynomial.",
        .request =
            {{map_field()},
             {{{optional("interval", ValueKind::interval,
                         "for a curve: the interval; by default that of the map, [0, 1] for a polynomial")},
               {vertices_field()},
               {intervals_field()}},
              {{optional("degree", ValueKind::count, "the new formal degree; by default that of the map")},
               {degrees_field()}}}},
        .result = {{map_member("the map with its control points")}},
        .example = {"control-points", "1 + 2t + 4t^2 - t^3", "--interval", "2,-1"},
        .options = with_map_options({
            own_interval_option(
                "the interval of the given control points, or else of the new ones; by default 0,1"),
            field_option("--over", "interval", "A,B", number_list, "the interval of the new control points"),
            field_option("--vertices", "vertices", "P0;P1;...", tuple_list),
            field_option("--intervals", "intervals", "A,B;C,D;...", tuple_list),
            {"--degree",
             {"degree"},
             "N",
             "the new formal degree, by default that of the map; with --knots the degree of the spline",
             apply_degree},
            wanted_degrees_option(),
        }),
        .answer =
            answer_by_shape<control_points_of_curve, control_net_of_patch, control_net_of_tensor_bspline>,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
