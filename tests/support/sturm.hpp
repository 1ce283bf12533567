#pragma once

// The oracle for the roots: Sturm's theorem, and multiplicities by common divisors with derivatives.

#include <blossom/core/algebra/polynomial.hpp>

#include <cstddef>
#include <vector>

namespace blossom::testing {

/// P, P', and then the negated remainder of each pair of predecessors.
class SturmSequence {
public:
    explicit SturmSequence(const Polynomial& polynomial);

    /// The number of distinct real roots in the half-open interval (lower, upper].
    std::size_t roots_in(const Rational& lower, const Rational& upper) const {
        return sign_changes(lower) - sign_changes(upper);
    }

private:
    std::size_t sign_changes(const Rational& t) const;

    std::vector<Polynomial> sequence_;
};

}  // namespace blossom::testing
