#include "polynomial_merging.hpp"

#include <algorithm>

namespace blossom::proofs::second {

PlainPolynomial merged_terms(const ShiftedTerms& a, const ShiftedTerms& b, Budget& budget) {
    using Parts = PolynomialParts;
    const std::size_t width = a.terms.width();
    const std::size_t bound = a.terms.size() + b.terms.size();
    budget.spend(bound);
    PlainPolynomial result = Parts::empty(Parts::bits(a.terms), width, 0);
    std::vector<std::uint64_t>& monomials = Parts::monomials(result);
    std::vector<Integer>& coefficients = Parts::coefficients(result);
    monomials.resize(bound * width);
    coefficients.reserve(bound);
    std::uint64_t* target = monomials.data();
    std::size_t i = 0;
    std::size_t j = 0;
    const auto take = [&](const ShiftedTerms& from, std::size_t term) {
        const std::uint64_t* source = from.terms.monomial(term);
        for (std::size_t k = 0; k < width; ++k) target[k] = source[k] + from.shift[k];
        target += width;
        const Integer& coefficient = Parts::coefficients(from.terms)[term];
        coefficients.push_back(from.factor.is_one() ? coefficient : coefficient * from.factor);
    };
    while (i < a.terms.size() && j < b.terms.size()) {
        const std::uint64_t* left = a.terms.monomial(i);
        const std::uint64_t* right = b.terms.monomial(j);
        std::size_t k = 0;
        while (k < width && left[k] + a.shift[k] == right[k] + b.shift[k]) ++k;
        if (k < width) {
            if (left[k] + a.shift[k] > right[k] + b.shift[k]) {
                take(a, i++);
            } else {
                take(b, j++);
            }
            continue;
        }
        take(a, i++);
        coefficients.back().add_product(Parts::coefficients(b.terms)[j++], b.factor);
        if (coefficients.back().is_zero()) {
            coefficients.pop_back();
            target -= width;
        }
    }
    while (i < a.terms.size()) take(a, i++);
    while (j < b.terms.size()) take(b, j++);
    budget.require_terms(coefficients.size(), width);
    monomials.resize(coefficients.size() * width);
    if (coefficients.size() < bound / 2) {
        monomials.shrink_to_fit();
        coefficients.shrink_to_fit();
    }
    return result;
}

PlainPolynomial weighted_sum(const PlainPolynomial& a, const Rational& left, const PlainPolynomial& b,
                             const Rational& right, Budget& budget) {
    if (a.is_zero() || left.is_zero()) return scaled(b, right, budget);
    if (b.is_zero() || right.is_zero()) return scaled(a, left, budget);
    const AlignedPolynomials both(a, b, false, budget);
    const std::vector<std::uint64_t> unshifted(both.width());
    const Integer first = PolynomialParts::denominator(a) * left.denominator();
    const Integer second = PolynomialParts::denominator(b) * right.denominator();
    const Integer common = lcm(first, second);
    const Integer first_factor = left.numerator() * divide_exactly(common, first);
    const Integer second_factor = right.numerator() * divide_exactly(common, second);
    PlainPolynomial result = merged_terms({both.first(), unshifted.data(), first_factor},
                                          {both.second(), unshifted.data(), second_factor}, budget);
    PolynomialParts::denominator(result) = common;
    PolynomialParts::set_largest(result, both.largest());
    PolynomialParts::spend_on_bits(result, budget);
    PolynomialParts::reduce(result);
    return result;
}

PlainPolynomial sum(const PlainPolynomial& a, const PlainPolynomial& b, Budget& budget) {
    return weighted_sum(a, 1, b, 1, budget);
}

PlainPolynomial difference(const PlainPolynomial& a, const PlainPolynomial& b, Budget& budget) {
    return weighted_sum(a, 1, b, -1, budget);
}

PlainPolynomial scaled(const PlainPolynomial& a, const Rational& factor, Budget& budget) {
    if (factor.is_zero()) return {};
    PlainPolynomial result = a;
    if (factor == Rational(1)) return result;
    budget.spend(a.size());
    for (Integer& coefficient : PolynomialParts::coefficients(result)) coefficient *= factor.numerator();
    PolynomialParts::denominator(result) *= factor.denominator();
    PolynomialParts::spend_on_bits(result, budget);
    PolynomialParts::reduce(result);
    return result;
}

PlainPolynomial sum_of(std::vector<PlainPolynomial> summands, Budget& budget) {
    if (summands.empty()) return {};
    while (summands.size() > 1) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < summands.size(); k += 2) {
            summands[kept++] =
                k + 1 < summands.size() ? sum(summands[k], summands[k + 1], budget) : std::move(summands[k]);
        }
        summands.resize(kept);
    }
    return std::move(summands.front());
}

std::vector<PlainPolynomial> coefficients_by(const PlainPolynomial& a, std::size_t symbol, Budget& budget) {
    using Parts = PolynomialParts;
    budget.spend(a.size());
    std::vector<PlainPolynomial> result(a.degree(symbol) + 1,
                                        Parts::empty(Parts::bits(a), a.width(), Parts::largest(a)));
    std::vector<std::uint64_t> monomial(a.width());
    for (std::size_t k = 0; k < a.size(); ++k) {
        const std::size_t exponent = a.exponent(k, symbol);
        std::copy_n(a.monomial(k), a.width(), monomial.data());
        if (exponent > 0)
            Parts::add_to_field(monomial.data(), symbol, Parts::bits(a), -std::uint64_t{exponent});
        Parts::append(result[exponent], monomial.data(), Parts::coefficients(a)[k]);
    }
    for (PlainPolynomial& coefficient : result) {
        Parts::denominator(coefficient) = Parts::denominator(a);
        Parts::reduce(coefficient);
    }
    return result;
}

std::vector<PlainPolynomial> coefficients_by_monomials(const PlainPolynomial& a,
                                                       std::span<const std::size_t> symbols, Budget& budget) {
    std::vector<PlainPolynomial> result = {a};
    for (const std::size_t symbol : symbols) {
        if (a.degree(symbol) == 0) continue;
        std::vector<PlainPolynomial> finer;
        for (const PlainPolynomial& coefficient : result) {
            for (PlainPolynomial& part : coefficients_by(coefficient, symbol, budget)) {
                if (!part.is_zero()) finer.push_back(std::move(part));
            }
        }
        result = std::move(finer);
    }
    return result;
}

PlainPolynomial derivative_by(const PlainPolynomial& a, std::size_t symbol, Budget& budget) {
    using Parts = PolynomialParts;
    budget.spend(a.size());
    PlainPolynomial result = Parts::empty(Parts::bits(a), a.width(), Parts::largest(a));
    std::vector<std::uint64_t> monomial(a.width());
    for (std::size_t k = 0; k < a.size(); ++k) {
        const std::size_t exponent = a.exponent(k, symbol);
        if (exponent == 0) continue;
        std::copy_n(a.monomial(k), a.width(), monomial.data());
        Parts::add_to_field(monomial.data(), symbol, Parts::bits(a), -std::uint64_t{1});
        Parts::append(result, monomial.data(), Parts::coefficients(a)[k] * Integer(exponent));
    }
    Parts::denominator(result) = Parts::denominator(a);
    Parts::reduce(result);
    return result;
}

PlainPolynomial value_at(std::span<const PlainPolynomial> coefficients, const PlainPolynomial& x,
                         Budget& budget) {
    PlainPolynomial result;
    for (std::size_t k = coefficients.size(); k-- > 0;) {
        result = sum(product(result, x, budget), coefficients[k], budget);
    }
    return result;
}

}  // namespace blossom::proofs::second
