#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/rational/limits.hpp>

#include <utility>
#include <vector>

namespace blossom {

/// One real root. If lower == upper, the root is rational and equal to both; otherwise the open interval
/// (lower, upper) contains this root and no other, and its ends are not roots.
struct Root {
    Rational lower;
    Rational upper;
    std::size_t multiplicity;

    bool is_rational() const { return lower == upper; }
    friend bool operator==(const Root&, const Root&) = default;
};

/// P = c * prod factor^multiplicity with squarefree, pairwise coprime, monic factors, by increasing
/// multiplicity. Cost: gcds of polynomials of degree n. Errors: `division_by_zero` for the zero polynomial.
/// Source: Yun's algorithm.
std::vector<std::pair<Polynomial, std::size_t>> squarefree_factors(const Polynomial& polynomial);

/// All real roots of `polynomial` in the closed interval, in increasing order, with their multiplicities.
///
/// The rational roots of each squarefree factor are found by `rational_roots` and divided out. The others are
/// isolated by subdivision of the control polygon at the midpoint: the number of sign changes of the polygon
/// exceeds the number of roots by an even number, so that 0 and 1 are conclusive. The polygons are rounded to
/// 128 bits with an error bound, and recomputed exactly if the bound leaves a sign change undecided. Clusters
/// of close roots are approached by Newton steps, which double the number of bits gained each time and are
/// kept only if the signs prove them. Intervals are refined until they are shorter than 1 / |leading
/// coefficient| or 2^-32, and, if `width` > 0, not longer than `width`.
///
/// Cost: O(n^2) additions of words per subdivision; the number of subdivisions is about the number of roots
/// times the logarithm of the bits that separate them; and O(n) products per step of the refinement, which
/// doubles the bits. Errors: `division_by_zero` for the zero polynomial, whose roots are all numbers;
/// `limit_exceeded`. Source: Goldman, exercise 11; Eigenwillig, Kettner, Krandick, Mehlhorn, Schmitt and
/// Wolpert, "A Descartes algorithm for polynomials with bit-stream coefficients", for the rounding;
/// Sagraloff, "When Newton meets Descartes", for the clusters. Statement: goldman-ex-11.
std::vector<Root> roots(const Polynomial& polynomial, const Interval& interval, const Rational& width = 0,
                        const Limits& limits = {});

}  // namespace blossom
