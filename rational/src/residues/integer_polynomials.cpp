#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <cstdint>

#include "prime_images.hpp"

namespace blossom {

namespace {

/// Whether a number above 37 is prime; these bases of the Miller-Rabin test decide for all 64-bit numbers.
bool is_prime(std::uint64_t number) {
    const auto zeros = static_cast<unsigned>(__builtin_ctzll(number - 1));
    for (const unsigned base : {2U, 3U, 5U, 7U, 11U, 13U, 17U, 19U, 23U, 29U, 31U, 37U}) {
        std::uint64_t power = modular::power(base, (number - 1) >> zeros, number);
        if (power == 1 || power == number - 1) continue;
        bool composite = true;
        for (unsigned i = 1; i < zeros && composite; ++i) {
            power = modular::product(power, power, number);
            composite = power != number - 1;
        }
        if (composite) return false;
    }
    return true;
}

void trim(auto& polynomial, const auto& is_zero) {
    while (!polynomial.empty() && is_zero(polynomial.back())) polynomial.pop_back();
}

/// Divides by the leading coefficient.
void make_monic(WordList& polynomial, const PrimeField& field) {
    const std::uint64_t inverse = field.inverse(polynomial.back());
    for (std::uint64_t& coefficient : polynomial) coefficient = field.product(coefficient, inverse);
}

/// Of two polynomials that are not zero modulo the prime; monic.
WordList gcd_in(const PrimeField& field, WordList a, WordList b) {
    if (a.size() < b.size()) std::swap(a, b);
    while (!b.empty()) {
        make_monic(b, field);
        spend_work(4 * b.size() * (a.size() - b.size() + 1));
        while (a.size() >= b.size()) {
            const std::uint64_t factor = field.prime() - a.back();
            const std::size_t shift = a.size() - b.size();
            if (a.back() != 0) {
                for (std::size_t k = 0; k + 1 < b.size(); ++k)
                    a[shift + k] = field.sum(a[shift + k], field.product(factor, b[k]));
            }
            a.pop_back();
        }
        trim(a, [](std::uint64_t word) { return word == 0; });
        std::swap(a, b);
    }
    return a;
}

IntegerPolynomial primitive_part(IntegerPolynomial polynomial) {
    Integer content;
    for (const Integer& coefficient : polynomial) {
        content = gcd(content, coefficient);
        if (content.is_one()) break;
    }
    if (polynomial.back().sign() < 0) content.negate();
    if (content.is_one()) return polynomial;
    for (Integer& coefficient : polynomial) coefficient = divide_exactly(coefficient, content);
    return polynomial;
}

}  // namespace

std::uint64_t prime_below(std::uint64_t number) {
    do number -= 2;
    while (!is_prime(number));
    return number;
}

void Combination::add(const WordList& words, const PrimeField& field) {
    values_.resize(words.size());
    const std::uint64_t scale = field.inverse(field.of(modulus_));
    for (std::size_t k = 0; k < words.size(); ++k) {
        const std::uint64_t difference = field.sum(words[k], field.prime() - field.of(values_[k]));
        values_[k].add_product(modulus_, Integer(field.product(difference, scale)));
    }
    modulus_ *= Integer(field.prime());
}

IntegerPolynomial Combination::values() const {
    IntegerPolynomial centred = values_;
    const Integer half = modulus_ >> 1;
    for (Integer& value : centred) {
        if (value > half) value -= modulus_;
    }
    return centred;
}

std::optional<IntegerPolynomial> exact_quotient(std::span<const Integer> a, std::span<const Integer> b) {
    if (a.size() < b.size()) return a.empty() ? std::optional(IntegerPolynomial()) : std::nullopt;
    IntegerPolynomial remainder(a.begin(), a.end());
    IntegerPolynomial quotient(a.size() - b.size() + 1);
    for (std::size_t step = quotient.size(); step-- > 0;) {
        const Integer& top = remainder.back();
        Integer factor = top / b.back();
        if (factor * b.back() != top) return std::nullopt;
        const Integer negative = -factor;
        for (std::size_t k = 0; k + 1 < b.size(); ++k) remainder[step + k].add_product(negative, b[k]);
        remainder.pop_back();
        quotient[step] = std::move(factor);
    }
    if (!std::ranges::all_of(remainder, &Integer::is_zero)) return std::nullopt;
    return quotient;
}

IntegerPolynomial primitive_gcd(std::span<const Integer> a, std::span<const Integer> b) {
    const IntegerPolynomial first = primitive_part({a.begin(), a.end()});
    const IntegerPolynomial second = primitive_part({b.begin(), b.end()});
    // Each monic image is multiplied by `leading`, so that all of them are images of the same multiple of the
    // gcd.
    const Integer leading = gcd(first.back(), second.back());
    std::size_t least_size = std::min(first.size(), second.size()) + 1;
    Combination combination;
    std::size_t primes = 0;
    for (std::uint64_t prime = prime_below(primes_end);; prime = prime_below(prime)) {
        const PrimeField field(prime);
        const std::uint64_t scale = field.of(leading);
        if (scale == 0) continue;
        WordList image = gcd_in(field, words_of(first, field), words_of(second, field));
        if (image.size() == 1) return {1};
        if (image.size() > least_size) continue;  // an unlucky prime
        if (image.size() < least_size) {          // all primes so far were unlucky
            least_size = image.size();
            combination = {};
            primes = 0;
        }
        for (std::uint64_t& word : image) word = field.product(word, scale);
        combination.add(image, field);
        ++primes;
        if ((primes & (primes - 1)) != 0) continue;
        IntegerPolynomial candidate = primitive_part(combination.values());
        if (candidate.size() == least_size && exact_quotient(first, candidate) &&
            exact_quotient(second, candidate)) {
            return candidate;
        }
    }
}

}  // namespace blossom
