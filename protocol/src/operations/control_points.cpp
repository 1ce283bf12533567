#include <fmt/format.h>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/spline_elevation.hpp>
#include <blossom/core/spline/spline_split.hpp>

#include "control_nets.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "shared_fields.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

struct CurvePoints {
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
            return CurvePoints{degree, wanted, limits}(monomial_form(curve, limits));
        }
        return curve.interval() == wanted ? curve : control_points(curve, wanted, limits);
    }
    AnyMap operator()(const OnePolynomial auto& curve) const {
        return std::visit(*this, polynomial_map(curve, limits));
    }
    AnyMap operator()(const Samples& samples) const { return (*this)(curve_of_samples(samples, limits)); }
    /// A Bezier curve if there is only one polynomial, otherwise a spline.
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

/// The part of a map over intervals, one per direction.
TensorBSpline part_of(TensorBSpline spline, std::span<const Interval> intervals, const Limits& limits) {
    within("intervals", [&] {
        for (std::size_t d = 0; d < intervals.size(); ++d) {
            within(d, [&] {
                as_parameter(Part::at, [&] { spline = restricted(spline, d, intervals[d], limits); });
            });
        }
    });
    return spline;
}

TensorBSpline elevated_to(TensorBSpline spline, std::span<const std::size_t> degrees, const Limits& limits) {
    for (std::size_t d = 0; d < degrees.size(); ++d) {
        const std::size_t own = spline.knots(d).degree();
        if (degrees[d] < own) {
            throw Error(
                ErrorCode::degree_too_low,
                fmt::format("the B-splines of direction {} have degree {}, above {}", d, own, degrees[d]),
                Place{"degrees"} / d);
        }
        spline = elevate(spline, d, degrees[d] - own, limits);
    }
    return spline;
}

/// Reads the domain and the degree of the control points.
struct ControlPoints {
    Fields& request;
    const Limits& limits;

    /// Curves.
    template <class Curve>
        requires std::is_invocable_v<const CurvePoints&, const Curve&>
    AnyMap operator()(const Curve& curve) const {
        const auto interval =
            request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
        const auto degree =
            request.optional("degree", [&](const Json& value) { return read_count(value, limits); });
        request.finish();
        require_numbers(degree.value_or(0) + 1, curve.dimension(), limits);
        return CurvePoints{degree, interval, limits}(curve);
    }
    AnyMap operator()(const Patch& patch) const { return net_over(request, patch, {}, limits); }
    /// A tensor map if there is only one polynomial, otherwise a spline.
    AnyMap operator()(const TensorBSpline& spline) const {
        const auto each = [&](std::string_view name, const auto& read) {
            return request.optional(name, [&](const Json& value) {
                return read_each_direction(value, spline.directions(), name,
                                           [&](const Json& element) { return read(element, limits); });
            });
        };
        const auto intervals = each("intervals", read_interval);
        const auto degrees = each("degrees", read_count);
        request.finish();
        TensorBSpline part = intervals ? part_of(spline, *intervals, limits) : spline;
        if (degrees) part = elevated_to(std::move(part), *degrees, limits);
        std::vector<std::size_t> spans;
        for (const KnotVector& knots : part.knots()) {
            const std::vector<std::size_t> own = knots.spans();
            if (own.size() > 1) return part;
            spans.push_back(own.front());
        }
        return segment(part, spans, limits);
    }
};

Answer answer_control_points(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    return answer_of(like(map, dispatch_on_kind<AnyMap>(map, ControlPoints{request, limits})));
}

/// A B-spline states its own degree, so --degree is the degree of the result.
void apply_degree(Json& request, const std::vector<std::string>& values, const Limits&) {
    Json& owner = has_knots(request) ? request["map"] : request;
    owner["degree"] = count(values.front());
}

}  // namespace

Operation control_points_operation() {
    return {
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
        .answer = answer_control_points,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
