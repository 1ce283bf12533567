#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/spline_roots.hpp>

#include <algorithm>

namespace blossom {

namespace {

/// Adds the zeros of one segment between `lower` and `upper`; of those at `upper` only if it is `closed`.
class Collection {
public:
    Collection(const Rational& width, const Limits& limits) : width_(width), limits_(limits) {}

    void add(const RangedPolynomial& piece) {
        const auto& [lower, upper] = piece.range;
        if (piece.polynomial.is_zero()) {
            add_zeros(lower, upper);
            return;
        }
        // A single point is a root where the whole piece has it.
        const bool is_point = lower && lower == upper;
        const ParameterRange range = is_point ? ParameterRange(*lower - 1, *lower + 1) : piece.range;
        for (const Root& root : blossom::roots(piece.polynomial, range, width_, limits_)) {
            const bool inside = !is_point || (root.is_rational() && root.lower == *lower);
            const bool at_open_end = !piece.closed && root.lower == upper;
            const bool in_zeros =
                !found_.zeros.empty() && root.lower == found_.zeros.back().upper && root.is_rational();
            if (inside && !at_open_end && !in_zeros) found_.roots.push_back(root);
        }
    }

    SplineRoots finish() && { return std::move(found_); }

private:
    void add_zeros(const std::optional<Rational>& lower, const std::optional<Rational>& upper) {
        if (!found_.zeros.empty() && found_.zeros.back().upper == lower) {
            found_.zeros.back().upper = upper;
        } else {
            found_.zeros.emplace_back(lower, upper);
        }
    }

    const Rational& width_;
    const Limits& limits_;
    SplineRoots found_;
};

}  // namespace

SplineRoots roots(std::span<const RangedPolynomial> pieces, const Rational& width, const Limits& limits) {
    Collection found(width, limits);
    for (const RangedPolynomial& piece : pieces) found.add(piece);
    return std::move(found).finish();
}

void for_each_segment(
    const BSplineCurve& curve, const ParameterRange& range, const Limits& limits,
    const std::function<void(const BezierCurve& segment, const ParameterRange& range, bool closed)>& use) {
    const Rational& end_of_domain = curve.knots()[curve.knots().end_index()];
    for (const BezierCurve& segment : bezier_segments(curve, limits)) {
        const Rational& begin = segment.interval().a();
        const Rational& end = segment.interval().b();
        const Rational lower = range.lower ? std::max(begin, *range.lower) : begin;
        const Rational upper = range.upper ? std::min(end, *range.upper) : end;
        const bool closed = upper < end || end == end_of_domain;
        if (lower < upper || (lower == upper && closed)) use(segment, {lower, upper}, closed);
    }
}

SplineRoots roots(const BSplineCurve& curve, const ParameterRange& range, const Rational& width,
                  const Limits& limits) {
    std::vector<RangedPolynomial> pieces;
    for_each_segment(curve, range, limits,
                     [&](const BezierCurve& segment, const ParameterRange& part, bool closed) {
                         pieces.push_back({numerator(segment, limits), part, closed});
                     });
    return roots(pieces, width, limits);
}

}  // namespace blossom
