#pragma once

// Control points and pyramids over intervals whose ends are symbols. What is shown with them holds for all
// intervals.

#include "symbolic.hpp"

namespace blossom::testing {

/// p / q as a constant of the ring.
inline Symbol fraction(const Rational& value) { return value; }
inline Symbol fraction(const Integer& p, const Integer& q) { return Rational(p, q); }

/// k copies of one argument, then l of another.
SymbolicArguments runs(std::size_t k, const SymbolicArgument& first, std::size_t l,
                       const SymbolicArgument& second);

/// p(a^(n-k), b^k) for k = 0..n.
Symbols end_values(const SymbolicBlossom& p, const SymbolicArgument& a, const SymbolicArgument& b);

/// The levels of the pyramid over [a, b] by the recurrence x, y -> (b v - u) x + (u - a v) y, which leaves
/// out the division: level r is (b - a)^r times that of the literature.
std::vector<Symbols> symbolic_pyramid(const Symbols& points, const Symbol& a, const Symbol& b,
                                      const SymbolicArguments& arguments);

/// sum_k P_k C(n, k) (b - t)^(n-k) (t - a)^k: the curve at t times (b - a)^n.
inline Symbol bezier_value(const Symbols& points, const Symbol& a, const Symbol& b, const Symbol& t) {
    return bernstein_value(points, t - a, b - t);
}

}  // namespace blossom::testing
