#pragma once

#include "point_algebra.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace blossom::proofs::second {

/// Coefficients, lowest first; the last is not zero.
using PointPolynomial = std::vector<AlgebraNumber>;

/// p with p / q == series to all its terms, in lowest terms, where p and q have few coefficients for the
/// length of the series. Nothing when there are none. Errors: `division_by_zero` at zero divisors.
std::optional<PointPolynomial> numerator_of_series(const Algebra& algebra,
                                                   const std::vector<AlgebraNumber>& series);

/// p / gcd(p, p'), with leading coefficient 1.
PointPolynomial squarefree_part(const Algebra& algebra, const PointPolynomial& polynomial);

/// p(t - shift)
PointPolynomial shifted_back(const Algebra& algebra, PointPolynomial polynomial, const AlgebraNumber& shift);

/// Rational roots of a polynomial without multiple roots and with rational coefficients; all of them for
/// degrees up to 2 and for short coefficients.
std::vector<Rational> rational_roots(const PointPolynomial& polynomial);

/// p == quotient * (t - root) + value
struct DividedByRoot {
    PointPolynomial quotient;
    AlgebraNumber value;
};
DividedByRoot divided_by_root(const Algebra& algebra, const PointPolynomial& polynomial,
                              const AlgebraNumber& root);

/// Solves rows of a_1 x_1 + ... + a_n x_n == b one by one.
class LinearSystem {
public:
    LinearSystem(const Algebra& algebra, std::size_t unknowns) : algebra_(algebra), pivot_of_(unknowns) {}

    enum class Effect { new_pivot, nothing_new, impossible };
    /// `row` has n coefficients and then b. Errors: `division_by_zero` if all that is left are zero divisors.
    Effect add(std::vector<AlgebraNumber> row);
    std::size_t rank() const { return rows_.size(); }
    /// The solution with 0 for the unknowns without a pivot.
    std::vector<AlgebraNumber> solution() const;

private:
    void subtract(std::vector<AlgebraNumber>& from, const std::vector<AlgebraNumber>& pivot_row,
                  std::size_t column) const;

    const Algebra& algebra_;
    std::vector<std::optional<std::size_t>> pivot_of_;  ///< the row of an unknown
    std::vector<std::vector<AlgebraNumber>> rows_;      ///< reduced: a pivot stands alone in its column
};

}  // namespace blossom::proofs::second
