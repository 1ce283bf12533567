#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <deque>
#include <string>

#include "sparse_arithmetic.hpp"

namespace blossom {

namespace {

using Layout = SparseArithmetic::Layout;
using Terms = SparseArithmetic::Terms;
using Aligned = SparseArithmetic::Aligned;
using packed_monomials::greatest_exponent;
using packed_monomials::Width;
using Monomial = std::vector<std::uint64_t>;

/// Terms times one term, whose monomial is left out when it is 1.
struct Summand {
    const Aligned* terms;
    const std::uint64_t* monomial;
    Integer coefficient;
};

/// The terms of a summand one after the other.
template <class Width>
class SummandStream {
public:
    SummandStream(const Width& width, const Summand& summand)
        : width_(width),
          summand_(summand),
          monomial_(summand.terms->monomials()),
          coefficient_(summand.terms->coefficients()),
          left_(summand.terms->size()),
          product_(width.monomial()),
          scaled_(!summand.coefficient.is_one()) {
        shift();
    }

    std::size_t left() const { return left_; }
    const std::uint64_t* monomial() const { return summand_.monomial ? product_.data() : monomial_; }
    Integer take() {
        Integer result = scaled_ ? *coefficient_ * summand_.coefficient : *coefficient_;
        monomial_ += width_.words();
        ++coefficient_;
        --left_;
        shift();
        return result;
    }

private:
    void shift() {
        if (summand_.monomial && left_ > 0) width_.add(monomial_, summand_.monomial, product_.data());
    }

    Width width_;
    const Summand& summand_;
    const std::uint64_t* monomial_;
    const Integer* coefficient_;
    std::size_t left_;
    typename Width::Monomial product_;
    bool scaled_;
};

/// Terms one after the other; their coefficients are moved away.
template <class Width>
class ConsumedStream {
public:
    ConsumedStream(const Width& width, Terms& terms) : width_(width), terms_(terms) {}

    std::size_t left() const { return terms_.size() - next_; }
    const std::uint64_t* monomial() const { return terms_.monomials.data() + next_ * width_.words(); }
    Integer take() { return std::move(terms_.coefficients[next_++]); }

private:
    Width width_;
    Terms& terms_;
    std::size_t next_ = 0;
};

/// Terms as they are written, greatest first.
template <class Width>
class TermWriter {
public:
    TermWriter(const Width& width, std::size_t most) : width_(width) {
        terms_.monomials.resize(most * width.words());
        terms_.coefficients.reserve(most);
    }

    void append(const std::uint64_t* monomial, Integer&& coefficient) {
        width_.copy(monomial, terms_.monomials.data() + terms_.size() * width_.words());
        terms_.coefficients.push_back(std::move(coefficient));
    }
    template <class Stream>
    void append_next(Stream& stream) {
        width_.copy(stream.monomial(), terms_.monomials.data() + terms_.size() * width_.words());
        terms_.coefficients.push_back(stream.take());
    }
    Terms finished() && {
        terms_.monomials.resize(terms_.size() * width_.words());
        return std::move(terms_);
    }

private:
    Width width_;
    Terms terms_;
};

template <class Width, class Stream>
Terms merged(const Width& width, Stream a, Stream b) {
    constexpr std::uint64_t words_of_term = 16;
    spend_work(words_of_term * (a.left() + b.left()));
    TermWriter<Width> writer(width, a.left() + b.left());
    auto monomial = width.monomial();
    while (a.left() > 0 && b.left() > 0) {
        const int order = width.compare(a.monomial(), b.monomial());
        if (order > 0) {
            writer.append_next(a);
        } else if (order < 0) {
            writer.append_next(b);
        } else {
            width.copy(a.monomial(), monomial.data());
            Integer coefficient = a.take();
            coefficient += b.take();
            if (!coefficient.is_zero()) writer.append(monomial.data(), std::move(coefficient));
        }
    }
    while (a.left() > 0) writer.append_next(a);
    while (b.left() > 0) writer.append_next(b);
    return std::move(writer).finished();
}

/// The sum of all by halves.
template <class Width>
Terms sum_of(const Width& width, std::span<const Summand> summands) {
    using Stream = SummandStream<Width>;
    if (summands.size() == 1) {
        Stream stream(width, summands[0]);
        TermWriter<Width> writer(width, stream.left());
        while (stream.left() > 0) writer.append_next(stream);
        return std::move(writer).finished();
    }
    if (summands.size() == 2) return merged(width, Stream(width, summands[0]), Stream(width, summands[1]));
    const std::size_t half = summands.size() / 2;
    Terms a = sum_of(width, summands.first(half));
    Terms b = sum_of(width, summands.subspan(half));
    return merged(width, ConsumedStream<Width>(width, a), ConsumedStream<Width>(width, b));
}

SparsePolynomial sum_of(std::span<const Summand> summands, const Layout& layout, Integer denominator) {
    if (summands.empty()) return {};
    return packed_monomials::with_width(layout.words(), [&](const auto& width) {
        return SparseArithmetic::polynomial(sum_of(width, summands), layout, std::move(denominator));
    });
}

/// summands[0] + ... with the last one times `last_sign`.
SparsePolynomial weighted_sum(std::span<const SparsePolynomial* const> polynomials, int last_sign) {
    Layout layout;
    Integer denominator = 1;
    for (const SparsePolynomial* polynomial : polynomials) {
        layout = SparseArithmetic::common_layout(layout, SparseArithmetic::layout(*polynomial));
        denominator = lcm(denominator, polynomial->coefficients().denominator());
    }
    std::deque<Aligned> aligned;
    std::vector<Summand> summands;
    for (std::size_t i = 0; i < polynomials.size(); ++i) {
        const SparsePolynomial& polynomial = *polynomials[i];
        if (polynomial.is_zero()) continue;
        Integer scale = divide_exactly(denominator, polynomial.coefficients().denominator());
        if (last_sign < 0 && i + 1 == polynomials.size()) scale.negate();
        summands.push_back({&aligned.emplace_back(polynomial, layout), nullptr, std::move(scale)});
    }
    return sum_of(summands, layout, std::move(denominator));
}

/// A layout that holds the product of two polynomials, whose degrees in each variable add.
Layout product_layout(const SparsePolynomial& a, const SparsePolynomial& b) {
    Layout layout = SparseArithmetic::common_layout(SparseArithmetic::layout(a), SparseArithmetic::layout(b));
    const auto degrees = [&](const SparsePolynomial& polynomial) {
        const Layout own = SparseArithmetic::layout(polynomial);
        Monomial result = packed_monomials::rewritten(SparseArithmetic::degrees(polynomial), own.words(),
                                                      own.bits, layout.words(), layout.bits);
        result.resize(layout.words());
        return result;
    };
    const Monomial of_a = degrees(a);
    const Monomial of_b = degrees(b);
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
        if (((of_a[i] + of_b[i]) & packed_monomials::guards(layout.bits)) == 0) continue;
        for (std::size_t k = 0; k < layout.variables; ++k) {
            greatest = std::max(greatest, packed_monomials::exponent(of_a, k, layout.bits) +
                                              packed_monomials::exponent(of_b, k, layout.bits));
        }
    }
    if (greatest > greatest_exponent) SparseArithmetic::exponent_too_large();
    layout.bits = std::max(layout.bits, packed_monomials::bits_for(greatest));
    return layout;
}

/// The products of a with the terms of b, times `scale`.
void add_products(const Aligned& a, const Aligned& b, const Layout& layout, const Integer& scale,
                  std::vector<Summand>& summands) {
    for (std::size_t i = 0; i < b.size(); ++i) {
        const std::uint64_t* monomial = b.monomials() + i * layout.words();
        const bool one =
            std::all_of(monomial, monomial + layout.words(), [](std::uint64_t w) { return w == 0; });
        summands.push_back({&a, one ? nullptr : monomial, b.coefficients()[i] * scale});
    }
}

}  // namespace

void SparseArithmetic::exponent_too_large() {
    throw Error(
        ErrorCode::limit_exceeded,
        "an exponent exceeds the limit " + std::to_string(greatest_exponent) + " of a symbolic polynomial");
}

SparsePolynomial SparseArithmetic::polynomial(Terms terms, const Layout& layout, Integer denominator) {
    SparsePolynomial result;
    if (terms.size() == 0) return result;
    if (2 * terms.size() < terms.coefficients.capacity()) {
        terms.monomials.shrink_to_fit();
        terms.coefficients.shrink_to_fit();
    }
    result.variables_ = layout.variables;
    result.bits_ = layout.bits;
    result.words_ = layout.words();
    result.monomials_ = std::move(terms.monomials);
    result.coefficients_ = RationalVector(std::move(terms.coefficients), std::move(denominator));
    result.coefficients_.make_canonical();
    shrink(result);
    return result;
}

/// Gives up variables that do not occur, and bits that no exponent needs. Cost: up to the first terms that
/// need all, in what needs all.
void SparseArithmetic::shrink(SparsePolynomial& polynomial) {
    const std::size_t words = polynomial.words_;
    if (words == 0) return;
    const std::size_t bits = polynomial.bits_;
    const std::uint64_t large =
        packed_monomials::guards(bits) - (packed_monomials::ones(bits) << (bits / 2 - 1));
    const std::size_t last = (polynomial.variables_ - 1) * bits % 64;
    const std::uint64_t last_variable = (~std::uint64_t{0} >> (64 - bits)) << (64 - bits - last);
    bool needs_bits = bits == packed_monomials::least_bits;
    bool needs_variables = false;
    for (std::size_t i = 0; i < polynomial.monomials_.size() && !(needs_bits && needs_variables);
         i += words) {
        needs_variables = needs_variables || (polynomial.monomials_[i + words - 1] & last_variable) != 0;
        for (std::size_t j = 0; j < words && !needs_bits; ++j)
            needs_bits = (polynomial.monomials_[i + j] & large) != 0;
    }
    if (needs_bits && needs_variables) return;

    const Monomial greatest = degrees(polynomial);
    Layout layout{polynomial.variables_, bits};
    while (layout.variables > 0 && packed_monomials::exponent(greatest, layout.variables - 1, bits) == 0)
        --layout.variables;
    std::size_t exponent = 0;
    for (std::size_t k = 0; k < layout.variables; ++k)
        exponent = std::max(exponent, packed_monomials::exponent(greatest, k, bits));
    layout.bits = packed_monomials::bits_for(exponent);
    if (layout.words() != words || layout.bits != bits) {
        polynomial.monomials_ =
            packed_monomials::rewritten(polynomial.monomials_, words, bits, layout.words(), layout.bits);
    }
    polynomial.variables_ = layout.variables;
    polynomial.bits_ = layout.bits;
    polynomial.words_ = layout.words();
}

SparsePolynomial::SparsePolynomial(const Rational& constant) {
    if (!constant.is_zero()) coefficients_ = RationalVector({&constant, 1});
}

SparsePolynomial SparsePolynomial::variable(std::size_t index) {
    SparsePolynomial result(1);
    result.variables_ = index + 1;
    result.words_ = packed_monomials::words_for(result.variables_, result.bits_);
    result.monomials_.resize(result.words_);
    packed_monomials::set_exponent(result.monomials_, index, result.bits_, 1);
    return result;
}

SparsePolynomial SparsePolynomial::term(const Rational& coefficient, std::span<const std::size_t> exponents) {
    SparsePolynomial result(coefficient);
    if (result.is_zero()) return result;
    std::size_t greatest = 0;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        greatest = std::max(greatest, exponents[i]);
        if (exponents[i] > 0) result.variables_ = i + 1;
    }
    if (greatest > greatest_exponent) SparseArithmetic::exponent_too_large();
    result.bits_ = packed_monomials::bits_for(greatest);
    result.words_ = packed_monomials::words_for(result.variables_, result.bits_);
    result.monomials_.resize(result.words_);
    for (std::size_t i = 0; i < result.variables_; ++i)
        packed_monomials::set_exponent(result.monomials_, i, result.bits_, exponents[i]);
    return result;
}

std::size_t SparsePolynomial::exponent(std::size_t term, std::size_t variable) const {
    if (variable >= variables_) return 0;
    return packed_monomials::exponent(monomial(term), variable, bits_);
}

std::size_t SparsePolynomial::degree(std::size_t term) const {
    std::size_t sum = 0;
    for (const std::uint64_t word : monomial(term)) sum += packed_monomials::sum_of_exponents(word, bits_);
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
    const SparsePolynomial* const both[] = {&a, &b};
    return weighted_sum(both, 1);
}

SparsePolynomial operator-(const SparsePolynomial& a) {
    SparsePolynomial result = a;
    std::vector<Integer> coefficients = a.coefficients_.numerators();
    for (Integer& coefficient : coefficients) coefficient.negate();
    result.coefficients_ = a.coefficients_.over_same_denominator(std::move(coefficients));
    return result;
}

SparsePolynomial operator-(const SparsePolynomial& a, const SparsePolynomial& b) {
    const SparsePolynomial* const both[] = {&a, &b};
    return weighted_sum(both, -1);
}

SparsePolynomial operator*(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (a.is_zero() || b.is_zero()) return {};
    if (a.size() < b.size()) return b * a;
    const Layout layout = product_layout(a, b);
    const Aligned larger(a, layout);
    const Aligned smaller(b, layout);
    std::vector<Summand> summands;
    add_products(larger, smaller, layout, 1, summands);
    return sum_of(summands, layout, a.coefficients_.denominator() * b.coefficients_.denominator());
}

std::vector<std::size_t> SparsePolynomial::degrees() const {
    const Monomial greatest = SparseArithmetic::degrees(*this);
    std::vector<std::size_t> result(variables_);
    for (std::size_t i = 0; i < variables_; ++i) result[i] = packed_monomials::exponent(greatest, i, bits_);
    return result;
}

std::optional<SparsePolynomial> product_within(const SparsePolynomial& a, const SparsePolynomial& b,
                                               std::size_t most_terms) {
    if (a.size() < b.size()) return product_within(b, a, most_terms);
    if (b.is_zero()) return SparsePolynomial();
    const Layout layout = product_layout(a, b);
    const Aligned larger(a, layout);
    const Aligned smaller(b, layout);
    std::vector<Summand> summands;
    add_products(larger, smaller, layout, 1, summands);
    const std::size_t at_a_time = std::max<std::size_t>(1, most_terms / a.size());
    return packed_monomials::with_width(
        layout.words(), [&]<class Width>(const Width& width) -> std::optional<SparsePolynomial> {
            Terms total;
            for (std::size_t i = 0; i < summands.size(); i += at_a_time) {
                const auto slice = std::span(summands).subspan(i, std::min(at_a_time, summands.size() - i));
                Terms next = sum_of(width, slice);
                total = i == 0 ? std::move(next)
                               : merged(width, ConsumedStream<Width>(width, total),
                                        ConsumedStream<Width>(width, next));
                if (total.size() > most_terms) return std::nullopt;
            }
            return SparseArithmetic::polynomial(
                std::move(total), layout, a.coefficients().denominator() * b.coefficients().denominator());
        });
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
    if (summands.size() == 1) return summands.front();
    std::vector<const SparsePolynomial*> all;
    all.reserve(summands.size());
    for (const SparsePolynomial& summand : summands) all.push_back(&summand);
    return weighted_sum(all, 1);
}

SparsePolynomial dot(std::span<const SparsePolynomial> a, std::span<const SparsePolynomial> b) {
    Layout layout;
    Integer denominator = 1;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].is_zero() || b[i].is_zero()) continue;
        layout = SparseArithmetic::common_layout(layout, product_layout(a[i], b[i]));
        denominator = lcm(denominator, a[i].coefficients().denominator() * b[i].coefficients().denominator());
    }
    std::deque<Aligned> aligned;
    std::vector<Summand> summands;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].is_zero() || b[i].is_zero()) continue;
        const bool a_larger = a[i].size() >= b[i].size();
        const Aligned& larger = aligned.emplace_back(a_larger ? a[i] : b[i], layout);
        const Aligned& smaller = aligned.emplace_back(a_larger ? b[i] : a[i], layout);
        add_products(larger, smaller, layout,
                     divide_exactly(denominator,
                                    a[i].coefficients().denominator() * b[i].coefficients().denominator()),
                     summands);
    }
    return sum_of(summands, layout, std::move(denominator));
}

SparsePolynomial polynomial_value(std::span<const SparsePolynomial> coefficients, const SparsePolynomial& x) {
    if (coefficients.empty()) return {};
    return dot(coefficients, powers(x, coefficients.size() - 1));
}

}  // namespace blossom
