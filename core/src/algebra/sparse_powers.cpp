#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>
#include <optional>

#include "summand_streams.hpp"

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

/// sum_k weights[k] x^k for a sum x of independent terms with integer coefficients, term by term in order: with
/// m the first term and z the others, sum_j (c m)^j sum_i weights[i + j] C(i + j, j) z^i.
template <class Width>
class IndependentValue {
public:
    IndependentValue(const Width& width, const AlignedTerms& base, std::span<const Integer> weights)
        : width_(width), base_(base), degree_(weights.size() - 1), weights_(base.size()), writer_(width, most_terms(weights, base.size())) {
        for (std::size_t k = 0; k <= degree_; ++k) binomials_.push_back(binomial_row(k));
        for (std::size_t term = 0; term < base.size(); ++term) {
            auto& powers = powers_.emplace_back(1, Integer(1));
            while (powers.size() <= degree_) powers.push_back(powers.back() * base.coefficients()[term]);
            weights_[term].resize(weights.size());
        }
        std::ranges::copy(weights, weights_.front().begin());
        spend_work(16 * most_terms(weights, base.size()));
    }

    SparseTerms terms() && {
        auto monomial = width_.monomial();
        write(0, degree_, monomial);
        return std::move(writer_).finished();
    }

private:
    using Monomial = typename Width::Monomial;

    static std::size_t most_terms(std::span<const Integer> weights, std::size_t variables) {
        std::size_t count = 0;
        for (std::size_t k = 0; k < weights.size(); ++k) {
            if (!weights[k].is_zero()) count += static_cast<std::size_t>(binomial(k + variables - 1, k).word());
        }
        return count;
    }

    /// sum_k weights_[term][k] (the terms from this one on)^k, k <= degree, times a monomial.
    void write(std::size_t term, std::size_t degree, const Monomial& monomial) {
        const std::vector<Integer>& weights = weights_[term];
        const std::vector<Integer>& powers = powers_[term];
        const bool last = term + 1 == base_.size();
        Monomial product = monomial;
        add_multiple(product, term, degree);
        for (std::size_t j = degree + 1; j-- > 0;) {
            if (last) {
                if (!weights[j].is_zero()) writer_.append(product.data(), weights[j] * powers[j]);
            } else {
                bool any = false;
                for (std::size_t i = 0; i + j <= degree; ++i) {
                    Integer& weight = weights_[term + 1][i];
                    weight = weights[i + j] * binomials_[i + j][j] * powers[j];
                    any = any || !weight.is_zero();
                }
                if (any) write(term + 1, degree - j, product);
            }
            if (j > 0) subtract(product, term);
        }
    }
    void add_multiple(Monomial& monomial, std::size_t term, std::size_t times) const {
        for (std::size_t i = 0; i < width_.words(); ++i)
            monomial[i] += base_.monomials()[term * width_.words() + i] * times;
    }
    void subtract(Monomial& monomial, std::size_t term) const {
        for (std::size_t i = 0; i < width_.words(); ++i)
            monomial[i] -= base_.monomials()[term * width_.words() + i];
    }

    Width width_;
    const AlignedTerms& base_;
    std::size_t degree_;
    std::vector<std::vector<Integer>> binomials_;
    std::vector<std::vector<Integer>> powers_;   ///< of the coefficient of each term
    std::vector<std::vector<Integer>> weights_;  ///< of the powers of the terms from each one on
    summand_streams::TermWriter<Width> writer_;
};

/// A layout for base^n.
SparseLayout layout_of_power(const SparsePolynomial& base, std::size_t n) {
    std::size_t greatest = 0;
    for (const std::size_t degree : base.degrees()) greatest = std::max(greatest, degree);
    if (greatest != 0 && n > greatest_exponent / greatest) SparseArithmetic::exponent_too_large();
    return {base.variables(), packed_monomials::bits_for(greatest * n)};
}

SparsePolynomial value_at_independent_terms(const RationalVector& coefficients, const SparsePolynomial& x) {
    const std::size_t n = coefficients.size() - 1;
    const SparseLayout layout = layout_of_power(x, n);
    // sum_k (a_k / b) (z / d)^k = sum_k a_k d^(n-k) z^k / (b d^n)
    const Integer& divisor = x.coefficients().denominator();
    std::vector<Integer> weights = coefficients.numerators();
    Integer power = 1;
    for (std::size_t k = n + 1; k-- > 0;) {
        weights[k] *= power;
        if (k > 0) power *= divisor;
    }
    const AlignedTerms base(x, layout);
    return packed_monomials::with_width(layout.words(), [&](const auto& width) {
        return SparseArithmetic::polynomial(IndependentValue(width, base, weights).terms(), layout,
                                            coefficients.denominator() * power);
    });
}

/// The coefficients as numbers, if all are.
std::optional<RationalVector> constants(std::span<const SparsePolynomial> polynomials) {
    std::vector<Rational> numbers;
    for (const SparsePolynomial& polynomial : polynomials) {
        if (polynomial.variables() > 0) return std::nullopt;
        numbers.push_back(polynomial.is_zero() ? Rational() : polynomial.coefficient(0));
    }
    return RationalVector(numbers);
}

std::vector<SparsePolynomial> independent_powers(const SparsePolynomial& base, std::size_t n, bool all) {
    const SparseLayout layout = layout_of_power(base, n);
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

SparsePolynomial polynomial_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x) {
    if (coefficients.empty()) return {};
    if (!x.is_zero() && has_independent_terms(x)) {
        if (const auto numbers = constants(coefficients)) return value_at_independent_terms(*numbers, x);
    }
    return dot(coefficients, powers(x, coefficients.size() - 1));
}

SparsePolynomial form_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x,
                            const SparsePolynomial& y) {
    std::vector<SparsePolynomial> scaled(coefficients.begin(), coefficients.end());
    SparsePolynomial power = 1;
    for (std::size_t k = scaled.size(); k-- > 0;) {
        scaled[k] *= power;
        if (k > 0) power *= y;
    }
    return polynomial_value(scaled, x);
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
