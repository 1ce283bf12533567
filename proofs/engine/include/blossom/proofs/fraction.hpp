#pragma once

#include <blossom/core/sparse_polynomial.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace blossom::proofs {

/// A rational function: a polynomial over a product of factors of the field it belongs to. Each factor is
/// kept by its number, with its exponent, in order; denominators are never multiplied out.
struct Fraction {
    SparsePolynomial numerator;
    std::vector<std::pair<std::size_t, std::size_t>> denominator;

    bool is_zero() const { return numerator.is_zero(); }
};

/// The field of rational functions of any number of variables over Q, with its arithmetic and the factors
/// that have stood in a denominator: these are the conditions of what was computed.
///
/// Every operation predicts its cost and counts it: `limit_exceeded` beyond `expansion_terms` terms of one
/// polynomial or `expansion_work` term operations of all together.
class FractionField {
public:
    explicit FractionField(const Limits& limits) : limits_(limits) {}

    /// Cost: a merge of all terms by halves.
    Fraction sum(std::span<const Fraction> summands);
    Fraction product(const Fraction& a, const Fraction& b);
    Fraction power(const Fraction& base, std::size_t exponent);
    /// Errors: `division_by_zero`.
    Fraction quotient(const Fraction& a, const Fraction& b);
    Fraction negative(Fraction a) const {
        a.numerator = -a.numerator;
        return a;
    }

    /// d a / d x_variable. Cost: a product for each factor of the denominator.
    Fraction derivative(const Fraction& a, std::size_t variable);

    /// Whether a = b for all values of the variables where no denominator vanishes.
    bool equal(const Fraction& a, const Fraction& b) { return difference(a, b).is_zero(); }
    Fraction difference(const Fraction& a, const Fraction& b);
    /// The same fraction without factors that stand in numerator and denominator.
    Fraction reduced(Fraction a);

    /// numerators[i] / denominator are the fractions, over their least common denominator.
    struct Common {
        std::vector<SparsePolynomial> numerators;
        std::vector<std::pair<std::size_t, std::size_t>> denominator;
    };
    Common over_common_denominator(std::span<const Fraction> fractions);

    SparsePolynomial product(const SparsePolynomial& a, const SparsePolynomial& b);
    /// Accounts for a computation that makes polynomials of so many terms with so many operations.
    void spend(std::size_t terms, std::size_t work);

    /// A polynomial as a product of factors of the field, numbered, and a number. Factors that are variables,
    /// differences of variables, powers and known ones are found; what remains is one factor.
    struct Factorisation {
        Rational unit;
        std::vector<std::pair<std::size_t, std::size_t>> factors;
    };
    Factorisation factorise(const SparsePolynomial& polynomial);
    /// The polynomial divided by every one of these factors as often as it goes.
    SparsePolynomial without(SparsePolynomial polynomial, const std::set<std::size_t>& factors);
    const std::vector<SparsePolynomial>& factors() const { return factors_; }

private:
    void divide_out(SparsePolynomial& rest, const SparsePolynomial& factor, Factorisation& result);
    std::size_t number_of(const SparsePolynomial& factor);
    void split_powers(const SparsePolynomial& rest, Factorisation& result);

    Limits limits_;
    std::size_t work_ = 0;
    std::size_t calls_ = 0;
    std::vector<SparsePolynomial> factors_;
};

}  // namespace blossom::proofs
