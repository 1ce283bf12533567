#include <blossom/core/sparse_polynomial.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

namespace blossom {

namespace {

constexpr std::uint64_t guards = 0x8000'8000'8000'8000;
constexpr std::size_t greatest_exponent = 0x7fff;

[[noreturn]] void exponent_too_large() {
    throw Error(
        ErrorCode::limit_exceeded,
        "an exponent exceeds the limit " + std::to_string(greatest_exponent) + " of a symbolic polynomial");
}

/// The sign of a - b in lexicographic order; the spans have the same length.
int compare(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] != b[i]) return a[i] > b[i] ? 1 : -1;
    }
    return 0;
}

}  // namespace

/// Terms with integer coefficients, in order and without zeros: what the arithmetic works on.
struct SparseArithmetic {
    struct Terms {
        std::size_t words;
        std::vector<std::uint64_t> monomials;
        std::vector<Integer> coefficients;

        std::size_t size() const { return coefficients.size(); }
        std::span<const std::uint64_t> monomial(std::size_t i) const {
            return {monomials.data() + i * words, words};
        }
        void append(std::span<const std::uint64_t> monomial, Integer coefficient) {
            if (coefficient.is_zero()) return;
            for (const std::uint64_t word : monomial) monomials.push_back(word);
            coefficients.push_back(std::move(coefficient));
        }
    };

    /// The terms of `polynomial` with `words` words a monomial, times `scale`.
    static Terms terms(const SparsePolynomial& polynomial, std::size_t words, const Integer& scale) {
        Terms result{words, {}, polynomial.coefficients_.numerators()};
        if (!scale.is_one()) {
            for (Integer& coefficient : result.coefficients) coefficient *= scale;
        }
        if (words == polynomial.words_) {
            result.monomials = polynomial.monomials_;
            return result;
        }
        result.monomials.resize(words * result.size());
        for (std::size_t i = 0; i < result.size(); ++i) {
            std::ranges::copy(polynomial.monomial(i),
                              result.monomials.begin() + static_cast<std::ptrdiff_t>(i * words));
        }
        return result;
    }

    static SparsePolynomial polynomial(Terms terms, const Integer& denominator) {
        SparsePolynomial result;
        result.words_ = terms.words;
        result.monomials_ = std::move(terms.monomials);
        result.coefficients_ = RationalVector(std::move(terms.coefficients), denominator);
        result.coefficients_.make_canonical();
        result.shrink();
        return result;
    }

    /// Merges; consumes its operands.
    static Terms sum(Terms a, Terms b) {
        Terms result{a.words, {}, {}};
        result.monomials.reserve(a.monomials.size() + b.monomials.size());
        result.coefficients.reserve(a.size() + b.size());
        std::size_t i = 0;
        std::size_t j = 0;
        while (i < a.size() && j < b.size()) {
            const int order = compare(a.monomial(i), b.monomial(j));
            if (order > 0) {
                result.append(a.monomial(i), std::move(a.coefficients[i]));
                ++i;
            } else if (order < 0) {
                result.append(b.monomial(j), std::move(b.coefficients[j]));
                ++j;
            } else {
                a.coefficients[i] += b.coefficients[j];
                result.append(a.monomial(i), std::move(a.coefficients[i]));
                ++i;
                ++j;
            }
        }
        for (; i < a.size(); ++i) result.append(a.monomial(i), std::move(a.coefficients[i]));
        for (; j < b.size(); ++j) result.append(b.monomial(j), std::move(b.coefficients[j]));
        return result;
    }

    /// a times one term: the order stays.
    static Terms shifted(const Terms& a, std::span<const std::uint64_t> monomial,
                         const Integer& coefficient) {
        Terms result = a;
        for (std::size_t i = 0; i < result.monomials.size(); ++i) {
            result.monomials[i] += monomial[i % a.words];
            if (result.monomials[i] & guards) exponent_too_large();
        }
        if (!coefficient.is_one()) {
            for (Integer& entry : result.coefficients) entry *= coefficient;
        }
        return result;
    }

    /// a times the terms first..last-1 of b, as a balanced sum of shifted copies.
    static Terms product(const Terms& a, const Terms& b, std::size_t first, std::size_t last) {
        if (last - first == 1) return shifted(a, b.monomial(first), b.coefficients[first]);
        const std::size_t middle = first + (last - first) / 2;
        return sum(product(a, b, first, middle), product(a, b, middle, last));
    }

    /// (x + y)^n for two terms x > y by the binomial theorem: the terms come out in order.
    static SparsePolynomial binomial_power(const SparsePolynomial& base, std::size_t n) {
        for (std::size_t variable = 0; variable < base.variables(); ++variable) {
            if (base.degree_in(variable) * n > greatest_exponent) exponent_too_large();
        }
        const auto& factors = base.coefficients_.numerators();
        std::vector<Integer> second_powers{1};
        for (std::size_t k = 0; k < n; ++k) second_powers.push_back(second_powers.back() * factors[1]);
        const std::vector<Integer> binomials = binomial_row(n);

        Terms result{base.words_, {}, {}};
        std::vector<std::uint64_t> monomial(base.words_);
        Integer first_power = pow(factors[0], n);
        for (std::size_t k = 0; k <= n; ++k) {
            for (std::size_t i = 0; i < monomial.size(); ++i) {
                monomial[i] = base.monomial(0)[i] * (n - k) + base.monomial(1)[i] * k;
            }
            result.append(monomial, binomials[k] * first_power * second_powers[k]);
            if (k < n) first_power = divide_exactly(first_power, factors[0]);
        }
        return polynomial(std::move(result), pow(base.coefficients_.denominator(), n));
    }
};

SparsePolynomial::SparsePolynomial(const Rational& constant) {
    if (!constant.is_zero()) coefficients_ = RationalVector({&constant, 1});
}

SparsePolynomial SparsePolynomial::variable(std::size_t index) {
    std::vector<std::size_t> exponents(index + 1);
    exponents[index] = 1;
    return term(1, exponents);
}

SparsePolynomial SparsePolynomial::term(const Rational& coefficient, std::span<const std::size_t> exponents) {
    SparsePolynomial result(coefficient);
    if (result.is_zero()) return result;
    result.words_ = (exponents.size() + lanes - 1) / lanes;
    result.monomials_.resize(result.words_);
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        if (exponents[i] > greatest_exponent) exponent_too_large();
        result.monomials_[i / lanes] |= std::uint64_t{exponents[i]} << (16 * (lanes - 1 - i % lanes));
    }
    result.shrink();
    return result;
}

void SparsePolynomial::shrink() {
    while (words_ > 0) {
        for (std::size_t i = words_ - 1; i < monomials_.size(); i += words_) {
            if (monomials_[i] != 0) return;
        }
        std::vector<std::uint64_t> narrower;
        narrower.reserve(size() * (words_ - 1));
        for (std::size_t i = 0; i < monomials_.size(); ++i) {
            if (i % words_ != words_ - 1) narrower.push_back(monomials_[i]);
        }
        monomials_ = std::move(narrower);
        --words_;
    }
}

std::size_t SparsePolynomial::exponent(std::size_t term, std::size_t variable) const {
    if (variable / lanes >= words_) return 0;
    return (monomial(term)[variable / lanes] >> (16 * (lanes - 1 - variable % lanes))) & greatest_exponent;
}

std::size_t SparsePolynomial::degree(std::size_t term) const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < variables(); ++i) sum += exponent(term, i);
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

SparsePolynomial operator+(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    const std::size_t words = std::max(a.words_, b.words_);
    const Integer& da = a.coefficients_.denominator();
    const Integer& db = b.coefficients_.denominator();
    const Integer denominator = lcm(da, db);
    return SparseArithmetic::polynomial(
        SparseArithmetic::sum(SparseArithmetic::terms(a, words, divide_exactly(denominator, da)),
                              SparseArithmetic::terms(b, words, divide_exactly(denominator, db))),
        denominator);
}

SparsePolynomial operator-(const SparsePolynomial& a) {
    return SparseArithmetic::polynomial(SparseArithmetic::terms(a, a.words_, -1),
                                        a.coefficients_.denominator());
}

SparsePolynomial operator-(const SparsePolynomial& a, const SparsePolynomial& b) { return a + -b; }

SparsePolynomial operator*(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (a.is_zero() || b.is_zero()) return {};
    if (a.size() < b.size()) return b * a;
    const std::size_t words = std::max(a.words_, b.words_);
    return SparseArithmetic::polynomial(
        SparseArithmetic::product(SparseArithmetic::terms(a, words, 1), SparseArithmetic::terms(b, words, 1),
                                  0, b.size()),
        a.coefficients_.denominator() * b.coefficients_.denominator());
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

SparsePolynomial sum(std::span<const SparsePolynomial> summands) {
    if (summands.empty()) return {};
    if (summands.size() == 1) return summands.front();
    const std::size_t half = summands.size() / 2;
    return sum(summands.first(half)) + sum(summands.subspan(half));
}

SparsePolynomial dot(std::span<const SparsePolynomial> a, std::span<const SparsePolynomial> b) {
    std::vector<SparsePolynomial> products;
    products.reserve(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) products.push_back(a[i] * b[i]);
    return sum(products);
}

SparsePolynomial polynomial_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x) {
    std::vector<SparsePolynomial> powers{1};
    while (powers.size() < coefficients.size()) powers.push_back(powers.back() * x);
    return dot(coefficients, powers);
}

SparsePolynomial pow(const SparsePolynomial& base, std::size_t exponent) {
    if (base.size() == 2) return SparseArithmetic::binomial_power(base, exponent);
    SparsePolynomial result = 1;
    for (SparsePolynomial square = base; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result *= square;
        if (exponent > 1) square *= square;
    }
    return result;
}

}  // namespace blossom
