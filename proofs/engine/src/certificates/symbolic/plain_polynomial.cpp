#include "plain_polynomial.hpp"

#include "polynomial_parts.hpp"

#include <blossom/rational/resource_budget.hpp>

#include <algorithm>

namespace blossom::proofs::second {

void Budget::spend(std::size_t operations) {
    if (operations > work_ - spent_) {
        throw limit_error("the number of term operations exceeds", "expansion_work", work_);
    }
    spent_ += operations;
    constexpr std::uint64_t words_of_operation = 32;
    spend_work(words_of_operation * operations);
}

void Budget::spend_on_bits(std::size_t bits, std::size_t terms) {
    constexpr std::size_t bits_of_an_operation = 1024;
    if (bits < bits_of_an_operation) return;
    if (bits / 4 > digits_) {
        throw limit_error("the digits of a number exceed", "digits", digits_);
    }
    spend(bits / bits_of_an_operation * terms);
}

void Budget::require_terms(std::size_t terms, std::size_t words_per_term) const {
    if (terms > terms_) {
        throw limit_error("the number of terms, " + std::to_string(terms) + ", exceeds", "expansion_terms",
                          terms_);
    }
    if (words_per_term > 32 && terms > terms_ * 32 / words_per_term) {
        throw limit_error("a polynomial of " + std::to_string(terms) + " terms has too many symbols for",
                          "expansion_terms", terms_);
    }
}

PlainPolynomial::PlainPolynomial(const Rational& number) {
    if (number.is_zero()) return;
    coefficients_.push_back(number.numerator());
    denominator_ = number.denominator();
}

PlainPolynomial PlainPolynomial::symbol(std::size_t number) {
    const std::pair<std::size_t, std::size_t> power(number, 1);
    return single_term(1, std::span(&power, 1));
}

PlainPolynomial single_term(const Rational& coefficient,
                            std::span<const std::pair<std::size_t, std::size_t>> powers) {
    constexpr std::size_t exponent_end = 1 << 15;
    std::size_t symbols = 0;
    std::size_t total = 0;
    for (const auto& [symbol, exponent] : powers) {
        total = exponent < exponent_end ? total + exponent : exponent_end;
        if (total >= exponent_end) {
            throw Error(ErrorCode::limit_exceeded, "an exponent of 32768 or more");
        }
        if (exponent > 0) symbols = std::max(symbols, symbol + 1);
    }
    if (coefficient.is_zero()) return {};
    const unsigned bits = total < 128 ? 8 : 16;
    PlainPolynomial result = PolynomialParts::empty(bits, PolynomialParts::width_for(symbols, bits), total);
    std::vector<std::uint64_t> monomial(result.width());
    for (const auto& [symbol, exponent] : powers) {
        if (exponent > 0) PolynomialParts::add_to_field(monomial.data(), symbol, bits, exponent);
    }
    PolynomialParts::append(result, monomial.data(), coefficient.numerator());
    PolynomialParts::denominator(result) = coefficient.denominator();
    return result;
}

bool PlainPolynomial::is_number() const {
    return size() == 0 ||
           (size() == 1 && std::ranges::all_of(monomials_, [](std::uint64_t w) { return w == 0; }));
}

Rational PlainPolynomial::number() const { return is_zero() ? Rational() : coefficient(size() - 1); }

std::size_t PlainPolynomial::exponent(std::size_t term, std::size_t symbol) const {
    if (symbol / PolynomialParts::fields_per_word(bits_) >= width_) return 0;
    return static_cast<std::size_t>(PolynomialParts::field_of(monomial(term), symbol, bits_));
}

std::size_t PlainPolynomial::degree(std::size_t symbol) const {
    std::size_t result = 0;
    for (std::size_t k = 0; k < size(); ++k) result = std::max(result, exponent(k, symbol));
    return result;
}

std::vector<std::size_t> PlainPolynomial::symbols() const {
    std::vector<std::uint64_t> together(width_);
    for (std::size_t k = 0; k < size(); ++k) {
        for (std::size_t word = 0; word < width_; ++word) together[word] |= monomial(k)[word];
    }
    std::vector<std::size_t> result;
    for (std::size_t symbol = 0; symbol < width_ * PolynomialParts::fields_per_word(bits_); ++symbol) {
        if (PolynomialParts::field_of(together.data(), symbol, bits_) != 0) result.push_back(symbol);
    }
    return result;
}

PlainPolynomial PlainPolynomial::primitive() const {
    PlainPolynomial result = *this;
    result.denominator_ = 1;
    if (is_zero()) return result;
    Integer content = 0;
    for (const Integer& coefficient : coefficients_) {
        content = gcd(content, coefficient);
        if (content.is_one()) break;
    }
    if (coefficients_.front().sign() < 0) content.negate();
    if (content.is_one()) return result;
    for (Integer& coefficient : result.coefficients_) coefficient = divide_exactly(coefficient, content);
    return result;
}

std::size_t PlainPolynomial::hash() const {
    // Trailing zero words, which another layout may have, do not change the hash. The fields are read
    // separately only if they are wide.
    std::size_t result = std::hash<Integer>{}(denominator_);
    for (std::size_t k = 0; k < size(); ++k) {
        std::size_t symbol = 0;
        for (std::size_t word = 0; word < width_; ++word) {
            for (unsigned shift = 64; shift > 0; ++symbol) {
                shift -= bits_;
                const std::uint64_t exponent = monomial(k)[word] >> shift & (bits_ == 8 ? 0xFF : 0xFFFF);
                result += static_cast<std::size_t>(exponent * (2 * symbol + 1) * 0x9E3779B97F4A7C15);
            }
        }
        result = (result ^ std::hash<Integer>{}(coefficients_[k])) * 0x100000001B3;
    }
    return result;
}

bool operator==(const PlainPolynomial& a, const PlainPolynomial& b) {
    if (a.coefficients_ != b.coefficients_ || a.denominator_ != b.denominator_) return false;
    if (a.bits_ == b.bits_ && a.width_ == b.width_) return a.monomials_ == b.monomials_;
    const unsigned bits = std::max(a.bits_, b.bits_);
    const std::size_t width = std::max(a.width_ * bits / a.bits_, b.width_ * bits / b.bits_);
    return PolynomialParts::converted(a, bits, width).monomials_ ==
           PolynomialParts::converted(b, bits, width).monomials_;
}

PlainPolynomial PolynomialParts::converted(const PlainPolynomial& a, unsigned bits, std::size_t width) {
    if (a.bits_ == bits && a.width_ == width) return a;
    PlainPolynomial result = empty(bits, width, a.largest_);
    result.coefficients_ = a.coefficients_;
    result.denominator_ = a.denominator_;
    result.monomials_.resize(a.size() * width);
    for (std::size_t k = 0; k < a.size(); ++k) {
        std::uint64_t* target = result.monomials_.data() + k * width;
        if (a.bits_ == bits) {
            std::copy_n(a.monomial(k), std::min(width, a.width_), target);
            continue;
        }
        for (std::size_t symbol = 0; symbol < a.width_ * fields_per_word(a.bits_); ++symbol) {
            const std::uint64_t exponent = field_of(a.monomial(k), symbol, a.bits_);
            if (exponent != 0) add_to_field(target, symbol, bits, exponent);
        }
    }
    return result;
}

void PolynomialParts::reduce(PlainPolynomial& a) {
    if (a.is_zero()) {
        a = PlainPolynomial();
        return;
    }
    if (a.denominator_.is_one()) return;
    Integer common = a.denominator_;
    for (const Integer& coefficient : a.coefficients_) {
        common = gcd(common, coefficient);
        if (common.is_one()) return;
    }
    a.denominator_ = divide_exactly(a.denominator_, common);
    for (Integer& coefficient : a.coefficients_) coefficient = divide_exactly(coefficient, common);
}

void PolynomialParts::spend_on_bits(const PlainPolynomial& a, Budget& budget) {
    if (a.is_zero()) return;
    budget.spend_on_bits(std::max({a.coefficients_.front().bit_length(), a.coefficients_.back().bit_length(),
                                   a.denominator_.bit_length()}),
                         a.size());
}

AlignedPolynomials::AlignedPolynomials(const PlainPolynomial& a, const PlainPolynomial& b, bool for_product,
                                       Budget& budget)
    : first_(a), second_(b) {
    const auto greatest = [](const PlainPolynomial& of) {
        std::uint64_t result = 0;
        for (const std::size_t symbol : of.symbols())
            result = std::max(result, std::uint64_t{of.degree(symbol)});
        return result;
    };
    const auto joined = [&](std::uint64_t of_a, std::uint64_t of_b) {
        return for_product ? of_a + of_b : std::max(of_a, of_b);
    };
    bits_ = std::max(PolynomialParts::bits(a), PolynomialParts::bits(b));
    largest_ = joined(PolynomialParts::largest(a), PolynomialParts::largest(b));
    if (largest_ >= std::uint64_t{1} << (bits_ - 1)) {  // the bounds may be too large: take the exponents
        largest_ = joined(greatest(a), greatest(b));
        if (largest_ >= 128) bits_ = 16;
        if (largest_ >= 1 << 15) throw Error(ErrorCode::limit_exceeded, "an exponent of 32768 or more");
    }
    const auto words = [&](const PlainPolynomial& of) {
        return of.width() * bits_ / PolynomialParts::bits(of);
    };
    width_ = std::max(words(a), words(b));
    const auto copy = [&](const PlainPolynomial& of, std::optional<PlainPolynomial>& target) {
        if (of.width() == width_ && PolynomialParts::bits(of) == bits_) return;
        budget.spend(of.size());
        target = PolynomialParts::converted(of, bits_, width_);
    };
    copy(first_, first_copy_);
    copy(second_, second_copy_);
}

std::string text_of(const PlainPolynomial& a, std::span<const std::string> names) {
    constexpr std::size_t longest = 200;
    const auto shortened = [](const std::string& text) {
        return text.size() > longest ? text.substr(0, longest) + "..." : text;
    };
    if (a.is_zero()) return "0";
    std::string result;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (result.size() > longest) return shortened(result);
        const Rational coefficient = a.coefficient(k);
        if (k > 0) result += coefficient.sign() < 0 ? " - " : " + ";
        if (k == 0 && coefficient.sign() < 0) result += "-";
        std::string factors;
        for (const std::size_t symbol : a.symbols()) {
            const std::size_t exponent = a.exponent(k, symbol);
            if (exponent == 0) continue;
            factors += (factors.empty() ? "" : "*") + names[symbol];
            if (exponent > 1) factors += "^" + std::to_string(exponent);
        }
        const Rational size = abs(coefficient);
        if (factors.empty() || size != Rational(1)) result += to_string(size) + (factors.empty() ? "" : "*");
        result += factors;
    }
    return shortened(result);
}

}  // namespace blossom::proofs::second
