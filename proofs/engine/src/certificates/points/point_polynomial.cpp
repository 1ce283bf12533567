#include "point_polynomial.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

namespace {

void drop_zeros(PointPolynomial& polynomial) {
    while (!polynomial.empty() && polynomial.back().is_zero()) polynomial.pop_back();
}

/// Quotient and remainder; the leading coefficient of the divisor must be invertible.
std::pair<PointPolynomial, PointPolynomial> divided(const Algebra& algebra, PointPolynomial dividend,
                                                    const PointPolynomial& divisor) {
    if (dividend.size() < divisor.size()) return {PointPolynomial(), std::move(dividend)};
    const AlgebraNumber leading = algebra.inverse(divisor.back());
    PointPolynomial quotient(dividend.size() - divisor.size() + 1);
    for (std::size_t place = quotient.size(); place-- > 0;) {
        const AlgebraNumber factor = algebra.product(dividend[place + divisor.size() - 1], leading);
        for (std::size_t i = 0; i < divisor.size(); ++i) {
            dividend[place + i] =
                algebra.difference(dividend[place + i], algebra.product(factor, divisor[i]));
        }
        quotient[place] = factor;
    }
    drop_zeros(dividend);
    return {std::move(quotient), std::move(dividend)};
}

PointPolynomial minus_product(const Algebra& algebra, PointPolynomial a, const PointPolynomial& b,
                              const PointPolynomial& c) {
    if (!b.empty() && !c.empty()) a.resize(std::max(a.size(), b.size() + c.size() - 1));
    for (std::size_t i = 0; i < b.size(); ++i) {
        for (std::size_t k = 0; k < c.size(); ++k) {
            a[i + k] = algebra.difference(a[i + k], algebra.product(b[i], c[k]));
        }
    }
    drop_zeros(a);
    return a;
}

/// The divisors of |n|, if it is small enough to find them.
std::vector<std::int64_t> divisors_of(const Integer& n) {
    std::vector<std::int64_t> found;
    const std::optional<std::int64_t> word = abs(n).to_int64();
    constexpr std::int64_t most = 1'000'000'000;
    if (!word || *word == 0 || *word > most) return found;
    for (std::int64_t divisor = 1; divisor * divisor <= *word; ++divisor) {
        if (*word % divisor != 0) continue;
        found.push_back(divisor);
        found.push_back(*word / divisor);
    }
    return found;
}

std::optional<Integer> square_root_of(const Integer& n) {
    if (n.sign() <= 0) return n.is_zero() ? std::optional<Integer>(n) : std::nullopt;
    Integer root = Integer(1) << (n.bit_length() / 2 + 1);
    while (true) {
        Integer next = (root + n / root) / 2;
        if (next >= root) break;
        root = std::move(next);
    }
    if (root * root != n) return std::nullopt;
    return root;
}

}  // namespace

// The extended Euclidean algorithm for t^n and the series, stopped halfway: von zur Gathen, Gerhard, Modern
// Computer Algebra, section 5.7.
std::optional<PointPolynomial> numerator_of_series(const Algebra& algebra,
                                                   const std::vector<AlgebraNumber>& series) {
    const std::size_t length = series.size();
    PointPolynomial dividend(length + 1);
    dividend.back() = Rational(1);
    PointPolynomial remainder = series;
    drop_zeros(remainder);
    PointPolynomial cofactor_before;
    PointPolynomial cofactor{AlgebraNumber(Rational(1))};
    while (remainder.size() > length / 2) {
        auto [quotient, next] = divided(algebra, std::move(dividend), remainder);
        dividend = std::move(remainder);
        remainder = std::move(next);
        PointPolynomial next_cofactor =
            minus_product(algebra, std::move(cofactor_before), quotient, cofactor);
        cofactor_before = std::move(cofactor);
        cofactor = std::move(next_cofactor);
    }
    // One spare coefficient shows that the fraction is not accidental.
    if (remainder.empty() || remainder.size() + cofactor.size() > length) return std::nullopt;
    return remainder;
}

PointPolynomial squarefree_part(const Algebra& algebra, const PointPolynomial& polynomial) {
    PointPolynomial a = polynomial;
    PointPolynomial b;
    for (std::size_t i = 1; i < polynomial.size(); ++i) {
        b.push_back(algebra.product(polynomial[i], Rational(static_cast<std::int64_t>(i))));
    }
    while (!b.empty()) {
        PointPolynomial remainder = divided(algebra, std::move(a), b).second;
        a = std::move(b);
        b = std::move(remainder);
    }
    PointPolynomial part = divided(algebra, polynomial, a).first;
    const AlgebraNumber leading = algebra.inverse(part.back());
    for (AlgebraNumber& coefficient : part) coefficient = algebra.product(coefficient, leading);
    return part;
}

PointPolynomial shifted_back(const Algebra& algebra, PointPolynomial polynomial, const AlgebraNumber& shift) {
    for (std::size_t first = 0; first + 1 < polynomial.size(); ++first) {
        for (std::size_t i = polynomial.size() - 1; i-- > first;) {
            polynomial[i] = algebra.difference(polynomial[i], algebra.product(shift, polynomial[i + 1]));
        }
    }
    return polynomial;
}

std::vector<Rational> rational_roots(const PointPolynomial& polynomial) {
    std::vector<Rational> found;
    Integer common = 1;
    for (const AlgebraNumber& coefficient : polynomial) {
        if (!coefficient.is_rational()) return found;
        common = lcm(common, coefficient.constant().denominator());
    }
    std::vector<Integer> integers;
    for (const AlgebraNumber& coefficient : polynomial) {
        integers.push_back((coefficient.constant() * Rational(common)).numerator());
    }
    if (integers.size() == 3) {
        const Integer discriminant = integers[1] * integers[1] - 4 * integers[0] * integers[2];
        if (const std::optional<Integer> root = square_root_of(discriminant)) {
            found.emplace_back(*root - integers[1], 2 * integers[2]);
            found.emplace_back(-*root - integers[1], 2 * integers[2]);
        }
        return found;
    }
    const auto try_root = [&](const Rational& root) {
        Rational value;
        for (std::size_t i = integers.size(); i-- > 0;) value = value * root + Rational(integers[i]);
        if (value.is_zero() && std::ranges::find(found, root) == found.end()) found.push_back(root);
    };
    try_root(0);
    const std::size_t lowest = integers.front().is_zero() ? 1 : 0;
    const std::vector<std::int64_t> numerators = divisors_of(integers[lowest]);
    const std::vector<std::int64_t> denominators = divisors_of(integers.back());
    if (numerators.size() * denominators.size() > 4096) return found;
    for (const std::int64_t numerator : numerators) {
        for (const std::int64_t denominator : denominators) {
            try_root(Rational(numerator) / Rational(denominator));
            try_root(Rational(-numerator) / Rational(denominator));
        }
    }
    return found;
}

// By Horner's rule.
DividedByRoot divided_by_root(const Algebra& algebra, const PointPolynomial& polynomial,
                              const AlgebraNumber& root) {
    DividedByRoot result;
    result.quotient.resize(polynomial.size() - 1);
    AlgebraNumber value = polynomial.back();
    for (std::size_t i = polynomial.size() - 1; i-- > 0;) {
        result.quotient[i] = value;
        value = algebra.sum(algebra.product(value, root), polynomial[i]);
    }
    result.value = std::move(value);
    return result;
}

void LinearSystem::subtract(std::vector<AlgebraNumber>& from, const std::vector<AlgebraNumber>& pivot_row,
                            std::size_t column) const {
    const AlgebraNumber factor = from[column];
    if (factor.is_zero()) return;
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (!pivot_row[i].is_zero())
            from[i] = algebra_.difference(from[i], algebra_.product(factor, pivot_row[i]));
    }
}

LinearSystem::Effect LinearSystem::add(std::vector<AlgebraNumber> row) {
    const std::size_t unknowns = pivot_of_.size();
    for (std::size_t i = 0; i < unknowns; ++i) {
        if (pivot_of_[i]) subtract(row, rows_[*pivot_of_[i]], i);
    }
    bool has_coefficient = false;
    for (std::size_t column = 0; column < unknowns; ++column) {
        if (row[column].is_zero()) continue;
        has_coefficient = true;
        AlgebraNumber inverse;
        try {
            inverse = algebra_.inverse(row[column]);
        } catch (const Error&) {
            continue;
        }
        for (AlgebraNumber& entry : row) entry = algebra_.product(entry, inverse);
        for (std::vector<AlgebraNumber>& other : rows_) subtract(other, row, column);
        pivot_of_[column] = rows_.size();
        rows_.push_back(std::move(row));
        return Effect::new_pivot;
    }
    if (has_coefficient) throw Error(ErrorCode::division_by_zero, "a pivot is a divisor of zero");
    return row.back().is_zero() ? Effect::nothing_new : Effect::impossible;
}

std::vector<AlgebraNumber> LinearSystem::solution() const {
    std::vector<AlgebraNumber> values(pivot_of_.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (pivot_of_[i]) values[i] = rows_[*pivot_of_[i]].back();
    }
    return values;
}

}  // namespace blossom::proofs::second
