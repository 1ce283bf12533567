#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/core/spline/spline_split.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace blossom {

namespace {

/// The same curve with a knot at u as often as it takes to have a control point there.
BSplineCurve with_full_knot(const BSplineCurve& curve, const Rational& u, const Limits& limits) {
    const std::size_t n = curve.degree();
    const std::vector<Rational> missing(n - std::min(n, curve.knots().multiplicity(u)), u);
    return insert_knots(curve, missing, limits);
}

/// How often the end of a clamped curve is a knot.
std::size_t end_multiplicity(const KnotVector& knots) {
    return knots.degree() + (knots.convention() == KnotConvention::textbook ? 1 : 0);
}

/// How many of the control points belong to these knots out of those of the curve.
std::size_t points_over(const std::vector<Rational>& part, const BSplineCurve& curve) {
    return part.size() + curve.control_points().size() - curve.knots().size();
}

/// The beginning of the curve up to a full knot, which ends it.
BSplineCurve up_to(const BSplineCurve& curve, const Rational& u) {
    const auto& knots = curve.knots().knots();
    std::vector<Rational> part(knots.begin(), std::ranges::lower_bound(knots, u));
    part.insert(part.end(), end_multiplicity(curve.knots()), u);
    const auto begin = curve.control_points().begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(points_over(part, curve));
    return {curve.degree(), std::move(part), {begin, end}};
}

/// The rest of the curve from a full knot on.
BSplineCurve from(const BSplineCurve& curve, const Rational& u) {
    const auto& knots = curve.knots().knots();
    std::vector<Rational> part(end_multiplicity(curve.knots()), u);
    part.insert(part.end(), std::ranges::upper_bound(knots, u), knots.end());
    const auto end = curve.control_points().end();
    const auto begin = end - static_cast<std::ptrdiff_t>(points_over(part, curve));
    return {curve.degree(), std::move(part), {begin, end}};
}

}  // namespace

std::pair<BSplineCurve, BSplineCurve> split(const BSplineCurve& curve, const Rational& u,
                                            const Limits& limits) {
    const Interval domain = curve.knots().domain();
    if (u <= domain.a() || domain.b() <= u) {
        throw Error(ErrorCode::outside_domain,
                    "the parameter " + to_string(u) + " does not lie strictly inside the domain [" +
                        to_string(domain.a()) + ", " + to_string(domain.b()) + "]",
                    Part::at);
    }
    const BSplineCurve whole = with_full_knot(curve, u, limits);
    return {up_to(whole, u), from(whole, u)};
}

BSplineCurve clamped(const BSplineCurve& curve, const Limits& limits) {
    const Interval domain = curve.knots().domain();
    const BSplineCurve beginning = up_to(with_full_knot(curve, domain.b(), limits), domain.b());
    return from(with_full_knot(beginning, domain.a(), limits), domain.a());
}

BSplineCurve trimmed(const BSplineCurve& curve, const Interval& interval, const Limits& limits) {
    return clamped(restricted(curve, interval, limits), limits);
}

BSplineCurve restricted(const BSplineCurve& curve, const Interval& interval, const Limits& limits) {
    const Interval domain = curve.knots().domain();
    const Rational& a = interval.a();
    const Rational& b = interval.b();
    if (a < domain.a() || domain.b() < b || b < a) {
        throw Error(ErrorCode::outside_domain, "[" + to_string(a) + ", " + to_string(b) +
                                                   "] is not an increasing interval within the domain [" +
                                                   to_string(domain.a()) + ", " + to_string(domain.b()) +
                                                   "]");
    }
    const BSplineCurve part = b < domain.b() ? split(curve, b, limits).first : curve;
    return domain.a() < a ? split(part, a, limits).second : part;
}

}  // namespace blossom
