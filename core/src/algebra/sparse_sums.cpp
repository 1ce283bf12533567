#include <algorithm>
#include <deque>

#include "summand_streams.hpp"

namespace blossom {

namespace {

using summand_streams::ConsumedStream;
using summand_streams::merged;
using summand_streams::sum_of;
using summand_streams::Summand;

SparsePolynomial sum_of(std::span<const Summand> summands, const SparseLayout& layout, Integer denominator) {
    if (summands.empty()) return {};
    return packed_monomials::with_width(layout.words(), [&](const auto& width) {
        return SparseArithmetic::polynomial(sum_of(width, summands), layout, std::move(denominator));
    });
}

/// a + sign * b for nonzero a and b.
SparsePolynomial sum_of_two(const SparsePolynomial& a, const SparsePolynomial& b, int sign) {
    const SparseLayout layout =
        SparseArithmetic::common_layout(SparseArithmetic::layout(a), SparseArithmetic::layout(b));
    const Integer& of_a = a.coefficients().denominator();
    const Integer& of_b = b.coefficients().denominator();
    Integer denominator = of_a == of_b ? of_a : lcm(of_a, of_b);
    const AlignedTerms aligned[] = {{a, layout}, {b, layout}};
    const Summand summands[] = {{&aligned[0], nullptr, divide_exactly(denominator, of_a)},
                                {&aligned[1], nullptr, divide_exactly(denominator, of_b) * sign}};
    return sum_of(summands, layout, std::move(denominator));
}

/// A layout that can hold the product of two polynomials; degrees in each variable are added.
SparseLayout product_layout(const SparsePolynomial& a, const SparsePolynomial& b) {
    SparseLayout layout =
        SparseArithmetic::common_layout(SparseArithmetic::layout(a), SparseArithmetic::layout(b));
    const auto degrees = [&](const SparsePolynomial& polynomial) {
        const SparseLayout own = SparseArithmetic::layout(polynomial);
        std::vector<std::uint64_t> result = packed_monomials::rewritten(
            SparseArithmetic::degrees(polynomial), own.words(), own.bits, layout.words(), layout.bits);
        result.resize(layout.words());
        return result;
    };
    const std::vector<std::uint64_t> of_a = degrees(a);
    const std::vector<std::uint64_t> of_b = degrees(b);
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
        if (((of_a[i] + of_b[i]) & packed_monomials::guards(layout.bits)) == 0) continue;
        for (std::size_t k = 0; k < layout.variables; ++k) {
            greatest = std::max(greatest, packed_monomials::exponent(of_a, k, layout.bits) +
                                              packed_monomials::exponent(of_b, k, layout.bits));
        }
    }
    if (greatest > packed_monomials::greatest_exponent) SparseArithmetic::exponent_too_large();
    layout.bits = std::max(layout.bits, packed_monomials::bits_for(greatest));
    return layout;
}

/// The products of a with the terms of b, times `scale`.
void add_products(const AlignedTerms& a, const AlignedTerms& b, const SparseLayout& layout,
                  const Integer& scale, std::vector<Summand>& summands) {
    for (std::size_t i = 0; i < b.size(); ++i) {
        const std::uint64_t* monomial = b.monomials() + i * layout.words();
        const bool one =
            std::all_of(monomial, monomial + layout.words(), [](std::uint64_t w) { return w == 0; });
        summands.push_back({&a, one ? nullptr : monomial, b.coefficients()[i] * scale});
    }
}

/// A product of two polynomials as products of the larger factor with the terms of the smaller one.
struct Product {
    Product(const SparsePolynomial& a, const SparsePolynomial& b)
        : layout(product_layout(a, b)),
          larger(a, layout),
          smaller(b, layout),
          denominator(a.coefficients().denominator() * b.coefficients().denominator()) {
        add_products(larger, smaller, layout, 1, summands);
    }

    SparseLayout layout;
    AlignedTerms larger;
    AlignedTerms smaller;
    std::vector<Summand> summands;
    Integer denominator;
};

}  // namespace

SparsePolynomial operator+(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return sum_of_two(a, b, 1);
}

SparsePolynomial operator-(const SparsePolynomial& a) {
    SparsePolynomial result = a;
    std::vector<Integer> coefficients = a.coefficients_.numerators();
    for (Integer& coefficient : coefficients) coefficient.negate();
    result.coefficients_ = a.coefficients_.over_same_denominator(std::move(coefficients));
    return result;
}

SparsePolynomial operator-(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (b.is_zero()) return a;
    return a.is_zero() ? -b : sum_of_two(a, b, -1);
}

SparsePolynomial operator*(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (a.is_zero() || b.is_zero()) return {};
    if (a.size() < b.size()) return b * a;
    if (b.size() == 1 && b.degree(0) == 0) {
        const RationalVector& constant = b.coefficients_;
        SparsePolynomial result = a;
        result.coefficients_ = a.coefficients_.weighted(constant.numerators(), constant.denominator());
        result.coefficients_.make_canonical();
        return result;
    }
    const Product product(a, b);
    return sum_of(product.summands, product.layout, product.denominator);
}

std::optional<SparsePolynomial> product_within(const SparsePolynomial& a, const SparsePolynomial& b,
                                               std::size_t most_terms) {
    if (a.size() < b.size()) return product_within(b, a, most_terms);
    if (b.is_zero()) return SparsePolynomial();
    const Product product(a, b);
    const std::span summands = product.summands;
    const std::size_t at_a_time = std::max<std::size_t>(1, most_terms / a.size());
    return packed_monomials::with_width(
        product.layout.words(), [&]<class Width>(const Width& width) -> std::optional<SparsePolynomial> {
            SparseTerms total;
            for (std::size_t i = 0; i < summands.size(); i += at_a_time) {
                const auto slice = summands.subspan(i, std::min(at_a_time, summands.size() - i));
                SparseTerms next = sum_of(width, slice);
                total = i == 0 ? std::move(next)
                               : merged(width, ConsumedStream<Width>(width, total),
                                        ConsumedStream<Width>(width, next));
                if (total.size() > most_terms) return std::nullopt;
            }
            return SparseArithmetic::polynomial(std::move(total), product.layout, product.denominator);
        });
}

SparsePolynomial sum(std::span<const SparsePolynomial> summands) {
    if (summands.size() == 1) return summands.front();
    SparseLayout layout;
    Integer denominator = 1;
    for (const SparsePolynomial& polynomial : summands) {
        layout = SparseArithmetic::common_layout(layout, SparseArithmetic::layout(polynomial));
        denominator = lcm(denominator, polynomial.coefficients().denominator());
    }
    std::deque<AlignedTerms> aligned;
    std::vector<Summand> scaled;
    for (const SparsePolynomial& polynomial : summands) {
        if (polynomial.is_zero()) continue;
        Integer scale = divide_exactly(denominator, polynomial.coefficients().denominator());
        scaled.push_back({&aligned.emplace_back(polynomial, layout), nullptr, std::move(scale)});
    }
    return sum_of(scaled, layout, std::move(denominator));
}

SparsePolynomial dot(std::span<const SparsePolynomial> a, std::span<const SparsePolynomial> b) {
    SparseLayout layout;
    Integer denominator = 1;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].is_zero() || b[i].is_zero()) continue;
        layout = SparseArithmetic::common_layout(layout, product_layout(a[i], b[i]));
        denominator = lcm(denominator, a[i].coefficients().denominator() * b[i].coefficients().denominator());
    }
    std::deque<AlignedTerms> aligned;
    std::vector<Summand> summands;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].is_zero() || b[i].is_zero()) continue;
        const bool a_larger = a[i].size() >= b[i].size();
        const AlignedTerms& larger = aligned.emplace_back(a_larger ? a[i] : b[i], layout);
        const AlignedTerms& smaller = aligned.emplace_back(a_larger ? b[i] : a[i], layout);
        add_products(larger, smaller, layout,
                     divide_exactly(denominator,
                                    a[i].coefficients().denominator() * b[i].coefficients().denominator()),
                     summands);
    }
    return sum_of(summands, layout, std::move(denominator));
}

}  // namespace blossom
