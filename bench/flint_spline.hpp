#pragma once

// De Boor's algorithm as one would write it with FLINT's rational numbers.

#include <blossom/core/maps/bspline_curve.hpp>

#include <flint/fmpz_poly.h>

#include <algorithm>
#include <memory>

#include "flint_numbers.hpp"

namespace flint_peer {

/// The triangle on fmpq, in place: d_j <- (1 - w) d_(j-1) + w d_j = d_(j-1) + w (d_j - d_(j-1)).
class DeBoor {
public:
    explicit DeBoor(const blossom::BSplineCurve& curve)
        : degree_(static_cast<slong>(curve.degree())),
          knots_(curve.knots().knots()),
          points_(first_coordinates(curve)),
          triangle_(std::vector<blossom::Rational>(curve.degree() + 1)),
          scratch_(std::vector<blossom::Rational>(3)) {}

    /// On the span [knot i, knot i + 1).
    const fmpq* value(slong span, const fmpq* t) {
        const fmpq* knot = knots_.data();
        fmpq* d = triangle_.data();
        fmpq* weight = scratch_.data();
        fmpq* length = scratch_.data() + 1;
        for (slong j = 0; j <= degree_; ++j) fmpq_set(d + j, points_.data() + span - degree_ + j);
        for (slong level = 1; level <= degree_; ++level) {
            for (slong j = degree_; j >= level; --j) {
                const slong begin = span - degree_ + j;
                const slong end = span + 1 + j - level;
                fmpq_sub(weight, t, knot + begin);
                fmpq_sub(length, knot + end, knot + begin);
                fmpq_div(weight, weight, length);
                fmpq_sub(d + j, d + j, d + j - 1);
                fmpq_mul(d + j, d + j, weight);
                fmpq_add(d + j, d + j, d + j - 1);
            }
        }
        return d + degree_;
    }

    static std::vector<blossom::Rational> first_coordinates(const blossom::BSplineCurve& curve) {
        std::vector<blossom::Rational> result;
        for (const auto& point : curve.control_points()) result.push_back(point[0]);
        return result;
    }

private:
    slong degree_;
    Arguments knots_;
    Arguments points_;
    Arguments triangle_;
    Arguments scratch_;
};

}  // namespace flint_peer
