#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/core/spline/spline_split.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

namespace blossom {

std::pair<BSplineCurve, BSplineCurve> split(const BSplineCurve& curve, const Rational& u,
                                            const Limits& limits) {
    const Interval domain = curve.knots().domain();
    if (u <= domain.a() || domain.b() <= u) {
        throw Error(ErrorCode::outside_domain,
                    "the parameter " + to_string(u) + " does not lie strictly inside the domain [" +
                        to_string(domain.a()) + ", " + to_string(domain.b()) + "]",
                    Part::at);
    }
    const std::size_t n = curve.degree();
    const std::size_t multiplicity = curve.knots().multiplicity(u);
    const std::vector<Rational> missing(n - std::min(n, multiplicity), u);
    const BSplineCurve whole = insert_knots_boehm(curve, missing, limits);

    const auto& knots = whole.knots().knots();
    const auto& points = whole.control_points();
    const auto first = std::ranges::lower_bound(knots, u);
    const auto behind = std::ranges::upper_bound(knots, u);
    const std::size_t copies = whole.knots().convention() == KnotConvention::textbook ? n + 1 : n;
    std::vector<Rational> left(knots.begin(), first);
    left.insert(left.end(), copies, u);
    std::vector<Rational> right(copies, u);
    right.insert(right.end(), behind, knots.end());

    const auto points_over = [&](const std::vector<Rational>& part) {
        return part.size() + points.size() - knots.size();
    };
    const auto left_end = points.begin() + static_cast<std::ptrdiff_t>(points_over(left));
    const auto right_begin = points.end() - static_cast<std::ptrdiff_t>(points_over(right));
    return {BSplineCurve(n, std::move(left), {points.begin(), left_end}),
            BSplineCurve(n, std::move(right), {right_begin, points.end()})};
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
