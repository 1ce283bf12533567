#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "sparse_arithmetic.hpp"

namespace blossom {

namespace {

using packed_monomials::divides;
using Monomial = std::vector<std::uint64_t>;

Integer content(const SparsePolynomial& polynomial) {
    Integer common = 0;
    for (const Integer& coefficient : polynomial.coefficients().numerators()) {
        common = gcd(common, coefficient);
        if (common.is_one()) break;
    }
    return common;
}

/// The products of all terms but the first of a divisor with the terms of a growing quotient: a heap of the
/// greatest remaining product of each term of the divisor.
template <class Width>
class GrowingProducts {
public:
    GrowingProducts(const Width& width, const AlignedTerms& divisor, const SparseTerms& quotient)
        : width_(width), divisor_(divisor), quotient_(quotient), next_(divisor.size()) {
        for (std::size_t term = 1; term < divisor.size(); ++term) waiting_.push_back(term);
        products_.resize(divisor.size() * width.words());
    }

    bool empty() const { return heap_.empty(); }
    /// The greatest monomial.
    const std::uint64_t* monomial() const { return product(heap_.front()); }
    /// Subtracts the coefficient of the greatest product, and removes this product.
    void subtract_from(Integer& coefficient) {
        const std::size_t term = heap_.front();
        std::pop_heap(heap_.begin(), heap_.end(), less());
        heap_.pop_back();
        coefficient -= divisor_.coefficients()[term] * quotient_.coefficients[next_[term]];
        if (++next_[term] < quotient_.size()) {
            push(term);
        } else {
            waiting_.push_back(term);
        }
    }
    /// Adds to the heap the terms that waited for the next term of the quotient.
    void add_waiting() {
        for (const std::size_t term : waiting_) push(term);
        waiting_.clear();
    }

private:
    const std::uint64_t* product(std::size_t term) const { return products_.data() + term * width_.words(); }
    auto less() const {
        return [this](std::size_t a, std::size_t b) { return width_.compare(product(a), product(b)) < 0; };
    }
    void push(std::size_t term) {
        width_.add(divisor_.monomials() + term * width_.words(),
                   quotient_.monomials.data() + next_[term] * width_.words(),
                   products_.data() + term * width_.words());
        heap_.push_back(term);
        std::push_heap(heap_.begin(), heap_.end(), less());
    }

    Width width_;
    const AlignedTerms& divisor_;
    const SparseTerms& quotient_;
    std::vector<std::size_t> next_;  ///< the quotient term that each term is multiplied with
    std::vector<std::uint64_t> products_;
    std::vector<std::size_t> heap_;
    std::vector<std::size_t> waiting_;
};

/// The quotient of the numerators, where those of b are divided by their content; `greatest` bounds its
/// exponents.
template <class Width>
std::optional<SparseTerms> quotient_of_numerators(const Width& width, const AlignedTerms& a,
                                                  const AlignedTerms& b, const Integer& content_of_b,
                                                  const Monomial& greatest, std::size_t bits,
                                                  std::size_t most_work, std::size_t& work) {
    const std::size_t words = width.words();
    const Integer leading = divide_exactly(b.coefficients()[0], content_of_b);
    SparseTerms quotient;
    GrowingProducts<Width> products(width, b, quotient);
    auto monomial = width.monomial();
    for (std::size_t next = 0; next < a.size() || !products.empty();) {
        if (work > most_work) return std::nullopt;
        ++work;
        const std::uint64_t* from_a = a.monomials() + next * words;
        const bool take_a =
            next < a.size() && (products.empty() || width.compare(from_a, products.monomial()) >= 0);
        width.copy(take_a ? from_a : products.monomial(), monomial.data());
        Integer coefficient = 0;
        while (!products.empty() && width.compare(products.monomial(), monomial.data()) == 0) {
            products.subtract_from(coefficient);
            ++work;
        }
        if (!content_of_b.is_one()) coefficient = divide_exactly(coefficient, content_of_b);
        if (take_a) coefficient += a.coefficients()[next++];
        if (coefficient.is_zero()) continue;
        if (!divides({b.monomials(), words}, {monomial.data(), words}, bits)) return std::nullopt;
        for (std::size_t i = 0; i < words; ++i) monomial[i] -= b.monomials()[i];
        if (!divides({monomial.data(), words}, greatest, bits)) return std::nullopt;
        if (!leading.is_one()) {
            if (!(coefficient % leading).is_zero()) return std::nullopt;
            coefficient = divide_exactly(coefficient, leading);
        }
        quotient.monomials.insert(quotient.monomials.end(), monomial.begin(), monomial.end());
        quotient.coefficients.push_back(std::move(coefficient));
        products.add_waiting();
    }
    return quotient;
}

}  // namespace

Division divide(const SparsePolynomial& a, const SparsePolynomial& b, std::size_t most_work) {
    if (b.is_zero())
        throw Error(ErrorCode::division_by_zero, "a polynomial cannot be divided by the zero polynomial");
    if (a.is_zero()) return {SparsePolynomial(), 0};
    if (b.variables() > a.variables()) return {std::nullopt, 1};
    const SparseLayout layout = SparseArithmetic::layout(a);
    if (SparseArithmetic::layout(b).bits > layout.bits) return {std::nullopt, 1};
    const std::size_t words = layout.words();
    const AlignedTerms dividend(a, layout);
    const AlignedTerms divisor(b, layout);
    const auto term = [&](const AlignedTerms& terms, std::size_t i) {
        return std::span(terms.monomials() + i * words, words);
    };
    if (!divides(term(divisor, 0), term(dividend, 0), layout.bits) ||
        !divides(term(divisor, b.size() - 1), term(dividend, a.size() - 1), layout.bits)) {
        return {std::nullopt, 1};
    }
    Monomial greatest = SparseArithmetic::degrees(a);
    const Monomial below =
        packed_monomials::greatest_exponents({divisor.monomials(), b.size() * words}, words, layout.bits);
    Division result{std::nullopt, a.size() + b.size()};
    if (!divides(below, greatest, layout.bits)) return result;
    for (std::size_t i = 0; i < words; ++i) greatest[i] -= below[i];

    const Integer content_of_b = content(b);
    auto quotient = packed_monomials::with_width(words, [&](const auto& width) {
        return quotient_of_numerators(width, dividend, divisor, content_of_b, greatest, layout.bits,
                                      most_work, result.work);
    });
    if (!quotient) return result;
    const Integer& scale = b.coefficients().denominator();
    if (!scale.is_one()) {
        for (Integer& coefficient : quotient->coefficients) coefficient *= scale;
    }
    result.quotient = SparseArithmetic::polynomial(std::move(*quotient), layout,
                                                   a.coefficients().denominator() * content_of_b);
    return result;
}

SparsePolynomial divide_exactly(const SparsePolynomial& a, const SparsePolynomial& b) {
    Division division = divide(a, b);
    if (!division.quotient)
        throw Error(ErrorCode::inexact_division, "the divisor does not divide the polynomial");
    return std::move(*division.quotient);
}

}  // namespace blossom
