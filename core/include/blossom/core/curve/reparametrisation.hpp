#pragma once

#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// The affine change of the parameter that takes the ends of one interval to those of another.
class ParameterChange {
public:
    ParameterChange(const Interval& from, const Interval& to);

    /// By what lengths are multiplied; negative where the direction is reversed. Never 0.
    const Rational& slope() const { return slope_; }
    Rational operator()(const Rational& t) const { return slope_ * t + at_zero_; }
    Interval operator()(const Interval& interval) const {
        return {(*this)(interval.a()), (*this)(interval.b())};
    }

private:
    Rational slope_;
    Rational at_zero_;
};

/// The curve whose point at c(t) is that of `curve` at t, for the change c of the parameter. Its blossom is
/// q(c(t_1), ..., c(t_n)) = p(t_1, ..., t_n), so that control points are kept, and Taylor coefficients are
/// divided by powers of the slope.
///
/// Cost: for control points none, otherwise n products a coordinate, and for monomial coefficients a Taylor
/// shift. Errors: `limit_exceeded`.
BezierCurve reparametrised(const BezierCurve& curve, const ParameterChange& change, const Limits& = {});
TaylorCurve reparametrised(const TaylorCurve& curve, const ParameterChange& change, const Limits& = {});
PolynomialCurve reparametrised(const PolynomialCurve& curve, const ParameterChange& change,
                               const Limits& limits = {});

/// The same map with its control points from the other end, over the reversed interval.
BezierCurve seen_from_the_end(const BezierCurve& curve);
/// The same map over its interval in increasing direction.
BezierCurve increasing(const BezierCurve& curve);

}  // namespace blossom
