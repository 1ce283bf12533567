#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

#include "knot_weights.hpp"
#include "progressive_frame.hpp"

namespace blossom {

namespace {

[[noreturn]] void refuse(ErrorCode code, std::size_t i, const Rational& knot, const std::string& rule) {
    throw Error(code, "knot " + std::to_string(i) + " to insert (" + to_string(knot) + ") " + rule,
                Part::knots / i);
}

void require_inside(const Interval& domain, std::size_t i, const Rational& knot) {
    if (domain.a() <= knot && knot <= domain.b()) return;
    refuse(ErrorCode::outside_domain, i, knot,
           "lies outside the domain [" + to_string(domain.a()) + ", " + to_string(domain.b()) + "]");
}

/// The knots to insert in order, each of them legal.
std::vector<Rational> in_order(const KnotVector& knots, std::span<const Rational> inserted) {
    std::vector<std::size_t> order(inserted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return inserted[i] < inserted[j]; });

    const Interval domain = knots.domain();
    std::vector<Rational> sorted;
    sorted.reserve(inserted.size());
    std::size_t multiplicity = 0;
    for (const std::size_t i : order) {
        const Rational& knot = inserted[i];
        require_inside(domain, i, knot);
        const bool repeated = !sorted.empty() && sorted.back() == knot;
        multiplicity = (repeated ? multiplicity : knots.multiplicity(knot)) + 1;
        if (multiplicity > knots.degree() + 1) {
            refuse(ErrorCode::bad_knots, i, knot,
                   "would have multiplicity " + std::to_string(multiplicity) +
                       ", more than degree + 1 = " + std::to_string(knots.degree() + 1));
        }
        sorted.push_back(knot);
    }
    return sorted;
}

void require_size(const BSplineCurve& curve, std::size_t inserted, const Limits& limits) {
    require_within(inserted, limits.numbers, "numbers", "the number of knots to insert", Part::knots);
    const std::size_t points = curve.control_points().size() + inserted;
    require_within(points * curve.dimension(), limits.numbers, "numbers", "the number of coordinates",
                   Part::knots);
}

/// A curve that is refined up to a moving position, and is still `curve` behind it.
class Refinement {
public:
    Refinement(const BSplineCurve& curve, std::size_t inserted, const Limits& limits)
        : curve_(curve), limits_(limits) {
        knots_.reserve(curve.knots().size() + inserted);
        points_.reserve(curve.control_points().size() + inserted);
    }

    /// One step of Boehm's algorithm; knots must come in order. A knot at the end of the domain is put before
    /// its equals, so that the span to its left is the last one.
    void insert(const Rational& knot) {
        const KnotVector& old = curve_.knots();
        const bool at_end = knot == old[old.end_index()];
        while (at_end ? old[old_knots_] < knot : old_knots_ < old.size() && old[old_knots_] <= knot) {
            knots_.push_back(old[old_knots_++]);
        }
        const std::size_t first = knots_.size() - 1 - old.begin_index();
        const std::size_t n = curve_.degree();
        while (points_.size() <= first + n) points_.push_back(curve_.control_points()[old_points_++]);

        points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(first + n), points_[first + n]);
        for (std::size_t l = n; l-- > 0;) {
            const Rational& end = l < at_end_ ? knot : old[old_knots_ + l - at_end_];
            const KnotWeights weights(knots_[knots_.size() - n + l], end, knot);
            Coordinates& point = points_[first + 1 + l];
            weights.combine(points_[first + l], point, point, limits_);
        }
        if (at_end) {
            ++at_end_;
        } else {
            knots_.push_back(knot);
        }
    }

    BSplineCurve finish() && {
        const KnotVector& old = curve_.knots();
        knots_.insert(knots_.end(), at_end_, old[old.end_index()]);
        while (old_knots_ < old.size()) knots_.push_back(old[old_knots_++]);
        while (old_points_ < curve_.control_points().size())
            points_.push_back(curve_.control_points()[old_points_++]);
        return {curve_.degree(), std::move(knots_), std::move(points_)};
    }

private:
    const BSplineCurve& curve_;
    const Limits& limits_;
    std::vector<Rational> knots_;
    std::vector<Coordinates> points_;
    std::size_t old_knots_ = 0;   ///< the number of knots of the curve in `knots_`
    std::size_t old_points_ = 0;  ///< the number of points of the curve in `points_`
    std::size_t at_end_ = 0;      ///< the number of knots inserted at the end of the domain
};

/// The old and the inserted knots in increasing order. Of equal knots the old ones come first, except at the
/// end of the domain, where they come last.
struct MergedKnots {
    std::vector<Rational> knots;
    std::vector<bool> inserted;  ///< whether the knot is an inserted one
};

MergedKnots merged(const KnotVector& knots, std::span<const Rational> inserted) {
    const Rational& end = knots[knots.end_index()];
    MergedKnots result;
    std::size_t next = 0;
    const auto take_inserted = [&] {
        result.knots.push_back(inserted[next++]);
        result.inserted.push_back(true);
    };
    for (const Rational& knot : knots.knots()) {
        while (next < inserted.size() && (inserted[next] < knot || (inserted[next] == end && knot == end))) {
            take_inserted();
        }
        result.knots.push_back(knot);
        result.inserted.push_back(false);
    }
    return result;
}

}  // namespace

BSplineCurve insert_knots(const BSplineCurve& curve, std::span<const Rational> knots, const Limits& limits) {
    // By measurement at degrees 3 and 10: Boehm's algorithm reduces each point once per inserted knot that it
    // depends on.
    constexpr std::size_t least_per_segment = 6;
    const std::size_t segments = curve.control_points().size() - curve.degree();
    const bool many = knots.size() / segments >= least_per_segment;
    return (many ? insert_knots_oslo : insert_knots_boehm)(curve, knots, limits);
}

BSplineCurve insert_knots_boehm(const BSplineCurve& curve, std::span<const Rational> knots,
                                const Limits& limits) {
    require_size(curve, knots.size(), limits);
    Refinement refinement(curve, knots.size(), limits);
    for (const Rational& knot : in_order(curve.knots(), knots)) refinement.insert(knot);
    return std::move(refinement).finish();
}

BSplineCurve insert_knots_oslo(const BSplineCurve& curve, std::span<const Rational> knots,
                               const Limits& limits) {
    require_size(curve, knots.size(), limits);
    const KnotVector& old = curve.knots();
    const std::size_t n = curve.degree();
    auto [all, inserted] = merged(old, in_order(old, knots));
    KnotVector finer(n, std::move(all), old.points() + knots.size());

    std::vector<Coordinates> points;
    points.reserve(finer.points());
    std::optional<ProgressiveFrame> frame;
    std::size_t frame_span = 0;
    std::size_t before_window = 0;
    std::size_t counted = 0;
    std::optional<std::size_t> last_inserted;
    for (std::size_t j = 0; j < finer.points(); ++j) {
        const std::size_t begin = finer.window_index(j);
        for (; counted < begin; ++counted) before_window += static_cast<std::size_t>(inserted[counted]);
        for (std::size_t i = begin; i < begin + n; ++i) {
            if (inserted[i]) last_inserted = i;
        }
        if (!last_inserted || *last_inserted < begin) {
            points.push_back(curve.control_points()[j - before_window]);
            continue;
        }
        const std::size_t span = old.span_at(finer[*last_inserted]);
        if (!frame || span != frame_span) {
            frame.emplace(old.around(span), curve.points_of(span), limits);
            frame_span = span;
        }
        const auto window = finer.window(j);
        points.push_back(frame->value(std::vector<Argument>(window.begin(), window.end())));
    }
    return {std::move(finer), std::move(points)};
}

void require_multiplicity(std::size_t multiplicity, std::size_t degree) {
    if (multiplicity <= degree + 1) return;
    throw Error(ErrorCode::bad_knots,
                "the multiplicity " + std::to_string(multiplicity) +
                    " is more than degree + 1 = " + std::to_string(degree + 1),
                Part::times);
}

std::vector<Rational> missing_knots(const KnotVector& knots, std::span<const Rational> wanted,
                                    std::size_t m) {
    require_multiplicity(m, knots.degree());
    std::vector<Rational> missing;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        require_inside(knots.domain(), i, wanted[i]);
        if (std::ranges::find(wanted.first(i), wanted[i]) != wanted.begin() + static_cast<std::ptrdiff_t>(i))
            continue;
        missing.insert(missing.end(), m - std::min(m, knots.multiplicity(wanted[i])), wanted[i]);
    }
    return missing;
}

}  // namespace blossom
