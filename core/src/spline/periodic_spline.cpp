#include <blossom/core/curve/reparametrisation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/periodic_spline.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "spline_pieces.hpp"

namespace blossom {

std::pair<BezierCurve, BezierCurve> sides_of_seam(const BSplineCurve& curve, const Limits& limits) {
    const Interval domain = curve.knots().domain();
    const ParameterChange behind(domain, {domain.b(), domain.b() + domain.b() - domain.a()});
    const std::size_t last = curve.knots().span_before(domain.b());
    const std::size_t first = curve.knots().span_at(domain.a());
    return {sablonniere(curve, last, limits), reparametrised(sablonniere(curve, first, limits), behind)};
}

Contact seam_contact(const BSplineCurve& curve, const Limits& limits) {
    const auto [left, right] = sides_of_seam(curve, limits);
    return contact(left, right, right.interval().a(), limits);
}

std::size_t seam_multiplicity(std::size_t degree, const Contact& contact, const Rational& seam) {
    if (contact.is_infinite()) return 1;
    if (*contact.order < 0) {
        throw Error(ErrorCode::not_continuous, "the curve is not closed. " + to_string(contact, seam),
                    Part::map);
    }
    return degree - static_cast<std::size_t>(*contact.order);
}

BSplineCurve over_periodic_knots(const BSplineCurve& curve, std::size_t m, const Limits& limits) {
    const KnotVector& old = curve.knots();
    const std::size_t n = old.degree();
    if (m < 1 || m > std::max<std::size_t>(n, 1)) {
        throw Error(ErrorCode::bad_knots,
                    "the seam of a periodic curve of degree " + std::to_string(n) + " is a knot 1 to " +
                        std::to_string(std::max<std::size_t>(n, 1)) + " times, not " + std::to_string(m));
    }
    const Interval domain = old.domain();
    const Rational period = domain.b() - domain.a();
    // One period, from the last knot at the beginning of the domain to the last but one at its end.
    std::vector<Rational> cycle{domain.a()};
    const auto& knots = old.knots();
    cycle.insert(cycle.end(), std::ranges::upper_bound(knots, domain.a()),
                 std::ranges::lower_bound(knots, domain.b()));
    const std::size_t end = cycle.size();
    cycle.insert(cycle.end(), m - 1, domain.b());

    const std::size_t outside = old.convention() == KnotConvention::textbook ? n : n - 1;
    const std::size_t turns = outside / cycle.size() + 1;
    std::vector<Rational> periodic;
    periodic.reserve(end + 1 + 2 * outside);
    for (std::size_t i = turns * cycle.size() - outside; i <= turns * cycle.size() + end + outside; ++i) {
        const Rational turn = Rational(i / cycle.size()) - Rational(turns);
        periodic.push_back(cycle[i % cycle.size()] + turn * period);
    }
    return spline_of_pieces({n, std::move(periodic), end + n}, bezier_segments(curve, limits), limits);
}

}  // namespace blossom
