#pragma once

#include <blossom/core/curve/roots.hpp>

#include <compare>
#include <memory>
#include <utility>
#include <vector>

/// Computations with real algebraic numbers, which `Root` represents: all decisions are exact.

namespace blossom {

/// The rational number as a root.
inline Root rational_root(const Rational& value) { return {value, value, 1, nullptr}; }

/// Whether the polynomial is 0 at the root: whether its greatest common divisor with the factor of the root
/// changes its sign in the interval of the root. Cost: one gcd.
bool vanishes_at(const Polynomial& polynomial, const Root& root);

/// The sign of the polynomial at the root. Cost: one gcd, and control points over smaller and smaller
/// intervals of the root. Errors: `limit_exceeded`.
int sign_at(const Polynomial& polynomial, Root root, const Limits& limits = {});

/// The order of two real algebraic numbers. They are equal if the greatest common divisor of their factors
/// has a root in both intervals; otherwise the intervals are narrowed until they are disjoint. Errors:
/// `limit_exceeded`.
std::strong_ordering compare(Root a, Root b, const Limits& limits = {});
inline bool is_same(const Root& a, const Root& b, const Limits& limits = {}) {
    return compare(a, b, limits) == std::strong_ordering::equal;
}

/// Bounds on the values of a polynomial from a to b: the least and the greatest of its Bernstein
/// coefficients.
std::pair<Rational, Rational> bounds(const Polynomial& polynomial, const Rational& a, const Rational& b,
                                     const Limits& limits = {});

/// The values of a quotient N/D of polynomials at real algebraic numbers, as such numbers: at a root of the
/// polynomial p, the value is a root of the resultant of p and N - v D in v.
class AlgebraicValues {
public:
    AlgebraicValues(Polynomial numerator, Polynomial denominator, const Limits& limits)
        : numerator_(std::move(numerator)), denominator_(std::move(denominator)), limits_(limits) {}

    /// The value at a number at which D is not 0; its multiplicity is 1.
    /// Cost: one resultant for each factor of roots, and the isolation of a root of it. Errors:
    /// `limit_exceeded`.
    Root at(const Root& root);
    /// Bounds on the value that follow from the interval of the root, which is narrowed as much as needed.
    std::pair<Rational, Rational> bounds_at(Root& root) const;

private:
    const Polynomial& equation_of_values(const std::shared_ptr<const Polynomial>& factor);

    Polynomial numerator_;
    Polynomial denominator_;
    const Limits& limits_;
    std::vector<std::pair<std::shared_ptr<const Polynomial>, Polynomial>> equations_;
};

}  // namespace blossom
