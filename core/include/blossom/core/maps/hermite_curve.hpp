#pragma once

#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <string>

namespace blossom {

/// A polynomial map of formal degree n = l + r - 1 by two-point Hermite data on [a, b]: P(a), P'(a), ...,
/// P^(l-1)(a) and P(b), P'(b), ..., P^(r-1)(b), where l or r may be 0.
///
/// The data determine the map, because P^(k)(a) = n!/(n-k)! p(a^(n-k), delta^k), so that they determine l
/// control points from the left and r from the right. Source: Goldman, theorem 7 and exercise 10b.
/// Statements: goldman-thm7, goldman-ex-10b.
class HermiteCurve {
public:
    /// Takes the derivatives at a and those at b, by increasing order from the value. Errors: `wrong_arity`
    /// if there are none; `mismatched_dimensions`, at `Part::left / k` or `Part::right / k`, unless all have
    /// the same dimension.
    HermiteCurve(std::span<const Coordinates> left, std::span<const Coordinates> right,
                 Interval interval = {});

    std::size_t degree() const { return derivatives_.size() - 1; }
    std::size_t dimension() const { return derivatives_.dimension(); }
    const Interval& interval() const { return interval_; }
    /// The number l of derivatives at a.
    std::size_t left_count() const { return left_count_; }
    std::size_t right_count() const { return derivatives_.size() - left_count_; }
    /// The l derivatives at a, followed by the r derivatives at b.
    const PointArray& derivatives() const { return derivatives_; }

    friend bool operator==(const HermiteCurve&, const HermiteCurve&) = default;
    /// "(0), (1), (2), the first 2 at 0, the others at 1".
    friend std::string to_string(const HermiteCurve& curve);
    friend std::size_t hash_value(const HermiteCurve& curve) {
        return hash_of(curve.interval_, curve.left_count_, curve.derivatives_);
    }
    friend HermiteCurve hermite_form(const BezierCurve& curve, std::size_t left_count, const Limits& limits);

private:
    HermiteCurve(PointArray derivatives, std::size_t left_count, Interval interval)
        : interval_(std::move(interval)), left_count_(left_count), derivatives_(std::move(derivatives)) {}

    Interval interval_;
    std::size_t left_count_;
    PointArray derivatives_;
};

/// The control polygon over [a, b], with h = b - a: P_j = sum_k C(j, k) h^k (n-k)!/n! P^(k)(a) for j < l, and
/// P_(n-j) = sum_k C(j, k) (-h)^k (n-k)!/n! P^(k)(b) for j < r, each by a triangle of additions.
///
/// Cost: l^2 / 2 + r^2 / 2 additions and 3 n products per coordinate, of numbers of O(max(l, r) (bits of h +
/// log n)) more bits than the derivatives. Errors: `limit_exceeded`. Source: Goldman, theorem 7, by the
/// triangle of figure 11(b). Statement: goldman-thm7.
BezierCurve bezier_form(const HermiteCurve& curve, const Limits& limits = {});

/// The inverse: P^(k)(a) = n!/(n-k)! h^(-k) Delta^k P_0 for k < l, and at b the same from the other end with
/// -h, for k < r = n + 1 - l.
///
/// Cost: as for `bezier_form`. Errors: `wrong_arity` if l > n + 1; `limit_exceeded`. Source: Goldman, theorem
/// 7, by the triangle of figure 11(a). Statement: goldman-thm7.
HermiteCurve hermite_form(const BezierCurve& curve, std::size_t left_count, const Limits& limits = {});

/// The polynomial map of the data, by `bezier_form`.
inline PolynomialMap polynomial_map(const HermiteCurve& curve, const Limits& limits = {}) {
    return bezier_form(curve, limits);
}
inline std::optional<Interval> own_interval(const HermiteCurve& curve) { return curve.interval(); }
/// P^(k)(a) = n!/(n-k)! p(a^(n-k), delta^k), and the same at b.
std::vector<StatedValue> stated_values(const HermiteCurve& curve);

}  // namespace blossom
