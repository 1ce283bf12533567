#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace blossom::proofs {

/// A product of factors of a field: the numbers of the factors, in order, and their exponents.
using Factors = std::vector<std::pair<std::size_t, std::size_t>>;

/// A rational function: a polynomial over a product of factors of its field. Denominators are never expanded.
struct Fraction {
    SparsePolynomial numerator;
    Factors denominator;

    bool is_zero() const { return numerator.is_zero(); }
};

/// The field of rational functions in any number of variables over Q, with its arithmetic and the factors
/// that have occurred in a denominator: these are the conditions of the computation.
///
/// If no factor occurs in both the numerator and the denominator of the operands, this also holds for the
/// result. Only possible cancellations are tried: in a product, the factors of one denominator in the other
/// numerator; in a sum, those that occur in two denominators with the same exponent.
///
/// Every operation predicts its cost and counts it: `limit_exceeded` beyond `expansion_terms` terms of one
/// polynomial or `expansion_work` term operations of all polynomials together.
class FractionField {
public:
    explicit FractionField(const Limits& limits) : limits_(limits) {}

    /// Cost: that of `FractionSum`.
    Fraction sum(std::span<const Fraction> summands);
    Fraction product(const Fraction& a, const Fraction& b);
    Fraction power(const Fraction& base, std::size_t exponent);
    /// Errors: `division_by_zero`.
    Fraction quotient(const Fraction& a, const Fraction& b);
    Fraction negative(Fraction a) const {
        a.numerator = -a.numerator;
        return a;
    }

    /// d a / d x_variable. Cost: one product per factor of the denominator.
    Fraction derivative(const Fraction& a, std::size_t variable);

    /// Whether a = b for all values of the variables for which no denominator vanishes.
    bool equal(const Fraction& a, const Fraction& b) { return difference(a, b).is_zero(); }
    Fraction difference(const Fraction& a, const Fraction& b);
    /// The same fraction without factors that occur in both numerator and denominator.
    Fraction reduced(Fraction a);

    /// numerators[i] / denominator are the fractions, over their least common denominator.
    struct Common {
        std::vector<SparsePolynomial> numerators;
        Factors denominator;
    };
    Common over_common_denominator(std::span<const Fraction> fractions);

    SparsePolynomial product(const SparsePolynomial& a, const SparsePolynomial& b);
    /// Counts a computation of polynomials with so many terms by so many operations.
    void spend(std::size_t terms, std::size_t work);

    /// A polynomial as a number times a product of factors of the field. It recognises variables, differences
    /// of variables, powers and known factors; the remainder is one factor.
    struct Factorisation {
        Rational unit;
        Factors factors;
    };
    Factorisation factorise(const SparsePolynomial& polynomial);
    /// The polynomial divided by each of these factors as often as possible.
    SparsePolynomial stripped(SparsePolynomial polynomial, const std::set<std::size_t>& factors);
    const std::vector<SparsePolynomial>& factors() const { return factors_; }

private:
    /// Divides `rest` by a factor as often as possible, at most `most` times, and returns how often.
    std::size_t divide_out(SparsePolynomial& rest, const SparsePolynomial& factor, std::size_t most);
    /// Divides the numerator by those factors that divide it, and removes these from `factors`.
    void cancel(SparsePolynomial& numerator, Factors& factors);
    std::size_t number_of(const SparsePolynomial& factor);
    void split_powers(const SparsePolynomial& rest, Factorisation& result);
    SparsePolynomial multiplied(SparsePolynomial polynomial, const Factors& factors);
    friend class FractionSum;

    Limits limits_;
    std::size_t work_ = 0;
    std::vector<SparsePolynomial> factors_;
};

/// A sum of fractions, added one at a time. Fractions over the same denominator are added by halves, with
/// log(n) passes over the terms of n fractions; finally all are brought over the least common denominator.
class FractionSum {
public:
    explicit FractionSum(FractionField& field) : field_(&field) {}

    void add(Fraction summand);
    Fraction result() &&;

private:
    struct Group {
        Factors denominator;
        std::vector<SparsePolynomial> partial_sums;  ///< element i is a sum of 2^i summands, or 0
    };
    SparsePolynomial sum_of(const SparsePolynomial& a, const SparsePolynomial& b);

    FractionField* field_;
    std::vector<Group> groups_;
};

}  // namespace blossom::proofs
