#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>

#include "sparse_arithmetic.hpp"

/// Powers of sparse polynomials.

namespace blossom {

namespace {

using packed_monomials::greatest_exponent;

/// The power of a polynomial of two terms, by the binomial theorem: the terms come out in order.
SparsePolynomial binomial_power(const SparsePolynomial& base, std::size_t n) {
    std::size_t greatest = 0;
    for (std::size_t k = 0; k < base.variables(); ++k)
        greatest = std::max({greatest, base.exponent(0, k), base.exponent(1, k)});
    if (greatest != 0 && n > greatest_exponent / greatest) SparseArithmetic::exponent_too_large();
    const SparseLayout layout{base.variables(), packed_monomials::bits_for(greatest * n)};
    const std::size_t words = layout.words();
    const AlignedTerms aligned(base, layout);
    const std::uint64_t* first = aligned.monomials();
    const std::uint64_t* second = first + words;
    const Integer* factors = aligned.coefficients();
    std::vector<Integer> second_powers{1};
    for (std::size_t k = 0; k < n; ++k) second_powers.push_back(second_powers.back() * factors[1]);
    const std::vector<Integer> binomials = binomial_row(n);

    SparseTerms result;
    Integer first_power = pow(factors[0], n);
    for (std::size_t k = 0; k <= n; ++k) {
        for (std::size_t i = 0; i < words; ++i)
            result.monomials.push_back(first[i] * (n - k) + second[i] * k);
        result.coefficients.push_back(binomials[k] * first_power * second_powers[k]);
        if (k < n) first_power = divide_exactly(first_power, factors[0]);
    }
    return SparseArithmetic::polynomial(std::move(result), layout, pow(base.coefficients().denominator(), n));
}

/// How many terms are left from the first one on whose first variable occurs in a later one too; 1 when there
/// is none.
std::size_t terms_after_independent_ones(const SparsePolynomial& polynomial) {
    std::size_t start = 0;
    for (; start + 1 < polynomial.size(); ++start) {
        std::size_t first = 0;
        while (first < polynomial.variables() && polynomial.exponent(start, first) == 0) ++first;
        if (first == polynomial.variables()) break;
        bool alone = true;
        for (std::size_t i = start + 1; alone && i < polynomial.size(); ++i) {
            alone = polynomial.exponent(i, first) == 0;
        }
        if (!alone) break;
    }
    return polynomial.size() - start;
}

/// Powers 0..n of integer terms, times denominators left out, where all terms but the last are independent.
/// With x the first variable, which no other term has, (c m + z)^k = sum_j C(k, j) c^j m^j z^(k-j) comes out
/// in order block by block.
std::vector<SparseTerms> independent_powers(const AlignedTerms& base, std::size_t words, std::size_t n,
                                            bool all) {
    std::vector<SparseTerms> powers(n + 1);
    const auto term_power = [&](std::size_t term, std::size_t k, SparseTerms& to) {
        for (std::size_t i = 0; i < words; ++i)
            to.monomials.push_back(base.monomials()[term * words + i] * k);
    };
    const std::size_t last = base.size() - 1;
    Integer coefficient = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        term_power(last, k, powers[k]);
        powers[k].coefficients.push_back(coefficient);
        coefficient *= base.coefficients()[last];
    }
    std::vector<std::vector<Integer>> binomials;
    for (std::size_t k = 0; k <= n; ++k) binomials.push_back(binomial_row(k));
    for (std::size_t term = last; term-- > 0;) {
        std::vector<Integer> term_powers{1};
        for (std::size_t k = 0; k < n; ++k)
            term_powers.push_back(term_powers.back() * base.coefficients()[term]);
        std::vector<SparseTerms> next(n + 1);
        for (std::size_t k = all || term > 0 ? 0 : n; k <= n; ++k) {
            std::size_t size = 0;
            for (std::size_t j = 0; j <= k; ++j) size += powers[j].size();
            next[k].monomials.reserve(size * words);
            next[k].coefficients.reserve(size);
            for (std::size_t j = k + 1; j-- > 0;) {
                const SparseTerms& rest = powers[k - j];
                const Integer scale = binomials[k][j] * term_powers[j];
                for (std::size_t i = 0; i < rest.monomials.size(); ++i) {
                    next[k].monomials.push_back(rest.monomials[i] +
                                                base.monomials()[term * words + i % words] * j);
                }
                for (const Integer& entry : rest.coefficients) next[k].coefficients.push_back(entry * scale);
            }
        }
        powers = std::move(next);
    }
    return powers;
}

std::vector<SparsePolynomial> independent_powers(const SparsePolynomial& base, std::size_t n, bool all) {
    std::size_t greatest = 0;
    for (std::size_t k = 0; k < base.variables(); ++k) greatest = std::max(greatest, base.degree_in(k));
    if (greatest != 0 && n > greatest_exponent / greatest) SparseArithmetic::exponent_too_large();
    const SparseLayout layout{base.variables(), packed_monomials::bits_for(greatest * n)};
    std::vector<SparseTerms> powers = independent_powers(AlignedTerms(base, layout), layout.words(), n, all);
    std::vector<SparsePolynomial> result(n + 1);
    for (std::size_t k = all ? 0 : n; k <= n; ++k) {
        result[k] = SparseArithmetic::polynomial(std::move(powers[k]), layout,
                                                 pow(base.coefficients().denominator(), k));
    }
    return result;
}

}  // namespace

bool has_independent_terms(const SparsePolynomial& polynomial) {
    return terms_after_independent_ones(polynomial) <= 1;
}

std::vector<SparsePolynomial> powers(const SparsePolynomial& base, std::size_t n) {
    if (base.size() > 2 && has_independent_terms(base)) return independent_powers(base, n, true);
    std::vector<SparsePolynomial> result{1};
    while (result.size() <= n) {
        result.push_back(base.size() == 2 ? binomial_power(base, result.size()) : result.back() * base);
    }
    return result;
}

SparsePolynomial pow(const SparsePolynomial& base, std::size_t exponent) {
    if (base.size() == 2) return binomial_power(base, exponent);
    if (base.size() > 2 && has_independent_terms(base))
        return std::move(independent_powers(base, exponent, false).back());
    SparsePolynomial result = 1;
    for (SparsePolynomial square = base; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result *= square;
        if (exponent > 1) square *= square;
    }
    return result;
}

}  // namespace blossom
