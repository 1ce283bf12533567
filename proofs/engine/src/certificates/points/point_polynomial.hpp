#pragma once

#include "point_algebra.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace blossom::proofs::second {

/// Coefficients, lowest first; the last is not zero.
using PointPolynomial = std::vector<AlgebraNumber>;

/// p with p / q == series in all terms, in lowest terms, where p and q have few coefficients compared with
/// the length of the series; nullopt if there are none. Errors: `division_by_zero` at zero divisors.
std::optional<PointPolynomial> numerator_of_series(const Algebra& algebra,
                                                   const std::vector<AlgebraNumber>& series);

/// p / gcd(p, p'), with leading coefficient 1.
PointPolynomial squarefree_part(const Algebra& algebra, const PointPolynomial& polynomial);

/// p(t - shift)
PointPolynomial shifted_back(const Algebra& algebra, PointPolynomial polynomial, const AlgebraNumber& shift);

/// Rational roots of a squarefree polynomial with rational coefficients: all of them for degrees up to 2 and
/// for short coefficients.
std::vector<Rational> rational_roots(const PointPolynomial& polynomial);

/// p == quotient * (t - root) + value
struct DividedByRoot {
    PointPolynomial quotient;
    AlgebraNumber value;
};
DividedByRoot divided_by_root(const Algebra& algebra, const PointPolynomial& polynomial,
                              const AlgebraNumber& root);

/// Solves equations a_1 x_1 + ... + a_n x_n == b, added one at a time.
class LinearSystem {
public:
    LinearSystem(const Algebra& algebra, std::size_t unknowns) : algebra_(algebra), pivot_of_(unknowns) {}

    enum class Effect { new_pivot, nothing_new, impossible };
    /// `row` has n coefficients, followed by b. Errors: `division_by_zero` if only zero divisors remain as
    /// pivots.
    Effect add(std::vector<AlgebraNumber> row);
    std::size_t rank() const { return rows_.size(); }
    /// The solution in which unknowns without a pivot are 0.
    std::vector<AlgebraNumber> solution() const;

private:
    void subtract(std::vector<AlgebraNumber>& from, const std::vector<AlgebraNumber>& pivot_row,
                  std::size_t column) const;

    const Algebra& algebra_;
    std::vector<std::optional<std::size_t>> pivot_of_;  ///< the row of the pivot of each unknown
    /// reduced: a pivot is the only nonzero element of its column
    std::vector<std::vector<AlgebraNumber>> rows_;
};

}  // namespace blossom::proofs::second
