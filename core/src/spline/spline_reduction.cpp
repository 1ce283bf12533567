#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/core/spline/spline_reduction.hpp>

#include <algorithm>
#include <vector>

namespace blossom {

namespace {

/// The properties of the reduced knot vector that are known in advance.
struct Target {
    std::size_t degree;
    std::size_t lost;       ///< the difference of the degrees
    std::size_t end_knots;  ///< the least number of knots up to the beginning of the domain
};

/// The knots on one side of the domain, the end itself last; `outside` lists those outside, ordered away from
/// the domain when read backwards.
std::vector<Rational> end_knots(const Target& target, std::vector<Rational> outside, const Rational& end,
                                std::size_t multiplicity) {
    const bool kept = multiplicity > target.lost && outside.size() < target.end_knots;
    if (!kept) return std::vector<Rational>(target.end_knots, end);
    outside.insert(outside.end(), multiplicity - target.lost, end);
    return outside;
}

/// The multiplicity that the knot between two pieces needs.
std::size_t needed_multiplicity(const BezierCurve& left, const BezierCurve& right, std::size_t m,
                                const Limits& limits) {
    const Contact joined = contact(left, right, right.interval().a(), limits);
    return joined.is_infinite() ? 0
                                : static_cast<std::size_t>(static_cast<std::ptrdiff_t>(m) - *joined.order);
}

KnotVector reduced_knots(const KnotVector& old, std::size_t m, const std::vector<BezierCurve>& pieces,
                         const Limits& limits) {
    const bool textbook = old.convention() == KnotConvention::textbook || m == 0;
    const Target target{m, old.degree() - m, m + (textbook ? 1 : 0)};
    const Interval domain = old.domain();
    const auto& all = old.knots();
    const auto begin = std::ranges::lower_bound(all, domain.a());
    const auto end = std::ranges::upper_bound(all, domain.b());

    std::vector<Rational> knots = end_knots(target, std::vector<Rational>(all.begin(), begin), domain.a(),
                                            old.multiplicity(domain.a()));
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const Rational& joint = pieces[i].interval().a();
        const std::size_t multiplicity = old.multiplicity(joint);
        const std::size_t kept = multiplicity - std::min(multiplicity, target.lost);
        const std::size_t needed = needed_multiplicity(pieces[i - 1], pieces[i], m, limits);
        knots.insert(knots.end(), std::max(kept, needed), joint);
    }
    const std::vector<Rational> last =
        end_knots(target, std::vector<Rational>(all.rbegin(), std::make_reverse_iterator(end)), domain.b(),
                  old.multiplicity(domain.b()));
    knots.insert(knots.end(), last.rbegin(), last.rend());
    const std::size_t points = textbook ? knots.size() - m - 1 : knots.size() + 1 - m;
    return {m, std::move(knots), points};
}

}  // namespace

SplineReduction reduce(const BSplineCurve& curve, std::size_t m, ReductionMethod method,
                       const Limits& limits) {
    bool exact = true;
    Rational l2_squared;
    Coordinates maximum;
    std::vector<BezierCurve> pieces = bezier_segments(curve, limits);
    for (BezierCurve& piece : pieces) {
        Reduction reduction = reduce(piece, m, method, limits);
        exact = exact && reduction.exact;
        l2_squared += reduction.l2_squared;
        maximum.resize(reduction.maximum.size());
        for (std::size_t j = 0; j < maximum.size(); ++j) {
            maximum[j] = std::max(maximum[j], reduction.maximum[j]);
        }
        piece = std::move(reduction.curve);
    }
    if (m == curve.degree()) return {curve, exact, l2_squared, std::move(maximum)};
    return {join(pieces, reduced_knots(curve.knots(), m, pieces, limits), limits), exact, l2_squared,
            std::move(maximum)};
}

}  // namespace blossom
