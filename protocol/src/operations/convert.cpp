#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <algorithm>

#include "json/nearest_name.hpp"
#include "listing.hpp"
#include "map_options.hpp"
#include "maps/dispatch_on_kind.hpp"
#include "patch_answers.hpp"
#include "pictures/obj.hpp"
#include "pictures/plot.hpp"
#include "segment.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

enum class Basis { monomial, bernstein, taylor, bspline };
constexpr std::string_view basis_names[] = {"monomial", "bernstein", "taylor", "bspline"};

Basis read_basis(const Json& value) {
    return static_cast<Basis>(read_alternative(value, basis_names, "a basis"));
}

struct Conversion {
    Basis to = Basis::monomial;
    std::optional<Interval> interval;
    Rational center;
    std::optional<std::size_t> span;
    const Limits& limits;

    AnyMap operator()(const OnePolynomial auto& curve) const {
        return converted(polynomial_map(curve, limits), interval.value_or(own_interval(curve)));
    }
    AnyMap operator()(const Samples& samples) const { return (*this)(curve_of_samples(samples, limits)); }
    AnyMap operator()(const BSplineCurve& curve) const {
        if (to == Basis::bspline && !span && !interval) return curve;
        return (*this)(segment(curve, chosen_span(curve, span)));
    }

private:
    AnyMap converted(const PolynomialMap& map, const Interval& wanted) const {
        switch (to) {
            case Basis::monomial:
                return monomial_curve(map, limits);
            case Basis::taylor:
                return taylor_form(monomial_curve(map, limits), center, limits);
            case Basis::bernstein:
                return bernstein(map, wanted);
            case Basis::bspline:
                break;
        }
        const BezierCurve curve = bernstein(map, wanted);
        return join(std::span(&curve, 1), limits);
    }
    BezierCurve bernstein(const PolynomialMap& map, const Interval& wanted) const {
        return std::visit([&](const auto& one) { return control_points(one, wanted, limits); }, map);
    }
};

Answer answer(Request& request, const Limits& limits) {
    const Map& map = request.map(limits);
    if (patch_of(map)) return convert_patch(request, map, limits);
    if (tensor_bspline_of(map)) return convert_tensor_bspline(request, map, limits);
    const Basis to = request.required("to", read_basis);
    std::optional<Interval> interval;
    std::optional<Rational> center;
    if (to == Basis::taylor) {
        center = request.optional("center", [&](const Json& value) { return read_number(value, limits); });
    } else if (to != Basis::monomial) {
        interval =
            request.optional("interval", [&](const Json& value) { return read_interval(value, limits); });
    }
    const auto span = read_span(request, map, limits);
    request.finish();
    const Conversion conversion{to, interval, center.value_or(0), span, limits};
    return answer_of(like(map, serve<AnyMap>(map, conversion)));
}

}  // namespace

Operation convert_operation() {
    return {
        .name = "convert",
        .summary =
            "Convert a map to another basis or form: monomial, Bernstein, Taylor, B-spline, tensor, simplex",
        .example = {"convert", "--control-points", "1; 5/3; 11/3; 6", "--to", "monomial"},
        .options = with_map_options({
            field_option("--to", "to", "monomial|bernstein|taylor|bspline|tensor|simplex",
                         "the new basis; tensor and simplex are forms of patches", plain_text),
            own_interval_option(
                "the interval of the given control points, or else of the new ones; by default 0,1"),
            field_option("--over", "interval", "A,B", "the interval of the new control points", number_list),
            field_option("--center", "center", "A", "the centre of the powers for taylor; by default 0",
                         plain_text),
            field_option("--vertices", "vertices", "P0;P1;...",
                         "for a patch: the vertices of the new simplex", tuple_list),
            field_option("--intervals", "intervals", "A,B;C,D;...", "for a patch: the new box", tuple_list),
            wanted_degrees_option(),
            segment_option(),
        }),
        .answer = answer,
        .render = described_listing,
        .plot = plot_of_maps,
        .mesh = obj_of,
    };
}

}  // namespace blossom::protocol
