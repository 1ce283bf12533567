#pragma once

// One construction run on a map, over the integers or a symbolic ring: each takes the map from its own
// source.

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/blossom/conversion.hpp>

#include "maps/integer_frame.hpp"

namespace blossom {

/// The numerators of `points` as elements of R, one row a coordinate.
template <class R>
std::vector<std::vector<R>> rows_over(const PointArray& points) {
    std::vector<std::vector<R>> rows;
    for (const auto row : points.rows()) rows.emplace_back(row.begin(), row.end());
    return rows;
}

template <class R>
std::vector<std::span<const R>> row_spans(const std::vector<std::vector<R>>& rows) {
    return {rows.begin(), rows.end()};
}

/// The homogeneous polynomial F(u, v) = v^n P(u/v) of a map as something to evaluate: all that polarization
/// may know.
///
/// It is kept as sum_k c_k x^k y^(n-k), with (x, y) = (u, v) for monomial coefficients and (q u - a v, (b -
/// a) v) for a control polygon over [a/q, b/q]. The sums of points have few masses, so that c_k y^(n-k) is
/// kept for those met first.
template <class R>
class HomogeneousForm {
public:
    explicit HomogeneousForm(const PolynomialMap& map) {
        if (const auto* curve = std::get_if<PolynomialCurve>(&map)) {
            rows_ = rows_over<R>(curve->coefficients());
            denominator_ = curve->coefficients().denominator();
        } else {
            const auto& bezier = std::get<BezierCurve>(map);
            for (const auto& row : rows_over<R>(bezier.control_points())) {
                rows_.push_back(constructions::local_monomial_from_bernstein(std::span<const R>(row)));
            }
            const auto [a, b, q] = cleared(bezier.interval());
            scale_ = q;
            shift_ = a;
            mass_scale_ = b - a;
            denominator_ = bezier.control_points().denominator() * pow(mass_scale_, bezier.degree());
        }
    }

    /// F times the denominator, one entry a coordinate.
    std::vector<R> operator()(const HomogeneousPair<R>& pair) {
        const R x = local(pair).u;
        const auto evaluate = [&](const std::vector<std::vector<R>>& rows) {
            std::vector<R> values;
            values.reserve(rows.size());
            for (const auto& row : rows) values.push_back(value_at(row, x));
            return values;
        };
        const auto known = std::ranges::find(at_mass_, pair.mass, &AtMass::mass);
        if (known != at_mass_.end()) return evaluate(known->rows);
        if (at_mass_.size() == most_masses) return evaluate(rows_at(pair.mass));
        at_mass_.push_back({pair.mass, rows_at(pair.mass)});
        return evaluate(at_mass_.back().rows);
    }
    const Integer& denominator() const { return denominator_; }

    /// c_0, ..., c_n for each coordinate, and an argument as (x, y).
    const std::vector<std::vector<R>>& rows() const { return rows_; }
    HomogeneousPair<R> local(const HomogeneousPair<R>& pair) const {
        return {R(scale_) * pair.u - R(shift_) * pair.mass, R(mass_scale_) * pair.mass};
    }
    std::vector<HomogeneousPair<R>> local(std::span<const HomogeneousPair<R>> pairs) const {
        std::vector<HomogeneousPair<R>> result;
        result.reserve(pairs.size());
        for (const auto& pair : pairs) result.push_back(local(pair));
        return result;
    }

private:
    struct AtMass {
        R mass;
        std::vector<std::vector<R>> rows;
    };
    static constexpr std::size_t most_masses = 64;

    static R value_at(const std::vector<R>& row, const R& x) {
        using constructions::polynomial_value;
        return polynomial_value(std::span<const R>(row), x);
    }

    /// c_k y^(n-k)
    std::vector<std::vector<R>> rows_at(const R& mass) const {
        std::vector<std::vector<R>> rows = rows_;
        const R y = R(mass_scale_) * mass;
        for (auto& row : rows) {
            R power = y;
            for (std::size_t k = row.size() - 1; k-- > 0;) {
                row[k] *= power;
                power *= y;
            }
        }
        return rows;
    }

    std::vector<std::vector<R>> rows_;
    Integer scale_ = 1;
    Integer shift_;
    Integer mass_scale_ = 1;
    Integer denominator_;
    std::vector<AtMass> at_mass_;
};

/// The map in monomial coefficients.
inline PolynomialCurve monomial(const PolynomialMap& map, const Limits& limits) {
    if (const auto* curve = std::get_if<PolynomialCurve>(&map)) return *curve;
    return monomial_form(std::get<BezierCurve>(map), limits);
}

/// The map as a control polygon, over [0, 1] unless it has an interval of its own.
inline BezierCurve control_polygon(const PolynomialMap& map, const Limits& limits) {
    if (const auto* curve = std::get_if<BezierCurve>(&map)) return *curve;
    return control_points(std::get<PolynomialCurve>(map), Interval(), limits);
}

template <class R>
Quotients<R> run_construction(const PolynomialMap& map, Construction construction,
                              std::span<const HomogeneousPair<R>> pairs, const Limits& limits) {
    Quotients<R> value;
    switch (construction) {
        case Construction::symmetric: {
            const PolynomialCurve curve = monomial(map, limits);
            const auto rows = rows_over<R>(curve.coefficients());
            value = constructions::by_symmetric_functions<R>(row_spans(rows), pairs);
            value.denominator *= curve.coefficients().denominator();
            break;
        }
        case Construction::polarization: {
            HomogeneousForm<R> form(map);
            value = constructions::by_polarization<R>(form, pairs);
            value.denominator *= form.denominator();
            break;
        }
        case Construction::regrouped_polarization: {
            const HomogeneousForm<R> form(map);
            value = constructions::by_regrouped_polarization<R>(row_spans(form.rows()), form.local(pairs));
            value.denominator *= form.denominator();
            break;
        }
        case Construction::casteljau: {
            const BezierCurve curve = control_polygon(map, limits);
            const auto rows = rows_over<R>(curve.control_points());
            const auto [a, b, q] = cleared(curve.interval());
            value = constructions::by_casteljau<R>(row_spans(rows), a, b, q, pairs);
            value.denominator *= curve.control_points().denominator();
            break;
        }
    }
    return value;
}

/// The coefficients or the control points.
inline const PointArray& numbers_of(const PolynomialMap& map) {
    if (const auto* curve = std::get_if<PolynomialCurve>(&map)) return curve->coefficients();
    return std::get<BezierCurve>(map).control_points();
}

inline std::size_t degree_of(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.degree(); }, map);
}

/// Errors: `wrong_arity` unless there are as many arguments as the formal degree.
[[noreturn]] void throw_wrong_arity(std::size_t degree, std::size_t arguments);
inline void require_arity(std::size_t degree, std::size_t arguments) {
    if (arguments != degree) throw_wrong_arity(degree, arguments);
}

}  // namespace blossom
