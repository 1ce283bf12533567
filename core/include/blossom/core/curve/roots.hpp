#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/parameter_range.hpp>
#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace blossom {

/// One real root. If lower == upper, the root is rational and equal to both; otherwise the open interval
/// (lower, upper) contains this root and no other, and its ends are not roots.
struct Root {
    Rational lower;
    Rational upper;
    std::size_t multiplicity = 1;
    /// Of a root that is not rational: a squarefree polynomial without rational roots that has it.
    std::shared_ptr<const Polynomial> factor = nullptr;

    bool is_rational() const { return lower == upper; }
    /// Whether the intervals and the multiplicities are the same.
    friend bool operator==(const Root& a, const Root& b) {
        return a.lower == b.lower && a.upper == b.upper && a.multiplicity == b.multiplicity;
    }
};

/// The same root with an interval of at most this width.
/// Cost: O(n) products per step, which doubles the bits. Errors: `limit_exceeded`.
Root narrowed(const Root& root, const Rational& width, const Limits& limits = {});

/// A power of two that is greater than |z| for every root z. Errors: `division_by_zero` for the zero
/// polynomial. Source: Fujiwara: |z| <= 2 max_k |a_(n-k) / a_n|^(1/k).
Rational root_bound(const Polynomial& polynomial);

/// P = c * prod factor^multiplicity with squarefree, pairwise coprime, monic factors, by rising multiplicity.
/// Cost: gcds of polynomials of degree n. Errors: `division_by_zero` for the zero polynomial. Source: Yun's
/// algorithm.
std::vector<std::pair<Polynomial, std::size_t>> squarefree_factors(const Polynomial& polynomial);

/// All real roots of `polynomial` in the range, its ends included, in rising order, with their
/// multiplicities.
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
std::vector<Root> roots(const Polynomial& polynomial, const ParameterRange& range, const Rational& width = 0,
                        const Limits& limits = {});

/// The numerator of a scalar map: the only coordinate, or the first of (P, w) without the factors that it
/// shares with the weight. Its roots are those of the map. Errors: `mismatched_dimensions`; `limit_exceeded`.
Polynomial numerator(const PolynomialMap& map, const Limits& limits = {});

}  // namespace blossom
