#pragma once

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

/// The remaining budget of one check.
class Budget {
public:
    explicit Budget(const Limits& limits)
        : terms_(limits.expansion_terms), work_(limits.expansion_work), digits_(limits.digits) {}

    /// Counts term operations. Errors: `limit_exceeded` beyond `expansion_work` of them.
    void spend(std::size_t operations);
    /// Errors: `limit_exceeded` for a polynomial of more than `expansion_terms` terms, or of more memory than
    /// this many terms in 256 symbols need.
    void require_terms(std::size_t terms, std::size_t words_per_term) const;
    /// Counts operations on so many terms with long coefficients. Errors: `limit_exceeded`, also beyond
    /// `limits.digits` decimal digits.
    void spend_on_bits(std::size_t bits, std::size_t terms);
    /// The term operations so far.
    std::size_t spent() const { return spent_; }

private:
    std::size_t terms_;
    std::size_t work_;
    std::size_t digits_;
    std::size_t spent_ = 0;
};

/// A polynomial over Q in numbered symbols: terms in descending lexicographic order, symbol 0 first, with
/// nonzero integer coefficients over one positive denominator.
///
/// The exponents of a term are packed into `width()` words, symbol 0 at the top of the first word, in fields
/// whose top bit is 0. The order of words is the order of monomials, and the sum of words is the product of
/// monomials, at any width.
class PlainPolynomial {
public:
    PlainPolynomial() = default;
    explicit PlainPolynomial(const Rational& number);
    static PlainPolynomial symbol(std::size_t number);

    std::size_t size() const { return coefficients_.size(); }
    bool is_zero() const { return coefficients_.empty(); }
    /// Whether no symbol occurs.
    bool is_number() const;
    /// The value of a polynomial for which `is_number()`.
    Rational number() const;

    std::size_t exponent(std::size_t term, std::size_t symbol) const;
    /// The greatest exponent of a symbol.
    std::size_t degree(std::size_t symbol) const;
    /// The numbers of the symbols that occur, ascending.
    std::vector<std::size_t> symbols() const;
    Rational coefficient(std::size_t term) const { return {coefficients_[term], denominator_}; }

    /// The multiple by a number whose coefficients are coprime integers, the first one positive.
    PlainPolynomial primitive() const;
    std::size_t hash() const;
    friend bool operator==(const PlainPolynomial& a, const PlainPolynomial& b);

    std::size_t width() const { return width_; }
    const std::uint64_t* monomial(std::size_t term) const { return monomials_.data() + term * width_; }

private:
    friend struct PolynomialParts;

    unsigned bits_ = 8;          ///< of a field: 8 or 16
    std::size_t width_ = 0;      ///< words per term
    std::uint64_t largest_ = 0;  ///< an upper bound on the exponents
    std::vector<std::uint64_t> monomials_;
    std::vector<Integer> coefficients_;
    Integer denominator_ = 1;
};

/// a times `left` plus b times `right`. Cost: the number of terms.
PlainPolynomial weighted_sum(const PlainPolynomial& a, const Rational& left, const PlainPolynomial& b,
                             const Rational& right, Budget& budget);
PlainPolynomial sum(const PlainPolynomial& a, const PlainPolynomial& b, Budget& budget);
PlainPolynomial difference(const PlainPolynomial& a, const PlainPolynomial& b, Budget& budget);
PlainPolynomial scaled(const PlainPolynomial& a, const Rational& factor, Budget& budget);

/// Cost: each product of terms is merged log(n) times; or it is looked up once in a table if both factors
/// have many terms.
PlainPolynomial product(const PlainPolynomial& a, const PlainPolynomial& b, Budget& budget);

/// Sums of different symbols and a number are expanded by the multinomial theorem, at the cost of the result.
PlainPolynomial power(const PlainPolynomial& a, std::size_t exponent, Budget& budget);

/// The quotient by a primitive polynomial if it divides exactly.
/// Cost: the terms of the quotient times those of the divisor; constant if the first or the last term already
/// shows that it does not divide.
std::optional<PlainPolynomial> exact_quotient(const PlainPolynomial& a, const PlainPolynomial& divisor,
                                              Budget& budget);

/// The coefficients of the powers of a symbol, lowest first; at least one.
std::vector<PlainPolynomial> coefficients_by(const PlainPolynomial& a, std::size_t symbol, Budget& budget);

/// The coefficients of the different monomials in some symbols.
std::vector<PlainPolynomial> coefficients_by_monomials(const PlainPolynomial& a,
                                                       std::span<const std::size_t> symbols, Budget& budget);

/// The derivative with respect to a symbol.
PlainPolynomial derivative_by(const PlainPolynomial& a, std::size_t symbol, Budget& budget);

/// sum_k coefficients[k] x^k
PlainPolynomial value_at(std::span<const PlainPolynomial> coefficients, const PlainPolynomial& x,
                         Budget& budget);

/// coefficient * prod symbol^exponent. Errors: `limit_exceeded` for an exponent of 2^15 or more.
PlainPolynomial single_term(const Rational& coefficient,
                            std::span<const std::pair<std::size_t, std::size_t>> powers);

/// The sum of many polynomials, taken pairwise so that each term moves about log2(count) times.
PlainPolynomial sum_of(std::vector<PlainPolynomial> summands, Budget& budget);

/// The polynomial as text for messages, with the names of the symbols, at most about 200 bytes long.
std::string text_of(const PlainPolynomial& a, std::span<const std::string> names);

}  // namespace blossom::proofs::second
