#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/rational/limits.hpp>

#include <utility>
#include <vector>

namespace blossom {

/// One real root: lower == upper for a root that is rational and so known exactly; otherwise the open
/// interval (lower, upper) contains this root, no other root, and its ends are not roots.
struct Root {
    Rational lower;
    Rational upper;
    std::size_t multiplicity;

    bool is_rational() const { return lower == upper; }
    friend bool operator==(const Root&, const Root&) = default;
};

/// P = c * prod factor^multiplicity with squarefree, pairwise coprime, monic factors, by rising multiplicity.
/// Cost: gcds of polynomials of degree n. Errors: `division_by_zero` for the zero polynomial. Source: Yun's
/// algorithm.
std::vector<std::pair<Polynomial, std::size_t>> squarefree_factors(const Polynomial& polynomial);

/// All real roots of `polynomial` in the closed interval, in rising order, with their multiplicities.
///
/// Each squarefree factor is isolated by subdivision of its control polygon at the midpoint: the number of
/// sign changes of the polygon exceeds the number of roots by an even number, so that 0 and 1 decide. A root
/// that is rational is found as such: its denominator divides the leading coefficient, and an interval
/// shorter than that leaves one candidate. Clusters of close roots are approached by Newton's steps, which
/// gain twice as many bits each time, and are kept only when the signs prove them. With `width` > 0 the
/// isolating intervals are refined to at most this length.
///
/// Cost: O(n^2) additions a subdivision, and about as many subdivisions as there are roots times the
/// logarithm of the bits that tell them apart. Errors: `division_by_zero` for the zero polynomial, whose
/// roots are all numbers; `limit_exceeded`. Source: Goldman, exercise 11; Sagraloff, "When Newton meets
/// Descartes", for the clusters. Statement: goldman-ex-11.
std::vector<Root> roots(const Polynomial& polynomial, const Interval& interval, const Rational& width = 0,
                        const Limits& limits = {});

}  // namespace blossom
