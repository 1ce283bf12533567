#include "certified_curve.hpp"

#include <fmt/format.h>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>

#include "maps/dispatch_on_kind.hpp"
#include "segment.hpp"

namespace blossom::protocol {

namespace {

/// Claim k: point k = multiple(k) n!/(n-order)! p(arguments(k), delta^order).
template <class Arguments, class Multiple>
std::vector<CertifiedValue> claims(const StatedValues& about, const PointArray& points, std::string_view name,
                                   const Arguments& arguments, const Multiple& multiple) {
    const std::size_t vectors = std::min(about.order, about.degree);
    std::vector<CertifiedValue> list;
    for (const Coordinates& point : points.to_points()) {
        const std::size_t k = list.size();
        std::vector<Argument> all = arguments(k);
        // Derivatives of an order above the degree are zero: 0 times any value.
        all.resize(std::min(all.size(), about.degree - vectors), delta);
        list.push_back({fmt::format("{} {}", name, k), with_copies(std::move(all), vectors, delta),
                        falling_factorial(about.degree, about.order) * multiple(k), point});
    }
    return list;
}

Integer once(std::size_t) { return 1; }

struct GivenCurve {
    std::optional<std::size_t> span;
    const Limits& limits;

    CertifiedMap operator()(const PolynomialCurve& curve) const { return {curve, {}}; }
    CertifiedMap operator()(const OnePolynomial auto& curve) const {
        CertifiedMap given{monomial_form(polynomial_map(curve, limits), limits), {}};
        given.values = StatedValues{given.curve.degree(), 0}(curve);
        for (CertifiedValue& value : given.values) value.name.insert(0, "given ");
        return given;
    }
    CertifiedMap operator()(const BSplineCurve& curve) const {
        return (*this)(segment(curve, chosen_span(curve, span)));
    }
};

}  // namespace

std::vector<CertifiedValue> StatedValues::operator()(const BezierCurve& curve) const {
    const std::size_t m = curve.degree();
    const auto arguments = [&](std::size_t k) {
        return with_copies(with_copies({}, m - k, Parameter(curve.interval().a())), k,
                           Parameter(curve.interval().b()));
    };
    return claims(*this, curve.control_points(), "control point", arguments, once);
}

std::vector<CertifiedValue> StatedValues::operator()(const ProgressiveCurve& curve) const {
    const auto arguments = [&](std::size_t k) {
        std::vector<Argument> window;
        for (const Rational& knot : std::span(curve.knots()).subspan(k, curve.degree()))
            window.emplace_back(Parameter(knot));
        return window;
    };
    return claims(*this, curve.control_points(), "control point", arguments, once);
}

std::vector<CertifiedValue> StatedValues::operator()(const TaylorCurve& curve) const {
    const std::size_t m = curve.coefficients.size() - 1;
    const auto arguments = [&](std::size_t k) {
        return with_copies(with_copies({}, m - k, Parameter(curve.center)), k, delta);
    };
    return claims(*this, curve.coefficients, "coefficient", arguments,
                  [m](std::size_t k) { return binomial(m, k); });
}

std::vector<CertifiedValue> StatedValues::operator()(const PolynomialCurve& curve) const {
    return (*this)(TaylorCurve{Rational(0), curve.coefficients()});
}

CertifiedMap certified_map(const Map& map, std::optional<std::size_t> span, const Limits& limits) {
    return dispatch_on_kind<CertifiedMap>(map, GivenCurve{span, limits});
}

}  // namespace blossom::protocol
