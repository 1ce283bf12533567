#include <blossom/core/algebra/elimination.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <optional>

#include "curve_pair.hpp"

namespace blossom {

namespace {

/// The value of a polynomial in s and t at s, as a polynomial in t.
Polynomial at_first(const PolynomialRows& rows_in_t, const Rational& s) {
    std::vector<Rational> values;
    for (const Polynomial& row : rows_in_t) values.push_back(row(s));
    return Polynomial(values);
}

/// A polynomial that vanishes at all parameters of `curve` at which it passes a point of `source` whose
/// parameter there is a root of `places`, or the infinite one.
Polynomial passes(const CurvePiece& curve, const CurvePiece& source, const Polynomial& places,
                  const Limits& limits) {
    const PairEquations equations = equations_of_common_points(curve, source);
    PolynomialRows fixed;
    for (const Rational& coefficient : places.coefficients().to_rationals()) fixed.emplace_back(coefficient);
    Polynomial common;
    for (const PolynomialRows& rows : equations.in_t) common = gcd(common, resultant(fixed, rows, limits));
    return common;
}
Polynomial passes_end(const CurvePiece& curve, const CurvePiece& source) {
    std::size_t n = 0;
    for (const Polynomial& coordinate : source.coordinates) n = std::max(n, coordinate.degree());
    Polynomial common;
    for (std::size_t j = 0; j < 2; ++j)
        common = gcd(common, curve.coordinates[j] * Polynomial(source.weight()[n]) -
                                 curve.weight() * Polynomial(source.coordinates[j][n]));
    return common;
}

/// The places on one piece where its common parts with another one may begin or end.
class Cuts {
public:
    Cuts(const CurvePiece& curve, const CurvePiece& other, const Polynomial& double_points_of_curve,
         const Polynomial& double_points_of_other, const Rational& width, const Limits& limits)
        : curve_(curve), limits_(limits) {
        add(curve.weight());
        for (const auto& [source, double_points] :
             {std::pair(&curve, &double_points_of_curve), {&other, &double_points_of_other}}) {
            const std::vector<Polynomial> speed = velocity(*source);
            for (const auto& end : {source->range.lower, source->range.upper}) {
                if (!end) continue;
                const Rational linear[] = {-*end, 1};
                add(passes(curve, *source, Polynomial(linear), limits));
            }
            for (const Polynomial& places : {gcd(speed[0], speed[1]), *double_points}) {
                if (places.degree() > 0) add(passes(curve, *source, places, limits));
            }
            add(passes_end(curve, *source));
        }
        for (const Rational* end : ends()) {
            const Rational linear[] = {-*end, 1};
            all_ *= divide_exactly(Polynomial(linear), gcd(Polynomial(linear), all_));
        }
        const RangedPolynomial whole{all_, curve.range, true};
        cuts_ = roots(std::span(&whole, 1), width, limits).roots;
    }

    const std::vector<Root>& cuts() const { return cuts_; }
    /// Those that belong to the piece.
    std::vector<Root> own_cuts() const {
        std::vector<Root> own = cuts_;
        std::erase_if(own, [&](const Root& cut) {
            return !curve_.closed && cut.is_rational() && cut.lower == curve_.range.upper;
        });
        return own;
    }

    /// Cell k is between cut k - 1 and cut k; the first and the last may be outside of the range.
    std::size_t cells() const { return cuts_.size() + 1; }
    bool is_inside(std::size_t cell) const {
        const bool below = cell == 0 && curve_.range.lower;
        const bool above = cell == cuts_.size() && curve_.range.upper;
        return !below && !above;
    }
    AlgebraicRange cell(std::size_t k) const {
        AlgebraicRange range;
        if (k > 0) range.lower = cuts_[k - 1];
        if (k < cuts_.size()) range.upper = cuts_[k];
        return range;
    }
    /// Different rational numbers in a cell.
    std::vector<Rational> samples(std::size_t k, std::size_t count) const {
        if (cuts_.empty()) return spread(0, 1, count);
        if (k == 0) return spread(cuts_.front().lower - 1, cuts_.front().lower, count);
        if (k == cuts_.size()) return spread(cuts_.back().upper, cuts_.back().upper + 1, count);
        Root before = cuts_[k - 1];
        Root behind = cuts_[k];
        while (before.upper >= behind.lower) {
            before = narrowed(before, (before.upper - before.lower) / 4, limits_);
            behind = narrowed(behind, (behind.upper - behind.lower) / 4, limits_);
        }
        return spread(before.upper, behind.lower, count);
    }
    /// The cell that a number lies in, which is no cut.
    std::size_t cell_of(const Root& number) const {
        std::size_t k = 0;
        while (k < cuts_.size() && compare(cuts_[k], number, limits_) < 0) ++k;
        return k;
    }

private:
    void add(const Polynomial& polynomial) {
        if (polynomial.degree() == 0) return;
        const Polynomial simple = divide_exactly(polynomial, gcd(polynomial, derivative(polynomial)));
        all_ *= divide_exactly(simple, gcd(simple, all_));
    }
    std::vector<const Rational*> ends() const {
        std::vector<const Rational*> given;
        for (const auto* end : {&curve_.range.lower, &curve_.range.upper}) {
            if (*end) given.push_back(&**end);
        }
        return given;
    }
    static std::vector<Rational> spread(const Rational& a, const Rational& b, std::size_t count) {
        std::vector<Rational> numbers;
        for (std::size_t i = 1; i <= count; ++i)
            numbers.push_back(a + (b - a) * Rational(i) / Rational(count + 1));
        return numbers;
    }

    const CurvePiece& curve_;
    const Limits& limits_;
    Polynomial all_ = 1;
    std::vector<Root> cuts_;
};

/// The double points of a curve that may have parts that it passes several times, where these do not matter.
struct DoublePoints {
    Polynomial places = 1;
    bool is_passed_once = true;
};

DoublePoints double_points(const CurvePiece& curve, const Limits& limits) {
    Polynomial places = equation_of_first(equations_of_double_points(curve), curve, limits);
    if (places.is_zero()) return {1, false};
    return {std::move(places), true};
}

std::size_t degree_of(const CurvePiece& curve) {
    std::size_t n = 0;
    for (const Polynomial& coordinate : curve.coordinates) n = std::max(n, coordinate.degree());
    return n;
}

/// The parameters of the second curve at the point of a sample of the first.
std::vector<Root> partners(const PairEquations& equations, const Rational& s, const Limits& limits) {
    const Polynomial common = gcd(at_first(equations.in_t[0], s), at_first(equations.in_t[1], s));
    return common.degree() == 0 ? std::vector<Root>() : roots(common, {}, Rational(), limits);
}

/// The cells in which all samples have a partner.
std::vector<std::size_t> partner_cells(const PairEquations& equations, const Cuts& second,
                                       std::span<const Rational> samples, const Limits& limits) {
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::vector<std::size_t> found;
        for (const Root& t : partners(equations, samples[i], limits)) found.push_back(second.cell_of(t));
        if (i == 0) {
            cells = std::move(found);
        } else {
            std::erase_if(cells,
                          [&](std::size_t cell) { return std::ranges::find(found, cell) == found.end(); });
        }
    }
    std::erase_if(cells, [&](std::size_t cell) { return !second.is_inside(cell); });
    return cells;
}

/// The partner in a cell.
Root partner_in(std::size_t cell, const PairEquations& equations, const Cuts& second, const Rational& s,
                const Limits& limits) {
    for (Root& t : partners(equations, s, limits)) {
        if (second.cell_of(t) == cell) return std::move(t);
    }
    throw Error(ErrorCode::internal, "a common part of two curves ends between two of its cuts");
}

}  // namespace

CommonParts common_parts(const CurvePiece& first, const CurvePiece& second, const PairEquations& equations,
                         bool is_self, const Rational& width, const Limits& limits) {
    const DoublePoints of_first = double_points(first, limits);
    const DoublePoints of_second = double_points(second, limits);
    constexpr std::size_t least_degree_of_double_points = 3;
    const std::size_t degree = std::min(degree_of(first), degree_of(second)) / 2;
    if (!of_first.is_passed_once && !of_second.is_passed_once && degree >= least_degree_of_double_points) {
        throw Error(
            ErrorCode::limit_exceeded,
            "both curves pass the same curve of a degree above 2 more than once, so that its crossings "
            "with itself cannot be told from common parts");
    }
    const Cuts of_s(first, second, of_first.places, of_second.places, width, limits);
    const Cuts of_t(second, first, of_second.places, of_first.places, width, limits);
    // A sample has more partners than a generic number only at a root of a minor of Sylvester's matrix.
    const bool one_sample_suffices = of_first.is_passed_once && of_second.is_passed_once;
    const std::size_t samples_needed = one_sample_suffices ? 1 : 2 * degree_of(first) * degree_of(second) + 1;
    CommonParts found;
    for (std::size_t i = 0; i < of_s.cells(); ++i) {
        if (!of_s.is_inside(i)) continue;
        const std::vector<Rational> samples = of_s.samples(i, samples_needed + 1);
        for (const std::size_t j :
             partner_cells(equations, of_t, std::span(samples).first(samples_needed), limits)) {
            if (is_self && j <= i) continue;
            const Root begin = partner_in(j, equations, of_t, samples.front(), limits);
            const Root end = partner_in(j, equations, of_t, samples.back(), limits);
            found.overlaps.push_back({of_s.cell(i), of_t.cell(j), compare(end, begin, limits) < 0});
        }
    }
    found.first = of_s.own_cuts();
    found.second = of_t.own_cuts();
    return found;
}

}  // namespace blossom
