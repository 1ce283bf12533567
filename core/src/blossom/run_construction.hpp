#pragma once

// Each construction on a curve over the integers, from its own data. Over a symbolic ring, a curve is treated
// as a patch on one segment.

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/blossom/conversion.hpp>

#include "maps/integer_frame.hpp"

namespace blossom {

/// The homogeneous polynomial F(u, v) = v^n P(u/v) of a map, which polarization only evaluates.
///
/// It is stored as sum_k c_k x^k y^(n-k), with (x, y) = (u, v) for monomial coefficients and (q u - a v, (b -
/// a) v) for a control polygon over [a/q, b/q]. The sums of points have few distinct masses, so that c_k
/// y^(n-k) is kept for the first ones.
class HomogeneousForm {
public:
    using Row = std::vector<Integer>;
    using Pair = HomogeneousPair<Integer>;

    explicit HomogeneousForm(const PolynomialMap& map) : denominator_(points_of(map).denominator()) {
        const auto* bezier = std::get_if<BezierCurve>(&map);
        for (const auto row : points_of(map).rows()) {
            rows_.push_back(bezier ? constructions::local_monomial_from_bernstein(row)
                                   : Row(row.begin(), row.end()));
        }
        if (!bezier) return;
        const auto [a, b, q] = cleared(bezier->interval());
        scale_ = q;
        shift_ = a;
        mass_scale_ = b - a;
        denominator_ *= pow(mass_scale_, bezier->degree());
    }

    /// F times the denominator, one entry per coordinate.
    Row operator()(const Pair& pair) {
        const Integer x = local(pair).u;
        const auto evaluate = [&](const std::vector<Row>& rows) {
            Row values;
            values.reserve(rows.size());
            for (const Row& row : rows)
                values.push_back(constructions::polynomial_value(std::span<const Integer>(row), x));
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
    std::vector<std::span<const Integer>> rows() const { return {rows_.begin(), rows_.end()}; }
    Pair local(const Pair& pair) const {
        return {scale_ * pair.u - shift_ * pair.mass, mass_scale_ * pair.mass};
    }
    std::vector<Pair> local(std::span<const Pair> pairs) const {
        std::vector<Pair> result;
        result.reserve(pairs.size());
        for (const Pair& pair : pairs) result.push_back(local(pair));
        return result;
    }

private:
    struct AtMass {
        Integer mass;
        std::vector<Row> rows;
    };
    static constexpr std::size_t most_masses = 64;

    /// c_k y^(n-k)
    std::vector<Row> rows_at(const Integer& mass) const {
        std::vector<Row> rows = rows_;
        const Integer y = mass_scale_ * mass;
        for (Row& row : rows) {
            Integer power = y;
            for (std::size_t k = row.size() - 1; k-- > 0;) {
                row[k] *= power;
                power *= y;
            }
        }
        return rows;
    }

    std::vector<Row> rows_;
    Integer scale_ = 1;
    Integer shift_;
    Integer mass_scale_ = 1;
    Integer denominator_;
    std::vector<AtMass> at_mass_;
};

/// Bounds on the bits of a blossom value: those of the numbers of the map, of each argument, and of the frame
/// for each argument.
inline std::size_t numerator_bits(const PolynomialMap& map) {
    return greatest_bit_length(points_of(map).numbers().numerators());
}

inline std::size_t frame_bits(const PolynomialMap& map) {
    const auto* bezier = std::get_if<BezierCurve>(&map);
    return bezier ? cleared(bezier->interval()).bits() : 0;
}

/// Runs one of the polarizations, or de Casteljau's algorithm, over [0, 1] if the map has no interval.
inline Quotients<Integer> run_construction(const PolynomialMap& map, Construction construction,
                                           std::span<const HomogeneousPair<Integer>> pairs,
                                           const Limits& limits) {
    if (construction == Construction::casteljau) {
        const auto* own = std::get_if<BezierCurve>(&map);
        const BezierCurve curve = own ? *own : control_points(map, Interval(), limits);
        const auto [a, b, q] = cleared(curve.interval());
        auto value = constructions::by_casteljau<Integer>(curve.control_points().rows(), a, b, q, pairs);
        value.denominator *= curve.control_points().denominator();
        return value;
    }
    HomogeneousForm form(map);
    auto value = construction == Construction::polarization
                     ? constructions::by_polarization<Integer>(form, pairs)
                     : constructions::by_regrouped_polarization<Integer>(form.rows(), form.local(pairs));
    value.denominator *= form.denominator();
    return value;
}

/// Errors: `wrong_arity` unless the number of arguments is the formal degree.
[[noreturn]] void throw_wrong_arity(std::size_t degree, std::size_t arguments);
inline void require_arity(std::size_t degree, std::size_t arguments) {
    if (arguments != degree) throw_wrong_arity(degree, arguments);
}

}  // namespace blossom
