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

    /// The value on the span [knot i, knot i + 1).
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

/// Boehm's algorithm in one pass for sorted knots, none of which is the end of the domain.
class Refinement {
public:
    Refinement(const blossom::BSplineCurve& curve, std::span<const blossom::Rational> inserted)
        : degree_(static_cast<slong>(curve.degree())),
          begin_(static_cast<slong>(curve.knots().begin_index())),
          old_knots_(curve.knots().knots()),
          old_points_(DeBoor::first_coordinates(curve)),
          inserted_(inserted),
          knots_(
              std::vector<blossom::Rational>(static_cast<std::size_t>(old_knots_.size()) + inserted.size())),
          points_(
              std::vector<blossom::Rational>(static_cast<std::size_t>(old_points_.size()) + inserted.size())),
          scratch_(std::vector<blossom::Rational>(2)) {}

    void run() {
        slong old_knot = 0;
        slong old_point = 0;
        slong knot = 0;
        slong point = 0;
        fmpq* weight = scratch_.data();
        fmpq* length = scratch_.data() + 1;
        for (slong k = 0; k < inserted_.size(); ++k) {
            const fmpq* x = inserted_.data() + k;
            while (old_knot < old_knots_.size() && fmpq_cmp(old_knots_.data() + old_knot, x) <= 0)
                fmpq_set(knots_.data() + knot++, old_knots_.data() + old_knot++);
            const slong first = knot - 1 - begin_;
            while (point <= first + degree_)
                fmpq_set(points_.data() + point++, old_points_.data() + old_point++);
            fmpq* p = points_.data() + first;
            fmpq_set(points_.data() + point++, p + degree_);
            for (slong l = degree_ - 1; l >= 0; --l) {
                const fmpq* begin = knots_.data() + knot - degree_ + l;
                const fmpq* end = old_knots_.data() + old_knot + l;
                fmpq_sub(weight, x, begin);
                fmpq_sub(length, end, begin);
                fmpq_div(weight, weight, length);
                fmpq_sub(p + l + 1, p + l + 1, p + l);
                fmpq_mul(p + l + 1, p + l + 1, weight);
                fmpq_add(p + l + 1, p + l + 1, p + l);
            }
            fmpq_set(knots_.data() + knot++, x);
        }
        while (old_knot < old_knots_.size()) fmpq_set(knots_.data() + knot++, old_knots_.data() + old_knot++);
        while (old_point < old_points_.size())
            fmpq_set(points_.data() + point++, old_points_.data() + old_point++);
    }
    std::string text() const {
        std::string result;
        for (slong i = 0; i < points_.size(); ++i) result += text_of(points_.data() + i) + " ";
        return result;
    }

private:
    slong degree_;
    slong begin_;
    Arguments old_knots_;
    Arguments old_points_;
    Arguments inserted_;
    Arguments knots_;
    Arguments points_;
    Arguments scratch_;
};

}  // namespace flint_peer
