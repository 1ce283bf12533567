#pragma once

// Checks isolating intervals by Sturm's theorem, without the code of the isolation.

#include <blossom/core/curve/roots.hpp>

#include "map_printing.hpp"
#include "sturm.hpp"

namespace blossom::testing {

/// The greatest m such that P, P', ..., P^(m-1) have a common root in (lower, upper], which contains one root
/// of P.
inline std::size_t multiplicity_in(const Polynomial& polynomial, const Rational& lower,
                                   const Rational& upper) {
    std::size_t multiplicity = 0;
    Polynomial common = polynomial;
    Polynomial slope = polynomial;
    while (common.degree() > 0 && SturmSequence(common).roots_in(lower, upper) == 1) {
        ++multiplicity;
        slope = derivative(slope);
        common = gcd(common, slope);
    }
    return multiplicity;
}

/// The multiplicity of `root` by exact division.
inline std::size_t multiplicity_at(Polynomial polynomial, const Rational& root) {
    const Polynomial factor = Polynomial::monomial(1) - Polynomial(root);
    std::size_t multiplicity = 0;
    while (polynomial(root).is_zero()) {
        polynomial = divide_exactly(polynomial, factor);
        ++multiplicity;
    }
    return multiplicity;
}

/// Checks every claim of `Root`, and that no root of the closed interval is missing.
inline void check_isolation(const Polynomial& polynomial, const Interval& interval,
                            const std::vector<Root>& found) {
    const Rational& lower = std::min(interval.a(), interval.b());
    const Rational& upper = std::max(interval.a(), interval.b());
    const SturmSequence sturm(polynomial);
    CHECK(found.size() == sturm.roots_in(lower, upper) + (polynomial(lower).is_zero() ? 1 : 0));
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Root& root = found[i];
        CAPTURE(i, root.lower, root.upper, root.multiplicity);
        CHECK(root.lower >= lower);
        CHECK(root.upper <= upper);
        if (root.is_rational()) {
            CHECK(multiplicity_at(polynomial, root.lower) == root.multiplicity);
        } else {
            CHECK(root.lower < root.upper);
            CHECK_FALSE(polynomial(root.lower).is_zero());
            CHECK_FALSE(polynomial(root.upper).is_zero());
            CHECK(sturm.roots_in(root.lower, root.upper) == 1);
            CHECK(multiplicity_in(polynomial, root.lower, root.upper) == root.multiplicity);
        }
        if (i > 0) CHECK(found[i - 1].upper <= root.lower);
    }
}

}  // namespace blossom::testing
