#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/proofs/fraction.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>

namespace blossom::proofs {

namespace {

/// Combines the exponents of a and b, factor by factor.
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

/// The factors of a without those of b.
Factors without(const Factors& a, const Factors& b) {
    return merged(a, b, [](std::size_t x, std::size_t y) { return x > y ? x - y : 0; });
}

bool is_constant(const SparsePolynomial& polynomial) { return polynomial.variables() == 0; }

}  // namespace

void FractionField::spend(std::size_t terms, std::size_t work) {
    require_within(terms, limits_.expansion_terms, "expansion_terms", "the number of terms, up to");
    work_ = work > limits_.expansion_work ? limits_.expansion_work + 1 : work_ + work;
    require_within(work_, limits_.expansion_work, "expansion_work", "the number of term operations");
    constexpr std::uint64_t words_of_operation = 32;
    spend_work(words_of_operation * std::max<std::size_t>(work, 1));
}

SparsePolynomial FractionField::product(const SparsePolynomial& a, const SparsePolynomial& b) {
    std::size_t pairs = 0;
    if (__builtin_mul_overflow(a.size(), b.size(), &pairs)) pairs = limits_.expansion_work + 1;
    spend(0, pairs);
    auto result = product_within(a, b, limits_.expansion_terms);
    if (!result) spend(limits_.expansion_terms + 1, 0);
    return std::move(*result);
}

SparsePolynomial FractionField::multiplied(SparsePolynomial polynomial, const Factors& factors) {
    for (const auto& [factor, exponent] : factors) {
        for (std::size_t i = 0; i < exponent; ++i) polynomial = product(polynomial, factors_[factor]);
    }
    return polynomial;
}

FractionField::Common FractionField::over_common_denominator(std::span<const Fraction> fractions) {
    Common result;
    for (const Fraction& fraction : fractions) {
        if (fraction.denominator.empty()) continue;
        result.denominator = merged(result.denominator, fraction.denominator,
                                    [](std::size_t x, std::size_t y) { return std::max(x, y); });
    }
    result.numerators.reserve(fractions.size());
    for (const Fraction& fraction : fractions) {
        result.numerators.push_back(
            multiplied(fraction.numerator, without(result.denominator, fraction.denominator)));
    }
    return result;
}

Fraction FractionField::sum(std::span<const Fraction> summands) {
    FractionSum sum(*this);
    for (const Fraction& summand : summands) sum.add(summand);
    return std::move(sum).result();
}

Fraction FractionField::difference(const Fraction& a, const Fraction& b) {
    const Fraction both[] = {a, negative(b)};
    return sum(both);
}

Fraction FractionField::product(const Fraction& a, const Fraction& b) {
    if (a.is_zero() || b.is_zero()) return {};
    if (a.denominator.empty() && b.denominator.empty()) return {product(a.numerator, b.numerator), {}};
    Fraction left{a.numerator, b.denominator};
    Fraction right{b.numerator, a.denominator};
    cancel(left.numerator, left.denominator);
    cancel(right.numerator, right.denominator);
    return {product(left.numerator, right.numerator),
            blossom::proofs::multiplied(left.denominator, right.denominator)};
}

Fraction FractionField::power(const Fraction& base, std::size_t exponent) {
    require_within(exponent, limits_.degree, "degree", "the exponent");
    Fraction result{1, {}};
    for (const auto& [factor, power] : base.denominator) {
        if (exponent > 0) result.denominator.emplace_back(factor, power * exponent);
    }
    const std::size_t terms = base.numerator.size();
    if (terms <= 2 || has_independent_terms(base.numerator)) {
        for (std::size_t i = 1; i <= exponent; ++i) {
            const Integer size = binomial(i + std::max<std::size_t>(terms, 1) - 1, i);
            const std::size_t count = size > Integer(limits_.expansion_work)
                                          ? limits_.expansion_work
                                          : static_cast<std::size_t>(*size.to_int64());
            spend(count, count);
        }
        result.numerator = pow(base.numerator, exponent);
        return result;
    }
    for (std::size_t i = 0; i < exponent; ++i) result.numerator = product(result.numerator, base.numerator);
    return result;
}

/// (N / prod f_j^e_j)' = (N' prod f_j - N sum_j e_j f_j' prod_{i != j} f_i) / prod f_j^(e_j + 1)
Fraction FractionField::derivative(const Fraction& a, std::size_t variable) {
    Fraction result{blossom::derivative(a.numerator, variable), a.denominator};
    SparsePolynomial others = a.numerator;
    for (auto& [factor, exponent] : result.denominator) {
        const SparsePolynomial& f = factors_[factor];
        const SparsePolynomial df = blossom::derivative(f, variable);
        if (df.is_zero()) continue;
        result.numerator =
            product(result.numerator, f) - product(others, df * SparsePolynomial(Rational(exponent)));
        others = product(others, f);
        ++exponent;
    }
    return reduced(std::move(result));
}

Fraction FractionField::quotient(const Fraction& a, const Fraction& b) {
    if (b.is_zero()) throw Error(ErrorCode::division_by_zero, "the denominator is zero");
    if (a.is_zero()) return {};
    auto [unit, factors] = factorise(b.numerator);
    Fraction result{a.numerator, std::move(factors)};
    cancel(result.numerator, result.denominator);
    result.numerator = multiplied(std::move(result.numerator), without(b.denominator, a.denominator));
    if (unit != Rational(1)) result.numerator *= SparsePolynomial(Rational(1) / unit);
    result.denominator =
        blossom::proofs::multiplied(result.denominator, without(a.denominator, b.denominator));
    return result;
}

void FractionField::cancel(SparsePolynomial& numerator, Factors& factors) {
    for (auto& [factor, exponent] : factors) exponent -= divide_out(numerator, factors_[factor], exponent);
    std::erase_if(factors, [](const auto& factor) { return factor.second == 0; });
}

Fraction FractionField::reduced(Fraction a) {
    if (a.is_zero()) return {};
    cancel(a.numerator, a.denominator);
    return a;
}

SparsePolynomial FractionField::stripped(SparsePolynomial polynomial, const std::set<std::size_t>& factors) {
    if (polynomial.is_zero()) return polynomial;
    for (const std::size_t factor : factors)
        divide_out(polynomial, factors_[factor], polynomial.total_degree());
    return polynomial;
}

std::size_t FractionField::number_of(const SparsePolynomial& factor) {
    const auto known = std::ranges::find(factors_, factor);
    if (known != factors_.end()) return static_cast<std::size_t>(known - factors_.begin());
    factors_.push_back(factor);
    return factors_.size() - 1;
}

std::size_t FractionField::divide_out(SparsePolynomial& rest, const SparsePolynomial& factor,
                                      std::size_t most) {
    std::size_t exponent = 0;
    while (exponent < most) {
        Division division =
            divide(rest, factor, limits_.expansion_work - std::min(work_, limits_.expansion_work));
        spend(0, division.work);
        if (!division.quotient) break;
        rest = std::move(*division.quotient);
        ++exponent;
    }
    return exponent;
}

void FractionField::split_powers(const SparsePolynomial& rest, Factorisation& result) {
    // The first step of Yun's algorithm in one variable at a time: a factor that divides the derivative
    // occurs more than once. It is used only for polynomials of moderate size, where the common divisor is
    // cheap; without it a factor simply stays unsplit.
    constexpr std::size_t most_terms = 30;
    for (std::size_t i = 0; rest.size() <= most_terms && i < rest.variables(); ++i) {
        const std::size_t degree = rest.degree_in(i);
        if (degree < 2) continue;
        spend(0, rest.size() + degree * degree);
        if (!may_have_repeated_factor(rest, i)) continue;
        const SparsePolynomial repeated = gcd(rest, blossom::derivative(rest, i));
        if (is_constant(repeated)) continue;
        for (const SparsePolynomial& part : {repeated, divide_exactly(rest, repeated)}) {
            const Factorisation split = factorise(part);
            result.unit *= split.unit;
            result.factors = blossom::proofs::multiplied(result.factors, split.factors);
        }
        return;
    }
    result.factors = blossom::proofs::multiplied(result.factors, {{number_of(rest), 1}});
}

FractionField::Factorisation FractionField::factorise(const SparsePolynomial& polynomial) {
    Factorisation result{polynomial.coefficient(0), {}};
    SparsePolynomial rest =
        result.unit == Rational(1) ? polynomial : polynomial * SparsePolynomial(Rational(1) / result.unit);
    if (rest.total_degree() > 1) {
        const auto try_factor = [&](const SparsePolynomial& factor) {
            if (const std::size_t exponent = divide_out(rest, factor, std::size_t(-1)); exponent > 0)
                result.factors.emplace_back(number_of(factor), exponent);
        };
        std::size_t number = 0;
        while (number < factors_.size()) try_factor(SparsePolynomial(factors_[number++]));
        const std::vector<std::size_t> degrees = rest.degrees();
        for (std::size_t i = 0; i < degrees.size() && !is_constant(rest); ++i) {
            if (degrees[i] == 0) continue;
            const SparsePolynomial x = SparsePolynomial::variable(i);
            try_factor(x);
            for (std::size_t j = i + 1; j < degrees.size() && rest.total_degree() > 1; ++j) {
                if (degrees[j] > 0) try_factor(x - SparsePolynomial::variable(j));
            }
        }
    }
    std::ranges::sort(result.factors);
    result.unit *= rest.coefficient(0);
    if (is_constant(rest)) return result;
    rest *= SparsePolynomial(Rational(1) / rest.coefficient(0));
    split_powers(rest, result);
    return result;
}

void FractionSum::add(Fraction summand) {
    if (summand.is_zero()) return;
    auto group = std::ranges::find(groups_, summand.denominator, &Group::denominator);
    if (group == groups_.end()) group = groups_.insert(groups_.end(), {std::move(summand.denominator), {}});
    SparsePolynomial carry = std::move(summand.numerator);
    for (SparsePolynomial& partial : group->partial_sums) {
        if (partial.is_zero()) {
            partial = std::move(carry);
            return;
        }
        carry = sum_of(partial, carry);
        partial = {};
    }
    group->partial_sums.push_back(std::move(carry));
}

SparsePolynomial FractionSum::sum_of(const SparsePolynomial& a, const SparsePolynomial& b) {
    field_->spend(0, a.size() + b.size());
    SparsePolynomial sum = a + b;
    field_->spend(sum.size(), 0);
    return sum;
}

Fraction FractionSum::result() && {
    std::vector<Fraction> totals;
    for (Group& group : groups_) {
        SparsePolynomial total;
        for (const SparsePolynomial& partial : group.partial_sums) total = sum_of(total, partial);
        if (total.is_zero()) continue;
        const bool one_summand = group.partial_sums.size() == 1;
        Fraction fraction{std::move(total), std::move(group.denominator)};
        totals.push_back(one_summand ? std::move(fraction) : field_->reduced(std::move(fraction)));
    }
    if (totals.empty()) return {};
    if (totals.size() == 1) return std::move(totals.front());

    auto [numerators, denominator] = field_->over_common_denominator(totals);
    std::size_t terms = 0;
    for (const SparsePolynomial& numerator : numerators) terms += numerator.size();
    field_->spend(0, terms);
    SparsePolynomial numerator = blossom::sum(numerators);
    field_->spend(numerator.size(), 0);
    if (numerator.is_zero()) return {};
    // a / f^2 + b / f cannot be written over f if f does not divide a.
    Factors shared;
    Factors alone;
    for (const auto& factor : denominator) {
        const auto has_all = [&](const Fraction& total) {
            return std::ranges::find(total.denominator, factor) != total.denominator.end();
        };
        (std::ranges::count_if(totals, has_all) > 1 ? shared : alone).push_back(factor);
    }
    field_->cancel(numerator, shared);
    return {std::move(numerator), multiplied(shared, alone)};
}

}  // namespace blossom::proofs
