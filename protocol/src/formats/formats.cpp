#include "formats.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>

#include "foreign_formats.hpp"
#include "maps/dispatch_on_kind.hpp"

namespace blossom::protocol {

namespace {

const ForeignFormat* const formats[] = {&tinyspline_format, &geomdl_format,  &splinepy_format,
                                        &mfem_format,       &fitpack_format, &svg_format};

/// The outermost knots, on which no point of the map depends, are equal to their neighbours where these may
/// occur once more.
KnotVector textbook(const KnotVector& own) {
    if (own.convention() == KnotConvention::textbook) return own;
    const std::vector<KnotMultiplicity> distinct = own.distinct();
    const auto room = [&](const KnotMultiplicity& end) { return end.multiplicity <= own.degree(); };
    std::vector<Rational> knots{distinct.front().knot - Rational(room(distinct.front()) ? 0 : 1)};
    knots.insert(knots.end(), own.knots().begin(), own.knots().end());
    knots.push_back(distinct.back().knot + Rational(room(distinct.back()) ? 0 : 1));
    return {own.degree(), std::move(knots), own.points()};
}

AnyMap textbook_spline(std::vector<KnotVector> knots, std::vector<Coordinates> points) {
    for (KnotVector& own : knots) own = textbook(own);
    if (knots.size() == 1) return BSplineCurve(std::move(knots.front()), std::move(points));
    return TensorBSpline(std::move(knots), std::move(points));
}

/// The points of a net with the order of one direction reversed.
std::vector<Coordinates> reversed_in(const std::vector<Coordinates>& points, const NetShape& shape,
                                     std::size_t direction) {
    std::size_t stride = 1;
    for (std::size_t f = direction + 1; f < shape.factors(); ++f) stride *= shape.count(f);
    const std::size_t count = shape.count(direction);
    std::vector<Coordinates> reversed;
    reversed.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t index = i / stride % count;
        reversed.push_back(points[i + (count - 1 - index) * stride - index * stride]);
    }
    return reversed;
}

AnyMap spline_of_patch(const Patch& patch, const Limits& limits) {
    if (!patch.tensor) {
        throw Error(ErrorCode::wrong_kind,
                    "a file has tensor products, and this patch is over a simplex; \"degrees\" instead of "
                    "\"degree\" make a polynomial a tensor product");
    }
    const std::vector<BarycentricFrame> frames = domain_or_standard(patch);
    const auto* polynomial = std::get_if<PolynomialPatch>(&patch.map);
    const BezierPatch net =
        polynomial ? control_net(*polynomial, frames, limits) : std::get<BezierPatch>(patch.map);
    std::vector<Coordinates> points = net.control_net().to_points();
    std::vector<KnotVector> knots;
    for (std::size_t d = 0; d < frames.size(); ++d) {
        const Rational& a = frames[d].vertices()[0][0];
        const Rational& b = frames[d].vertices()[1][0];
        if (b < a) points = reversed_in(points, net.shape(), d);
        const std::size_t order = net.shape().count(d);
        std::vector<Rational> ends(order, std::min(a, b));
        ends.insert(ends.end(), order, std::max(a, b));
        knots.emplace_back(order - 1, std::move(ends), order);
    }
    return textbook_spline(std::move(knots), std::move(points));
}

}  // namespace

std::vector<std::string_view> format_names() { return mapped(formats, &ForeignFormat::name); }

const ForeignFormat& read_format(const Json& name) {
    return *formats[read_alternative(name, format_names(), "a format")];
}

bool may_be_text(const Json& format_name) {
    const std::string* name = format_name.text();
    return name && std::ranges::any_of(formats, [&](const ForeignFormat* format) {
               return format->name == *name && format->text;
           });
}

std::vector<ForeignSpline> read_document(const ForeignFormat& format, const Json& document, Floats floats,
                                         const Limits& limits) {
    if (floats == Floats::binary64 || document.text()) return format.read(document, floats, limits);
    return format.read(with_decimals(document, limits), floats, limits);
}

Map as_foreign_spline(const ForeignFormat& format, const Map& map, const Limits& limits) {
    const auto of_polynomial = [&](const OnePolynomial auto& curve) -> AnyMap {
        const BezierCurve bezier = control_points(polynomial_map(curve, limits), interval_of(curve), limits);
        return join(std::span(&bezier, 1), limits);
    };
    const auto of_spline = [](const BSplineCurve& curve) {
        return textbook_spline({curve.knots()}, curve.control_points());
    };
    const auto of_net = [](const TensorBSpline& spline) {
        return textbook_spline(spline.knots(), spline.control_points());
    };
    const auto of_patch = [&](const Patch& patch) { return spline_of_patch(patch, limits); };
    Map spline = like(
        map, dispatch_on_kind<AnyMap>(map, Overloads{of_polynomial, of_spline, of_net, of_patch}, Place()));
    if (format.curves_only && knots_of(spline).size() > 1) {
        throw Error(ErrorCode::wrong_kind, "a file of " + std::string(format.name) +
                                               " has curves, and this map has " +
                                               std::to_string(knots_of(spline).size()) + " directions");
    }
    if (map.form.homogeneous) spline.form = {.scalar = false, .rational = format.weights};
    return spline;
}

}  // namespace blossom::protocol
