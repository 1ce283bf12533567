#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <cstdint>

#include "prime_field.hpp"

namespace blossom {

namespace {

/// The non-negative residue of a value modulo a positive number.
Integer modulo(Integer value, const Integer& modulus) {
    value %= modulus;
    if (value.sign() < 0) value += modulus;
    return value;
}

/// The values of a polynomial and of its derivative at t, modulo a positive number.
std::pair<Integer, Integer> value_and_slope(std::span<const Integer> polynomial, const Integer& t,
                                            const Integer& modulus) {
    Integer value;
    Integer slope;
    for (std::size_t k = polynomial.size(); k-- > 0;) {
        slope = modulo(slope * t + value, modulus);
        value = modulo(value * t + polynomial[k], modulus);
    }
    return {std::move(value), std::move(slope)};
}

/// A fraction with this residue whose numerator is at most `most`; it is unique if twice `most` times the
/// denominator is below the modulus.
Rational fraction_with(const Integer& residue, const Integer& modulus, const Integer& most) {
    Integer before = modulus;
    Integer now = residue;
    Integer cofactor_before = 0;
    Integer cofactor = 1;
    while (now > most) {
        const Integer quotient = before / now;
        before -= quotient * now;
        std::swap(before, now);
        cofactor_before -= quotient * cofactor;
        std::swap(cofactor_before, cofactor);
    }
    return {now, cofactor};
}

class Search {
public:
    explicit Search(std::span<const Integer> polynomial) : rest_(polynomial.begin(), polynomial.end()) {
        if (rest_.front().is_zero()) {
            found_.emplace_back(0);
            rest_.erase(rest_.begin());
        }
    }

    std::vector<Rational> run() {
        // The loop ends: if a root were simple modulo no prime, every prime would divide the discriminant.
        for (std::uint64_t prime = 4001; !is_complete_; prime = next_prime(prime)) {
            if (rest_.size() < 2) break;
            const PrimeField field(prime);
            if (field.of(rest_.back()) != 0) search(field);
        }
        return std::move(found_);
    }

private:
    static std::uint64_t next_prime(std::uint64_t number) {
        const auto is_prime = [](std::uint64_t candidate) {
            for (std::uint64_t divisor = 3; divisor * divisor <= candidate; divisor += 2)
                if (candidate % divisor == 0) return false;
            return true;
        };
        do number += 2;
        while (!is_prime(number));
        return number;
    }

    void search(const PrimeField& field) {
        const IntegerPolynomial polynomial = rest_;
        std::vector<std::uint64_t> coefficients;
        for (const Integer& coefficient : polynomial) coefficients.push_back(field.of(coefficient));
        spend_work(8 * field.prime() * coefficients.size());
        is_complete_ = true;
        for (std::uint64_t t = 0; t < field.prime(); ++t) {
            std::uint64_t value = 0;
            for (std::size_t k = coefficients.size(); k-- > 0;)
                value = (value * t + coefficients[k]) % field.prime();
            if (value != 0) continue;
            const auto slope = value_and_slope(polynomial, Integer(t), Integer(field.prime())).second;
            if (slope.is_zero()) {
                is_complete_ = false;
            } else {
                lift(polynomial, Integer(t), slope, field);
            }
        }
    }

    /// Searches for the rational root with the residue `root`, a simple root modulo the prime.
    void lift(std::span<const Integer> polynomial, Integer root, const Integer& slope,
              const PrimeField& field) {
        const Integer numerator_bound = abs(polynomial.front());
        const Integer enough = (numerator_bound * abs(polynomial.back())) << 1;
        Integer modulus = field.prime();
        Integer inverse = field.inverse(field.of(slope));
        while (true) {
            const bool is_enough = modulus > enough;
            const std::size_t half = modulus.bit_length() / 2;
            const Integer most = is_enough ? numerator_bound : Integer(1) << half;
            const Rational candidate = fraction_with(root, modulus, most);
            // A fraction shorter by so many bits than one with a random residue is most likely the root.
            constexpr std::size_t spare_bits = 8;
            const std::size_t bits =
                candidate.numerator().bit_length() + candidate.denominator().bit_length();
            if ((is_enough || bits + spare_bits < modulus.bit_length()) && test(candidate)) return;
            if (is_enough) return;
            modulus *= modulus;
            const auto [value, derivative] = value_and_slope(polynomial, root, modulus);
            inverse = modulo(inverse * (Integer(2) - derivative * inverse), modulus);
            root = modulo(root - value * inverse, modulus);
        }
    }

    /// Whether the number is a root; if so, the polynomial is divided by its linear factor.
    bool test(const Rational& candidate) {
        const Integer factor[] = {-candidate.numerator(), candidate.denominator()};
        auto quotient = exact_quotient(rest_, factor);
        if (!quotient) return false;
        rest_ = *std::move(quotient);
        found_.push_back(candidate);
        return true;
    }

    IntegerPolynomial rest_;  ///< the polynomial without the roots found so far
    std::vector<Rational> found_;
    bool is_complete_ = false;
};

}  // namespace

std::vector<Rational> rational_roots(std::span<const Integer> polynomial) { return Search(polynomial).run(); }

}  // namespace blossom
