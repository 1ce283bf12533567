#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/spline_roots.hpp>

#include <algorithm>

namespace blossom {

namespace {

/// Adds the zeros of one segment between `lower` and `upper`; of those at `upper` only if it is `closed`.
class Collection {
public:
    Collection(const Rational& width, const Limits& limits) : width_(width), limits_(limits) {}

    void add(const BezierCurve& segment, const Rational& lower, const Rational& upper, bool closed) {
        const Polynomial polynomial = numerator(segment, limits_);
        if (polynomial.is_zero()) {
            add_zeros(lower, upper);
            return;
        }
        // A single point is a root where the whole segment has it.
        const ParameterRange range =
            lower == upper ? ParameterRange(segment.interval()) : ParameterRange(lower, upper);
        for (const Root& root : blossom::roots(polynomial, range, width_, limits_)) {
            const bool inside = lower <= root.lower && root.upper <= upper;
            const bool at_open_end = !closed && root.lower == upper;
            const bool in_zeros =
                !found_.zeros.empty() && root.lower == found_.zeros.back().second && root.is_rational();
            if (inside && !at_open_end && !in_zeros) found_.roots.push_back(root);
        }
    }

    SplineRoots finish() && { return std::move(found_); }

private:
    void add_zeros(const Rational& lower, const Rational& upper) {
        if (!found_.zeros.empty() && found_.zeros.back().second == lower) {
            found_.zeros.back().second = upper;
        } else {
            found_.zeros.emplace_back(lower, upper);
        }
    }

    const Rational& width_;
    const Limits& limits_;
    SplineRoots found_;
};

}  // namespace

SplineRoots roots(const BSplineCurve& curve, const ParameterRange& range, const Rational& width,
                  const Limits& limits) {
    const Rational& end_of_domain = curve.knots()[curve.knots().end_index()];
    Collection found(width, limits);
    for (const BezierCurve& segment : bezier_segments(curve, limits)) {
        const Rational& begin = segment.interval().a();
        const Rational& end = segment.interval().b();
        const Rational lower = range.lower ? std::max(begin, *range.lower) : begin;
        const Rational upper = range.upper ? std::min(end, *range.upper) : end;
        const bool closed = upper < end || end == end_of_domain;
        if (lower < upper || (lower == upper && closed)) found.add(segment, lower, upper, closed);
    }
    return std::move(found).finish();
}

}  // namespace blossom
