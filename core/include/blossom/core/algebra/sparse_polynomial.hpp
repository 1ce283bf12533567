#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// A polynomial over Q in any number of variables, sparse: terms with exponents, as integers over one common
/// denominator. This is the ring of what is symbolic.
///
/// Variables are numbered from 0 and have no names here; every polynomial is a polynomial in all of them.
/// Terms are kept in lexicographic order without zeros and the denominator is the least, so that equal
/// polynomials are equal objects. Exponents are at most 32767 a variable (`limit_exceeded` beyond); they take
/// 4, 8 or 16 bits each, the least that hold all of them, so that a monomial in many variables has few words.
class SparsePolynomial {
public:
    SparsePolynomial() = default;
    SparsePolynomial(const Rational& constant);  // NOLINT(google-explicit-constructor)
    SparsePolynomial(Integer constant) : SparsePolynomial(Rational(std::move(constant))) {}  // NOLINT
    SparsePolynomial(int constant) : SparsePolynomial(Rational(constant)) {}                 // NOLINT
    static SparsePolynomial variable(std::size_t index);
    /// coefficient * prod x_i^exponents[i].
    static SparsePolynomial term(const Rational& coefficient, std::span<const std::size_t> exponents);

    bool is_zero() const { return coefficients_.empty(); }
    /// The number of terms.
    std::size_t size() const { return coefficients_.size(); }
    /// One more than the greatest variable that occurs.
    std::size_t variables() const { return variables_; }
    Rational coefficient(std::size_t term) const { return coefficients_[term]; }
    std::size_t exponent(std::size_t term, std::size_t variable) const;
    std::size_t degree(std::size_t term) const;
    /// The greatest total degree of a term; 0 for zero.
    std::size_t total_degree() const;
    /// The greatest exponent of one variable.
    std::size_t degree_in(std::size_t variable) const;
    /// The greatest exponent of each variable that may occur. Cost: one pass.
    std::vector<std::size_t> degrees() const;
    const RationalVector& coefficients() const { return coefficients_; }

    SparsePolynomial& operator+=(const SparsePolynomial& other) { return *this = *this + other; }
    SparsePolynomial& operator-=(const SparsePolynomial& other) { return *this = *this - other; }
    SparsePolynomial& operator*=(const SparsePolynomial& other) { return *this = *this * other; }
    /// Cost: one merge.
    friend SparsePolynomial operator+(const SparsePolynomial& a, const SparsePolynomial& b);
    friend SparsePolynomial operator-(const SparsePolynomial& a, const SparsePolynomial& b);
    /// Cost: a b log(min(a, b)) for a and b terms; one merge for a factor of two terms.
    friend SparsePolynomial operator*(const SparsePolynomial& a, const SparsePolynomial& b);
    friend SparsePolynomial operator-(const SparsePolynomial& a);
    friend bool operator==(const SparsePolynomial&, const SparsePolynomial&) = default;

    /// The value where variable i is values[i]; variables beyond must not occur. Errors: `wrong_arity`.
    Rational operator()(std::span<const Rational> values) const;

private:
    std::span<const std::uint64_t> monomial(std::size_t term) const {
        return std::span(monomials_).subspan(term * words_, words_);
    }
    friend struct SparseArithmetic;

    std::size_t variables_ = 0;
    std::size_t bits_ = 4;                  ///< an exponent: 4, 8 or 16, the top bit of each a guard
    std::size_t words_ = 0;                 ///< a monomial
    std::vector<std::uint64_t> monomials_;  ///< term by term; greater in lexicographic order first
    RationalVector coefficients_;
};

/// a * b, or nothing where it or a partial sum of it has more than `most_terms` terms, which take no more
/// memory than that.
std::optional<SparsePolynomial> product_within(const SparsePolynomial& a, const SparsePolynomial& b,
                                               std::size_t most_terms);

/// The sum of all by halves: for n summands the logarithm of n passes over the terms. 0 for none.
SparsePolynomial sum(std::span<const SparsePolynomial> summands);

/// The sum of a_i b_i, by halves; both spans have the same length.
SparsePolynomial dot(std::span<const SparsePolynomial> a, std::span<const SparsePolynomial> b);

/// sum_k coefficients[k] x^k. Cost: for numbers and independent terms, the terms of the result; otherwise
/// from the powers of x, which for a sum of few variables are smaller than what Horner's rule would multiply.
SparsePolynomial polynomial_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x);

/// sum_k coefficients[k] x^k y^(n-k), n + 1 coefficients.
SparsePolynomial form_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x,
                            const SparsePolynomial& y);

/// Whether the powers of the polynomial have as many terms as they can have, as those of x_1 + ... + x_m:
/// each term has a variable that no later one has.
bool has_independent_terms(const SparsePolynomial& polynomial);

/// base^0, ..., base^n. Cost: a product each; of independent terms, the terms of the result.
std::vector<SparsePolynomial> powers(const SparsePolynomial& base, std::size_t n);

/// base^exponent, with 0^0 = 1; two terms by the binomial theorem, and independent ones by the multinomial.
SparsePolynomial pow(const SparsePolynomial& base, std::size_t exponent);

}  // namespace blossom
