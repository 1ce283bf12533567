#include "change_of_interval.hpp"

#include <blossom/rational/bernstein_kernel.hpp>
#include <blossom/rational/taylor_shift.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

#include "binomial_weights.hpp"

namespace blossom {

namespace {

using Row = std::vector<Integer>;

/// row[k] *= base^k
void scale_by_powers(Row& row, const Integer& base) {
    if (base.is_one()) return;
    Integer power = base;
    for (std::size_t k = 1; k < row.size(); ++k) {
        row[k] *= power;
        if (k + 1 < row.size()) power *= base;
    }
}

/// row[k] *= base^(n - k)
void scale_by_falling_powers(Row& row, const Integer& base) {
    if (base.is_one()) return;
    Integer power = base;
    for (std::size_t k = row.size() - 1; k-- > 0;) {
        row[k] *= power;
        if (k > 0) power *= base;
    }
}

void divide_by_powers(Row& row, const Integer& base) {
    if (base.is_one()) return;
    Integer power = base;
    for (std::size_t k = 1; k < row.size(); ++k) {
        row[k] = divide_exactly(row[k], power);
        if (k + 1 < row.size()) power *= base;
    }
}

/// m_k q^n, where the m_k below lack the factor q^k; center = p/q.
Row unscaled_taylor_coefficients(std::span<const Integer> coefficients, const Rational& center) {
    const Integer& p = center.numerator();
    if (p.is_one() && center.denominator().is_one()) return shifted_by_one(coefficients);
    Row row(coefficients.begin(), coefficients.end());
    scale_by_falling_powers(row, center.denominator());
    if (p.is_zero()) return row;
    // With t = (p/q) s, t - p/q = (p/q) (s - 1).
    scale_by_powers(row, p);
    row = shifted_by_one(row);
    divide_by_powers(row, p);
    return row;
}

/// For fewer coefficients, digits are faster than residues (by measurement).
constexpr std::size_t least_coefficients_of_form = 64;

/// A quotient whose numerator and denominator are below 2^48 in magnitude.
std::optional<WordQuotient> as_words(const Rational& value) {
    const auto numerator = value.numerator().to_int64();
    const auto denominator = value.denominator().to_int64();
    constexpr std::int64_t limit = std::int64_t{1} << 48;
    if (!numerator || !denominator || *numerator <= -limit || *numerator >= limit || *denominator >= limit)
        return std::nullopt;
    return WordQuotient{*numerator, *denominator};
}

/// The numerators of the Bernstein coefficients from the form on the line through the ends p/q and r/s;
/// coefficient k has the denominator q^(n-k) s^k.
std::optional<Row> numerators_by_form(std::span<const Integer> coefficients, const WordQuotient& a,
                                      const WordQuotient& b, std::span<const Integer> weights) {
    if (coefficients.size() < least_coefficients_of_form) return std::nullopt;
    auto row = form_on_line(coefficients, a, b);
    if (!row) return std::nullopt;
    const std::size_t n = coefficients.size() - 1;
    const std::int64_t common = std::gcd(a.denominator, b.denominator);
    const Integer rising = a.denominator / common;
    const Integer falling = b.denominator / common;
    Integer scale = pow(falling, n);
    for (std::size_t k = 0; k <= n; ++k) {
        (*row)[k] *= weights[k] * scale;
        if (k < n) scale = divide_exactly(scale, falling) * rising;
    }
    return row;
}

/// The Bernstein coefficients over an interval whose ends are quotients of words.
std::optional<Quotients<Integer>> bernstein_between_words(std::span<const Integer> coefficients,
                                                          const Interval& interval) {
    const auto a = as_words(interval.a());
    const auto b = as_words(interval.b());
    if (!a || !b) return std::nullopt;
    const std::size_t n = coefficients.size() - 1;
    const auto weights = binomial_weights(n);
    auto row = bernstein_in_words(coefficients, *a, *b, weights->numerators);
    if (!row) row = numerators_by_form(coefficients, *a, *b, weights->numerators);
    if (!row) return std::nullopt;
    const Integer denominator = lcm(interval.a().denominator(), interval.b().denominator());
    return Quotients<Integer>{std::move(*row), weights->denominator * pow(denominator, n)};
}

}  // namespace

Quotients<Integer> taylor_coefficients(std::span<const Integer> coefficients, const Rational& center) {
    Row row = unscaled_taylor_coefficients(coefficients, center);
    scale_by_powers(row, center.denominator());
    return {std::move(row), pow(center.denominator(), coefficients.size() - 1)};
}

Quotients<Integer> bernstein_from_monomial(std::span<const Integer> coefficients, const Interval& interval) {
    if (auto quotients = bernstein_between_words(coefficients, interval)) return std::move(*quotients);
    const std::size_t n = coefficients.size() - 1;
    Row row = unscaled_taylor_coefficients(coefficients, interval.a());
    // t - a = length * s; common factors of the denominators of a and of the length cancel.
    const Rational length = interval.b() - interval.a();
    const Integer& q = interval.a().denominator();
    const Integer common = gcd(q, length.denominator());
    const Integer rest = divide_exactly(length.denominator(), common);
    scale_by_powers(row, length.numerator() * divide_exactly(q, common));
    scale_by_falling_powers(row, rest);
    std::ranges::reverse(row);
    row = shifted_by_one(row);
    std::ranges::reverse(row);
    const auto weights = binomial_weights(n);
    for (std::size_t k = 0; k <= n; ++k) row[k] *= weights->numerators[k];
    return {std::move(row), weights->denominator * pow(q * rest, n)};
}

}  // namespace blossom
