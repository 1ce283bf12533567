#include <blossom/core/sparse_algebra.hpp>
#include <blossom/proofs/fraction.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <optional>

namespace blossom::proofs {

namespace {

using Factors = std::vector<std::pair<std::size_t, std::size_t>>;

/// The exponents of a and b combined, factor by factor.
template <class Combine>
Factors merged(const Factors& a, const Factors& b, const Combine& combine) {
    Factors result;
    auto i = a.begin();
    auto j = b.begin();
    while (i != a.end() || j != b.end()) {
        const bool from_a = j == b.end() || (i != a.end() && i->first <= j->first);
        const bool from_b = i == a.end() || (j != b.end() && j->first <= i->first);
        const std::size_t factor = from_a ? i->first : j->first;
        const std::size_t exponent = combine(from_a ? i->second : 0, from_b ? j->second : 0);
        if (exponent != 0) result.emplace_back(factor, exponent);
        if (from_a) ++i;
        if (from_b) ++j;
    }
    return result;
}

Factors multiplied(const Factors& a, const Factors& b) {
    return merged(a, b, [](std::size_t x, std::size_t y) { return x + y; });
}

std::optional<SparsePolynomial> quotient_if_exact(const SparsePolynomial& a, const SparsePolynomial& b) {
    // The degrees say no more cheaply than a division.
    for (std::size_t i = 0; i < b.variables(); ++i) {
        if (b.degree_in(i) > a.degree_in(i)) return std::nullopt;
    }
    try {
        return divide_exactly(a, b);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::inexact_division) throw;
        return std::nullopt;
    }
}

bool is_constant(const SparsePolynomial& polynomial) { return polynomial.total_degree() == 0; }

}  // namespace

void FractionField::spend(std::size_t terms, std::size_t work) {
    require_within(terms, limits_.expansion_terms, "expansion_terms", "the number of terms, up to");
    work_ = work > limits_.expansion_work ? limits_.expansion_work + 1 : work_ + work;
    require_within(work_, limits_.expansion_work, "expansion_work", "the number of term operations");
    constexpr std::size_t calls_between_looks = 64;
    if (++calls_ % calls_between_looks == 0) require_time(limits_);
}

SparsePolynomial FractionField::product(const SparsePolynomial& a, const SparsePolynomial& b) {
    std::size_t pairs = 0;
    if (__builtin_mul_overflow(a.size(), b.size(), &pairs)) pairs = limits_.expansion_work + 1;
    spend(0, pairs);
    SparsePolynomial result = a * b;
    spend(result.size(), 0);
    return result;
}

FractionField::Common FractionField::over_common_denominator(std::span<const Fraction> fractions) {
    Common result;
    const bool polynomials =
        std::ranges::all_of(fractions, [](const Fraction& f) { return f.denominator.empty(); });
    for (const Fraction& fraction : fractions) {
        if (polynomials) break;
        result.denominator = merged(result.denominator, fraction.denominator,
                                    [](std::size_t x, std::size_t y) { return std::max(x, y); });
    }
    for (const Fraction& fraction : fractions) {
        SparsePolynomial numerator = fraction.numerator;
        const Factors missing = merged(result.denominator, fraction.denominator,
                                       [](std::size_t x, std::size_t y) { return x - y; });
        for (const auto& [factor, exponent] : missing) {
            for (std::size_t i = 0; i < exponent; ++i) numerator = product(numerator, factors_[factor]);
        }
        result.numerators.push_back(std::move(numerator));
    }
    return result;
}

Fraction FractionField::sum(std::span<const Fraction> summands) {
    Common common = over_common_denominator(summands);
    std::size_t terms = 0;
    for (const SparsePolynomial& numerator : common.numerators) terms += numerator.size();
    spend(0, terms);
    SparsePolynomial numerator = blossom::sum(common.numerators);
    spend(numerator.size(), 0);
    if (numerator.is_zero()) return {};
    return {std::move(numerator), std::move(common.denominator)};
}

Fraction FractionField::difference(const Fraction& a, const Fraction& b) {
    const Fraction both[] = {a, negative(b)};
    return sum(both);
}

Fraction FractionField::product(const Fraction& a, const Fraction& b) {
    if (a.is_zero() || b.is_zero()) return {};
    Fraction result{product(a.numerator, b.numerator), multiplied(a.denominator, b.denominator)};
    return result.denominator.empty() ? result : reduced(std::move(result));
}

Fraction FractionField::power(const Fraction& base, std::size_t exponent) {
    require_within(exponent, limits_.degree, "degree", "the exponent");
    Fraction result{1, {}};
    for (const auto& [factor, power] : base.denominator) {
        if (exponent > 0) result.denominator.emplace_back(factor, power * exponent);
    }
    if (base.numerator.size() <= 2) {
        spend(exponent + 1, exponent);
        result.numerator = pow(base.numerator, exponent);
        return result;
    }
    for (std::size_t i = 0; i < exponent; ++i) result.numerator = product(result.numerator, base.numerator);
    return result;
}

/// (N / prod f_j^e_j)' = (N' prod f_j - N sum_j e_j f_j' prod_{i != j} f_i) / prod f_j^(e_j + 1)
Fraction FractionField::derivative(const Fraction& a, std::size_t variable) {
    Fraction result{blossom::derivative(a.numerator, variable), a.denominator};
    SparsePolynomial without = a.numerator;
    for (auto& [factor, exponent] : result.denominator) {
        const SparsePolynomial& f = factors_[factor];
        const SparsePolynomial df = blossom::derivative(f, variable);
        if (df.is_zero()) continue;
        result.numerator = product(result.numerator, f) -
                           product(without, df * SparsePolynomial(Rational(exponent)));
        without = product(without, f);
        ++exponent;
    }
    return reduced(std::move(result));
}

Fraction FractionField::quotient(const Fraction& a, const Fraction& b) {
    if (b.is_zero()) throw Error(ErrorCode::division_by_zero, "the denominator is zero");
    const Factorisation divisor = factorise(b.numerator);
    Fraction result{a.numerator * SparsePolynomial(Rational(1) / divisor.unit),
                    multiplied(a.denominator, divisor.factors)};
    for (const auto& [factor, exponent] : b.denominator) {
        for (std::size_t i = 0; i < exponent; ++i)
            result.numerator = product(result.numerator, factors_[factor]);
    }
    return result.is_zero() ? Fraction{} : reduced(std::move(result));
}

Fraction FractionField::reduced(Fraction a) {
    if (a.is_zero()) return {};
    Factors left;
    for (auto [factor, exponent] : a.denominator) {
        while (exponent > 0) {
            spend(0, a.numerator.size());
            auto smaller = quotient_if_exact(a.numerator, factors_[factor]);
            if (!smaller) break;
            a.numerator = std::move(*smaller);
            --exponent;
        }
        if (exponent > 0) left.emplace_back(factor, exponent);
    }
    a.denominator = std::move(left);
    return a;
}

SparsePolynomial FractionField::without(SparsePolynomial polynomial, const std::set<std::size_t>& factors) {
    for (const std::size_t factor : factors) {
        while (!polynomial.is_zero()) {
            spend(0, polynomial.size());
            auto smaller = quotient_if_exact(polynomial, factors_[factor]);
            if (!smaller) break;
            polynomial = std::move(*smaller);
        }
    }
    return polynomial;
}

std::size_t FractionField::number_of(const SparsePolynomial& factor) {
    const auto known = std::ranges::find(factors_, factor);
    if (known != factors_.end()) return static_cast<std::size_t>(known - factors_.begin());
    factors_.push_back(factor);
    return factors_.size() - 1;
}

void FractionField::divide_out(SparsePolynomial& rest, const SparsePolynomial& factor,
                               Factorisation& result) {
    std::size_t exponent = 0;
    while (auto smaller = quotient_if_exact(rest, factor)) {
        rest = std::move(*smaller);
        ++exponent;
    }
    if (exponent > 0) result.factors.emplace_back(number_of(factor), exponent);
}

void FractionField::split_powers(const SparsePolynomial& rest, Factorisation& result) {
    // Yun's first step in one variable at a time: what divides the derivative occurs more than once. Only for
    // polynomials of moderate size, where the common divisor is cheap; a factor that is not split is still
    // one.
    constexpr std::size_t most_terms = 30;
    for (std::size_t i = 0; rest.size() <= most_terms && i < rest.variables(); ++i) {
        if (rest.degree_in(i) < 2) continue;
        const SparsePolynomial repeated = gcd(rest, blossom::derivative(rest, i));
        if (is_constant(repeated)) continue;
        for (const SparsePolynomial& part : {repeated, divide_exactly(rest, repeated)}) {
            const Factorisation split = factorise(part);
            result.unit *= split.unit;
            result.factors = multiplied(result.factors, split.factors);
        }
        return;
    }
    result.factors = multiplied(result.factors, {{number_of(rest), 1}});
}

FractionField::Factorisation FractionField::factorise(const SparsePolynomial& polynomial) {
    Factorisation result{polynomial.coefficient(0), {}};
    SparsePolynomial rest = polynomial * SparsePolynomial(Rational(1) / result.unit);
    std::vector<std::size_t> occurring;
    for (std::size_t i = 0; i < rest.variables(); ++i) {
        if (rest.degree_in(i) > 0) occurring.push_back(i);
    }
    if (rest.total_degree() > 1) {
        const std::vector<SparsePolynomial> known = factors_;
        for (const SparsePolynomial& factor : known) divide_out(rest, factor, result);
        for (std::size_t i = 0; i < occurring.size(); ++i) {
            if (is_constant(rest)) break;
            const SparsePolynomial x = SparsePolynomial::variable(occurring[i]);
            divide_out(rest, x, result);
            for (std::size_t j = i + 1; j < occurring.size() && rest.total_degree() > 1; ++j) {
                divide_out(rest, x - SparsePolynomial::variable(occurring[j]), result);
            }
        }
    }
    std::ranges::sort(result.factors);
    if (is_constant(rest)) {
        if (!rest.is_zero()) result.unit *= rest.coefficient(0);
        return result;
    }
    result.unit *= rest.coefficient(0);
    rest *= SparsePolynomial(Rational(1) / rest.coefficient(0));
    split_powers(rest, result);
    return result;
}

}  // namespace blossom::proofs
