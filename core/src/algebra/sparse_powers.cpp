#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>
#include <optional>

#include "summand_streams.hpp"

namespace blossom {

namespace {

using packed_monomials::greatest_exponent;

/// The power of a polynomial of two terms, by the binomial theorem, which gives the terms in order.
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

/// The number of terms from the first one whose first variable also occurs in a later term; 1 if there is no
/// such term.
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

/// Powers 0..n of terms with integer coefficients, all independent except the last. With the first variable
/// x, which no other term contains, (c m + z)^k = sum_j C(k, j) c^j m^j z^(k-j) gives the terms in order,
/// block by block.
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

/// C(i, j) for j <= i <= n.
class BinomialTable {
public:
    explicit BinomialTable(std::size_t n) : rows_(n + 1), table_(rows_ * rows_) {
        for (std::size_t i = 0; i <= n; ++i) {
            table_[i * rows_] = 1;
            for (std::size_t j = 1; j <= i; ++j)
                table_[i * rows_ + j] = table_[(i - 1) * rows_ + j - 1] + table_[(i - 1) * rows_ + j];
        }
    }
    const Integer& operator()(std::size_t i, std::size_t j) const { return table_[i * rows_ + j]; }

private:
    std::size_t rows_;
    std::vector<Integer> table_;
};

/// The number of terms of sum_k weights[k] x^k for a sum x of `terms` independent terms, at most 2^40; it
/// counts as work.
std::size_t terms_to_write(std::span<const Integer> weights, std::size_t terms) {
    constexpr std::size_t most = std::size_t{1} << 40;
    constexpr std::uint64_t words_of_term = 16;
    std::size_t count = 0;
    std::size_t of_power = 1;
    for (std::size_t k = 0; k < weights.size() && count < most; ++k) {
        if (!weights[k].is_zero()) count += of_power;
        of_power = std::min(most, of_power * (k + terms) / (k + 1));
    }
    spend_work(words_of_term * count);
    return count;
}

/// sum_k weights[k] x^k for the sum x of the first `count` terms of a polynomial, independent terms with
/// integer coefficients, none of them constant. The terms are written in order: by the exponent of the first
/// variable, which no other term of x contains, then by that of the next one. The multinomial coefficients
/// are products of the binomial coefficients on the way.
template <class Width>
class IndependentValue {
public:
    IndependentValue(const Width& width, const AlignedTerms& base, std::size_t count,
                     std::span<const Integer> weights)
        : width_(width),
          base_(base),
          count_(count),
          weights_(weights),
          binomials_(count > 1 ? weights.size() - 1 : 0),
          writer_(width, terms_to_write(weights, count)) {
        const auto is_one = [](const Integer& coefficient) { return coefficient.is_one(); };
        if (std::all_of(base.coefficients(), base.coefficients() + count, is_one)) return;
        for (std::size_t term = 0; term < count; ++term) {
            powers_.emplace_back(1);
            for (std::size_t k = 1; k < weights.size(); ++k)
                powers_.push_back(powers_.back() * base.coefficients()[term]);
        }
    }

    SparseTerms terms() && {
        write(0, 0, width_.monomial(), 1);
        return std::move(writer_).finished();
    }

private:
    using Monomial = typename Width::Monomial;

    /// The products of `monomial`, which has degree `used` in the previous terms, with powers of the terms
    /// from this one on.
    void write(std::size_t term, std::size_t used, Monomial monomial, const Integer& multinomial) {
        const std::uint64_t* own = base_.monomials() + term * width_.words();
        const std::size_t degree = weights_.size() - 1;
        const bool last = term + 1 == count_;
        for (std::size_t i = 0; i < width_.words(); ++i) monomial[i] += own[i] * (degree - used);
        for (std::size_t k = degree + 1; k-- > used;) {
            if (!last || !weights_[k].is_zero()) {
                Integer coefficient = used == 0 ? multinomial : multinomial * binomials_(k, used);
                if (!powers_.empty()) coefficient *= powers_[term * weights_.size() + k - used];
                if (last) {
                    writer_.append(monomial.data(), coefficient * weights_[k]);
                } else {
                    write(term + 1, k, monomial, coefficient);
                }
            }
            for (std::size_t i = 0; i < width_.words(); ++i) monomial[i] -= own[i];
        }
    }

    Width width_;
    const AlignedTerms& base_;
    std::size_t count_;
    std::span<const Integer> weights_;
    BinomialTable binomials_;
    std::vector<Integer> powers_;  ///< of the coefficient of each term; empty if all are 1
    summand_streams::TermWriter<Width> writer_;
};

/// A layout that can hold base^n.
SparseLayout layout_of_power(const SparsePolynomial& base, std::size_t n) {
    std::size_t greatest = 0;
    for (const std::size_t degree : base.degrees()) greatest = std::max(greatest, degree);
    if (greatest != 0 && n > greatest_exponent / greatest) SparseArithmetic::exponent_too_large();
    return {base.variables(), packed_monomials::bits_for(greatest * n)};
}

/// sum_k coefficients[k] x^k y^(n-k)
SparsePolynomial value_at_independent_terms(const RationalVector& coefficients, const SparsePolynomial& x,
                                            const Rational& y) {
    const std::size_t n = coefficients.size() - 1;
    const SparseLayout layout = layout_of_power(x, n);
    // With the denominators d of x and e of y, x^k y^(n-k) (d e)^n = (x d)^k (y e)^(n-k) d^(n-k) e^k.
    const Integer& d = x.coefficients().denominator();
    std::vector<Integer> weights = coefficients.numerators();
    Integer falling = 1;
    Integer rising = 1;
    for (std::size_t k = 0; k <= n; ++k) {
        weights[n - k] *= falling;
        weights[k] *= rising;
        if (k == n) break;
        falling *= y.numerator() * d;
        rising *= y.denominator();
    }
    const AlignedTerms base(x, layout);
    const Integer denominator = coefficients.denominator() * pow(d, n) * rising;
    const bool has_constant = x.degree(x.size() - 1) == 0;
    if (has_constant) {
        const Integer& constant = base.coefficients()[x.size() - 1];
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = n; k-- > i;) weights[k].add_product(constant, weights[k + 1]);
        }
    }
    const std::size_t count = x.size() - (has_constant ? 1 : 0);
    if (count == 0) return Rational(weights[0], denominator);
    return packed_monomials::with_width(layout.words(), [&](const auto& width) {
        return SparseArithmetic::polynomial(IndependentValue(width, base, count, weights).terms(), layout,
                                            denominator);
    });
}

/// The value of a polynomial without variables.
Rational constant(const SparsePolynomial& polynomial) {
    return polynomial.is_zero() ? Rational() : polynomial.coefficient(0);
}

std::optional<RationalVector> constants(std::span<const SparsePolynomial> polynomials) {
    std::vector<Rational> numbers;
    numbers.reserve(polynomials.size());
    for (const SparsePolynomial& polynomial : polynomials) {
        if (polynomial.variables() > 0) return std::nullopt;
        numbers.push_back(constant(polynomial));
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
    return form_value(coefficients, x, 1);
}

SparsePolynomial form_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x,
                            const SparsePolynomial& y) {
    if (coefficients.empty()) return {};
    if (!x.is_zero() && y.variables() == 0 && has_independent_terms(x)) {
        if (const auto numbers = constants(coefficients))
            return value_at_independent_terms(*numbers, x, constant(y));
    }
    const std::size_t n = coefficients.size() - 1;
    const std::vector<SparsePolynomial> of_x = powers(x, n);
    if (y == SparsePolynomial(1)) return dot(coefficients, of_x);
    std::vector<SparsePolynomial> products = powers(y, n);
    std::ranges::reverse(products);
    for (std::size_t k = 0; k <= n; ++k) products[k] *= of_x[k];
    return dot(coefficients, products);
}

SparsePolynomial pow(const SparsePolynomial& base, Count exponent) {
    if (base.size() == 2) return binomial_power(base, exponent);
    if (base.size() > 2 && has_independent_terms(base))
        return std::move(independent_powers(base, exponent, false).back());
    SparsePolynomial result = 1;
    SparsePolynomial square = base;
    for (std::size_t rest = exponent; rest != 0; rest >>= 1) {
        if (rest & 1) result *= square;
        if (rest > 1) square *= square;
    }
    return result;
}

}  // namespace blossom
