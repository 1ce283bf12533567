#include <blossom/core/algebra/elimination.hpp>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/algebraic_number.hpp>

#include <algorithm>

namespace blossom {

namespace {

/// The same root with an interval that is shorter by this factor.
Root narrowed_by(const Root& root, const Integer& factor, const Limits& limits) {
    return narrowed(root, (root.upper - root.lower) / Rational(factor), limits);
}

const Integer& usual_factor() {
    static const Integer factor = Integer(1) << 16;
    return factor;
}

bool changes_sign(const Polynomial& polynomial, const Rational& a, const Rational& b) {
    return polynomial(a).sign() * polynomial(b).sign() < 0;
}

}  // namespace

bool vanishes_at(const Polynomial& polynomial, const Root& root) {
    if (root.is_rational()) return polynomial(root.lower).is_zero();
    return polynomial.is_zero() || changes_sign(gcd(polynomial, *root.factor), root.lower, root.upper);
}

std::pair<Rational, Rational> bounds(const Polynomial& polynomial, const Rational& a, const Rational& b,
                                     const Limits& limits) {
    const BezierCurve polygon = control_points(PolynomialCurve(polynomial), Interval(a, b), limits);
    const auto [least, greatest] = std::ranges::minmax_element(polygon.control_points().coordinate(0));
    const Integer& denominator = polygon.control_points().denominator();
    return {Rational(*least, denominator), Rational(*greatest, denominator)};
}

int sign_at(const Polynomial& polynomial, Root root, const Limits& limits) {
    if (root.is_rational()) return polynomial(root.lower).sign();
    if (vanishes_at(polynomial, root)) return 0;
    while (true) {
        const auto [least, greatest] = bounds(polynomial, root.lower, root.upper, limits);
        if (least.sign() * greatest.sign() > 0) return least.sign();
        root = narrowed_by(root, usual_factor(), limits);
    }
}

std::strong_ordering compare(Root a, Root b, const Limits& limits) {
    if (a.is_rational() && b.is_rational()) return a.lower <=> b.lower;
    if (!a.is_rational() && !b.is_rational()) {
        const Rational& lower = std::max(a.lower, b.lower);
        const Rational& upper = std::min(a.upper, b.upper);
        if (lower < upper && changes_sign(gcd(*a.factor, *b.factor), lower, upper))
            return std::strong_ordering::equal;
    }
    while (true) {
        if (a.upper <= b.lower) return std::strong_ordering::less;
        if (b.upper <= a.lower) return std::strong_ordering::greater;
        a = narrowed_by(a, usual_factor(), limits);
        b = narrowed_by(b, usual_factor(), limits);
    }
}

std::pair<Rational, Rational> AlgebraicValues::bounds_at(Root& root) const {
    while (true) {
        const auto [least_divisor, greatest_divisor] =
            root.is_rational() ? std::pair(denominator_(root.lower), denominator_(root.lower))
                               : bounds(denominator_, root.lower, root.upper, limits_);
        if (least_divisor.sign() * greatest_divisor.sign() > 0) {
            const auto [least, greatest] = root.is_rational()
                                               ? std::pair(numerator_(root.lower), numerator_(root.lower))
                                               : bounds(numerator_, root.lower, root.upper, limits_);
            const auto values = {least / least_divisor, least / greatest_divisor, greatest / least_divisor,
                                 greatest / greatest_divisor};
            return std::minmax(values);
        }
        root = narrowed_by(root, usual_factor(), limits_);
    }
}

const Polynomial& AlgebraicValues::equation_of_values(const std::shared_ptr<const Polynomial>& factor) {
    const auto known = std::ranges::find(equations_, factor, &decltype(equations_)::value_type::first);
    if (known != equations_.end()) return known->second;
    std::vector<Polynomial> fixed;
    for (std::size_t k = 0; k <= factor->degree(); ++k) fixed.emplace_back((*factor)[k]);
    const Polynomial numerator = divide(numerator_, *factor).second;
    const Polynomial denominator = divide(denominator_, *factor).second;
    std::vector<Polynomial> moving;
    for (std::size_t k = 0; k < factor->degree(); ++k) {
        const Rational row[] = {numerator[k], -denominator[k]};
        moving.emplace_back(row);
    }
    const Polynomial equation = resultant(fixed, moving, limits_);
    const Polynomial common = gcd(equation, derivative(equation));
    return equations_.emplace_back(factor, divide_exactly(equation, common)).second;
}

Root AlgebraicValues::at(const Root& root) {
    if (root.is_rational()) return rational_root(numerator_(root.lower) / denominator_(root.lower));
    Root place = root;
    while (true) {
        const auto [least, greatest] = bounds_at(place);
        if (least == greatest) return rational_root(least);
        std::vector<Root> values =
            roots(equation_of_values(root.factor), {least, greatest}, Rational(), limits_);
        if (values.size() == 1) {
            values.front().multiplicity = 1;
            return std::move(values.front());
        }
        place = narrowed_by(place, usual_factor(), limits_);
    }
}

}  // namespace blossom
