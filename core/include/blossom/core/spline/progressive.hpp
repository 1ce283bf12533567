#pragma once

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/constructions/constructions.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

namespace constructions {

/// De Boor's triangle with any arguments: after k levels, with arguments u_1, ..., u_k, entry l of a row is
/// f(u_1, ..., u_k, t_(k+l), ..., t_(n+l-1)), for l = 0..n-k. Level 0 consists of the progressive values
/// f(t_l, ..., t_(l+n-1)).
///
/// On the level of (u, v) = `argument`, neighbours are combined with the coordinates of the argument in
/// [t_(k+l), t_(n+l)]: (t_(n+l) v - u) / (t_(n+l) - t_(k+l)) and (u - t_(k+l) v) / (t_(n+l) - t_(k+l)). R is
/// any commutative ring that contains the integers. Each entry has its own denominator; those of neighbours
/// differ only by the lengths of the intervals on which exactly one of them depends. Source: DeRose, figure
/// 10, with the right end t_(n+l), where the print has t_(n+k+l). Statements: derose-fig10,
/// derose-fig10-comment1, derose-fig10-comment2.
template <class R>
class ProgressiveTriangle {
public:
    /// Takes one row of n + 1 values per coordinate, and 2n knots t_i with t_j != t_(n+l) for l <= j < n. The
    /// knots must outlive the triangle.
    ProgressiveTriangle(std::vector<std::vector<R>> rows, std::span<const Rational> knots)
        : rows_(std::move(rows)), knots_(knots), neighbours_(knots.size() / 2) {
        denominators_.resize(neighbours_.size() + 1, 1);
    }

    /// Adds one level. Cost: n - k combinations per coordinate, and the weights.
    void descend(const HomogeneousPair<R>& argument) {
        const std::size_t n = knots_.size() / 2;
        const std::size_t entries = n - level_;
        Integer length_before;
        for (std::size_t l = 0; l < entries; ++l) {
            const Rational& begin = knots_[level_ + l];
            const Rational& end = knots_[n + l];
            const Integer left_end = end.numerator() * begin.denominator();
            const Integer right_end = begin.numerator() * end.denominator();
            const Integer length = left_end - right_end;
            auto& [own, next] = neighbours_[l];
            const R parameter = R(begin.denominator() * end.denominator()) * argument.u;
            const R left = (R(left_end) * argument.mass - parameter) * R(own);
            const R right = (parameter - R(right_end) * argument.mass) * R(next);
            for (auto& row : rows_) {
                row[l] *= left;
                accumulate_product(row[l], right, row[l + 1]);
            }
            denominators_[l] *= length * own;
            // Sets the factors of entries l - 1 and l on the new level.
            if (l > 0) set_neighbours(l - 1, length * own, length_before);
            length_before = length * next;
        }
        for (auto& row : rows_) row.pop_back();
        ++level_;
    }

    std::size_t level() const { return level_; }
    const std::vector<std::vector<R>>& rows() const { return rows_; }
    /// Entry l of the current row.
    Quotients<R> entry(std::size_t l) const {
        Quotients<R> value{{}, denominators_[l]};
        for (const auto& row : rows_) value.numerators.push_back(row[l]);
        return value;
    }

private:
    /// The factors that bring the numerators of entries l and l + 1 over one denominator.
    struct Neighbours {
        Integer own = 1;
        Integer next = 1;
    };

    /// Short factors are reduced: over equidistant knots the result is 1.
    void set_neighbours(std::size_t l, Integer own, Integer next) {
        if (own.is_word() && next.is_word()) {
            const Integer common = gcd(own, next);
            own /= common;
            next /= common;
        }
        neighbours_[l] = {std::move(own), std::move(next)};
    }

    std::vector<std::vector<R>> rows_;
    std::span<const Rational> knots_;
    std::vector<Neighbours> neighbours_;
    std::vector<Integer> denominators_;
    std::size_t level_ = 0;
};

/// The blossom from progressive values: the apex of the triangle.
/// Cost: n^2 / 2 weights, and as many combinations per coordinate.
template <class R>
Quotients<R> by_progressive_values(Rows<R> values, std::span<const Rational> knots,
                                   std::span<const HomogeneousPair<R>> arguments) {
    std::vector<std::vector<R>> rows;
    for (const auto row : values) rows.emplace_back(row.begin(), row.end());
    ProgressiveTriangle<R> triangle(std::move(rows), knots);
    for (const auto& argument : arguments) triangle.descend(argument);
    return triangle.entry(0);
}

}  // namespace constructions

/// A polynomial map of formal degree n by its progressive values v_j = f(t_j, ..., t_(j+n-1)), j = 0..n, over
/// 2n knots t_0, ..., t_(2n-1) in any order.
///
/// They determine the map if and only if t_j != t_(n+l) for all l <= j < n. A Bezier curve over [a, b] is the
/// case (a^n, b^n); a segment of a B-spline is the case of the 2n knots around it. Source: DeRose, section
/// 4.6. Statements: derose-46-progressive, derose-progressive-vij, derose-46-bezier-progressive.
class ProgressiveCurve {
public:
    /// Takes n + 1 points. Errors: `wrong_arity` unless there are 2n knots; `bad_knots` if two knots that
    /// must differ are equal; those of `PointArray`, with places below `Part::control_points`.
    ProgressiveCurve(std::vector<Rational> knots, std::span<const Coordinates> control_points);

    std::size_t degree() const { return control_points_.size() - 1; }
    std::size_t dimension() const { return control_points_.dimension(); }
    const std::vector<Rational>& knots() const { return knots_; }
    const PointArray& control_points() const { return control_points_; }

    friend bool operator==(const ProgressiveCurve&, const ProgressiveCurve&) = default;

private:
    std::vector<Rational> knots_;
    PointArray control_points_;
};

/// f(arguments) by de Boor's triangle with one argument per level.
/// Cost: n^2 / 2 combinations of points on integers. Errors: `wrong_arity` unless there are n arguments;
/// `limit_exceeded`. Source: DeRose, figure 10. Statement: derose-fig10.
Coordinates blossom_value(const ProgressiveCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits = {});

/// All levels of de Boor's triangle, with one argument per level: point l of level k is f(u_1, ..., u_k,
/// t_(k+l), ..., t_(n+l-1)). Level 0 consists of the control points, and the last level is the value.
/// Cost: n^2 / 2 combinations of points. Errors: those of `blossom_value`. Source: DeRose, figure 10.
/// Statement: derose-fig10.
std::vector<std::vector<Coordinates>> de_boor_pyramid(const ProgressiveCurve& curve,
                                                      std::span<const Argument> arguments,
                                                      const Limits& limits = {});

/// f(t, ..., t) for any t.
Coordinates evaluate(const ProgressiveCurve& curve, const Parameter& t, const Limits& limits = {});

/// The control polygon over [a, b]: P_k = f(a^(n-k), b^k).
/// Cost: n^2 combinations and divisions of points, and a change of interval unless the interval is the
/// curve's own.
/// Errors: `limit_exceeded`.
/// Source: DeRose, figure 9. Statement: derose-fig9-sablonniere.
BezierCurve control_points(const ProgressiveCurve& curve, const Interval& interval,
                           const Limits& limits = {});

/// The interval between the two middle knots t_(n-1) and t_n, which always differ; [0, 1] for degree 0. The
/// polynomial map is the control polygon over it.
std::optional<Interval> own_interval(const ProgressiveCurve& curve);
/// v_j = f(t_j, ..., t_(j+n-1)).
std::vector<StatedValue> stated_values(const ProgressiveCurve& curve);
inline PolynomialMap polynomial_map(const ProgressiveCurve& curve, const Limits& limits = {}) {
    return control_points(curve, interval_of(curve), limits);
}

/// The progressive values of a polynomial map of formal degree n over 2n knots.
/// Cost: n + 1 blossom values. Errors: those of `ProgressiveCurve`; `limit_exceeded`.
ProgressiveCurve progressive_form(const PolynomialMap& map, std::vector<Rational> knots,
                                  const Limits& limits = {});

}  // namespace blossom
