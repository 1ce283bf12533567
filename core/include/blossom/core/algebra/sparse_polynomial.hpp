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
/// denominator. All symbolic computations use this ring.
///
/// Variables are numbered from 0 and have no names here; every polynomial is a polynomial in all of them.
/// Terms are kept in lexicographic order without zeros, and the denominator is the least, so that equal
/// polynomials have equal representations. Exponents are at most 32767 per variable (`limit_exceeded`
/// beyond). Each takes 4, 8 or 16 bits, the least width that holds all of them, so that a monomial in many
/// variables has few words.
class SparsePolynomial {
public:
    SparsePolynomial() = default;
    SparsePolynomial(const Rational& constant);  // NOLINT(google-explicit-constructor)
    SparsePolynomial(Integer constant) : SparsePolynomial(Rational(std::move(constant))) {}  // NOLINT
    template <WholeNumber Word>
    SparsePolynomial(Word constant) : SparsePolynomial(Rational(constant)) {}  // NOLINT
    static SparsePolynomial variable(Count index);
    /// coefficient * prod x_i^exponents[i].
    static SparsePolynomial term(const Rational& coefficient, std::span<const std::size_t> exponents);

    bool is_zero() const { return coefficients_.empty(); }
    /// The number of terms.
    std::size_t size() const { return coefficients_.size(); }
    /// One more than the number of the last variable that occurs.
    std::size_t variables() const { return variables_; }
    Rational coefficient(std::size_t term) const { return coefficients_[term]; }
    std::size_t exponent(std::size_t term, std::size_t variable) const;
    std::size_t degree(std::size_t term) const;
    /// The greatest total degree of a term; 0 for zero.
    std::size_t total_degree() const;
    /// The greatest exponent of one variable.
    std::size_t degree_in(std::size_t variable) const;
    /// The greatest exponent of each variable. Cost: one pass.
    std::vector<std::size_t> degrees() const;
    const RationalVector& coefficients() const { return coefficients_; }

    SparsePolynomial& operator+=(const SparsePolynomial& other) { return *this = *this + other; }
    SparsePolynomial& operator-=(const SparsePolynomial& other) { return *this = *this - other; }
    SparsePolynomial& operator*=(const SparsePolynomial& other) { return *this = *this * other; }
    /// Cost: one merge of the terms.
    friend SparsePolynomial operator+(const SparsePolynomial& a, const SparsePolynomial& b);
    friend SparsePolynomial operator-(const SparsePolynomial& a, const SparsePolynomial& b);
    /// Cost: a b log(min(a, b)) for a and b terms; one merge for a factor of two terms.
    friend SparsePolynomial operator*(const SparsePolynomial& a, const SparsePolynomial& b);
    friend SparsePolynomial operator-(const SparsePolynomial& a);
    friend bool operator==(const SparsePolynomial&, const SparsePolynomial&) = default;
    /// As `to_text` with the variables x1, x2, ...
    friend std::string to_string(const SparsePolynomial& polynomial);
    friend std::size_t hash_value(const SparsePolynomial& polynomial) {
        return hash_of(polynomial.variables_, polynomial.monomials_, polynomial.coefficients_);
    }

    /// The value with variable i = values[i]; later variables must not occur. Errors: `wrong_arity`.
    Rational operator()(std::span<const Rational> values) const;

private:
    std::span<const std::uint64_t> monomial(std::size_t term) const {
        return std::span(monomials_).subspan(term * words_, words_);
    }
    friend struct SparseArithmetic;

    std::size_t variables_ = 0;
    std::size_t bits_ = 4;                  ///< per exponent: 4, 8 or 16; the top bit of each is a guard
    std::size_t words_ = 0;                 ///< per monomial
    std::vector<std::uint64_t> monomials_;  ///< in descending lexicographic order
    RationalVector coefficients_;
};

/// a * b, or nullopt if the product or one of its partial sums has more than `most_terms` terms. The
/// computation takes no more memory than that many terms.
std::optional<SparsePolynomial> product_within(const SparsePolynomial& a, const SparsePolynomial& b,
                                               std::size_t most_terms);

/// The sum of all summands, by halves: log(n) passes over the terms for n summands. 0 for none.
SparsePolynomial sum(std::span<const SparsePolynomial> summands);

/// The sum of a_i b_i, by halves; both spans have the same length.
SparsePolynomial dot(std::span<const SparsePolynomial> a, std::span<const SparsePolynomial> b);

/// sum_k coefficients[k] x^k. Cost: the number of terms of the result for numeric coefficients and
/// independent terms of x. Otherwise it is computed from the powers of x, which for a sum of few variables
/// are smaller than the operands of Horner's rule.
SparsePolynomial polynomial_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x);

/// sum_k coefficients[k] x^k y^(n-k) for n + 1 coefficients.
SparsePolynomial form_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x,
                            const SparsePolynomial& y);

/// Whether the powers of the polynomial have as many terms as those of x_1 + ... + x_m, the most possible:
/// each term contains a variable that no later term contains.
bool has_independent_terms(const SparsePolynomial& polynomial);

/// base^0, ..., base^n. Cost: one product per power; for independent terms, the number of terms of the
/// result.
std::vector<SparsePolynomial> powers(const SparsePolynomial& base, std::size_t n);

/// base^exponent, with 0^0 = 1: two terms by the binomial theorem, independent terms by the multinomial
/// theorem.
SparsePolynomial pow(const SparsePolynomial& base, Count exponent);

}  // namespace blossom
