#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

#include "sparse_arithmetic.hpp"

namespace blossom {

SparsePolynomial::SparsePolynomial(const Rational& constant) {
    if (!constant.is_zero()) coefficients_ = RationalVector({&constant, 1});
}

SparsePolynomial SparsePolynomial::variable(Count index) {
    SparsePolynomial result(1);
    result.variables_ = index + 1;
    result.words_ = packed_monomials::words_for(result.variables_, result.bits_);
    result.monomials_.resize(result.words_);
    packed_monomials::set_exponent(result.monomials_, index, result.bits_, 1);
    return result;
}

SparsePolynomial SparsePolynomial::term(const Rational& coefficient, std::span<const std::size_t> exponents) {
    SparsePolynomial result(coefficient);
    if (result.is_zero()) return result;
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        greatest = std::max(greatest, exponents[i]);
        if (exponents[i] > 0) result.variables_ = i + 1;
    }
    if (greatest > packed_monomials::greatest_exponent) SparseArithmetic::exponent_too_large();
    result.bits_ = packed_monomials::bits_for(greatest);
    result.words_ = packed_monomials::words_for(result.variables_, result.bits_);
    result.monomials_.resize(result.words_);
    for (std::size_t i = 0; i < result.variables_; ++i)
        packed_monomials::set_exponent(result.monomials_, i, result.bits_, exponents[i]);
    return result;
}

std::size_t SparsePolynomial::exponent(std::size_t term, std::size_t variable) const {
    if (variable >= variables_) return 0;
    return packed_monomials::exponent(monomial(term), variable, bits_);
}

std::size_t SparsePolynomial::degree(std::size_t term) const {
    std::size_t sum = 0;
    for (const std::uint64_t word : monomial(term)) sum += packed_monomials::sum_of_exponents(word, bits_);
    return sum;
}

std::size_t SparsePolynomial::total_degree() const {
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < size(); ++i) greatest = std::max(greatest, degree(i));
    return greatest;
}

std::size_t SparsePolynomial::degree_in(std::size_t variable) const {
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < size(); ++i) greatest = std::max(greatest, exponent(i, variable));
    return greatest;
}

std::vector<std::size_t> SparsePolynomial::degrees() const {
    const std::vector<std::uint64_t> greatest = SparseArithmetic::degrees(*this);
    std::vector<std::size_t> result(variables_);
    for (std::size_t i = 0; i < variables_; ++i) result[i] = packed_monomials::exponent(greatest, i, bits_);
    return result;
}

Rational SparsePolynomial::operator()(std::span<const Rational> values) const {
    Rational sum;
    for (std::size_t i = 0; i < size(); ++i) {
        Rational product = coefficients_.numerators()[i];
        for (std::size_t j = 0; j < variables(); ++j) {
            const std::size_t power = exponent(i, j);
            if (power == 0) continue;
            if (j >= values.size()) {
                throw Error(ErrorCode::wrong_arity, "variable " + std::to_string(j) + " occurs but only " +
                                                        std::to_string(values.size()) + " values are given");
            }
            product *= pow(values[j], power);
        }
        sum += product;
    }
    return sum / Rational(coefficients_.denominator());
}

}  // namespace blossom
