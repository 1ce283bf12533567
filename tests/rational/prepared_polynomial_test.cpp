#include <blossom/rational/prepared_polynomial.hpp>
#include "rational_test.hpp"

#include "support/horner.hpp"

// Values of prepared polynomials, compared with Horner's rule on rational numbers: at the limits of words and
// of rows of words, and beyond.

namespace {

/// A random number; sometimes zero, or with factors that cancel.
Rational number(Random& random, std::size_t bits) {
    if (random.one_in(8)) return 0;
    const Integer numerator = integer_of_bits(random, random.below(bits + 1));
    if (random.one_in(4)) return {numerator, Integer(1 + random.below(12))};
    if (random.one_in(4)) return {numerator, pow(Integer(2 + random.below(6)), random.below(bits / 3 + 2))};
    return {numerator, abs(integer_of_bits(random, random.below(bits + 1))) + 1};
}

void check_values(const std::vector<Rational>& coefficients, const std::vector<Rational>& parameters,
                  std::size_t rows = 1) {
    const std::size_t size = coefficients.size() / rows;
    const PreparedPolynomial forms(RationalVector(coefficients), rows);
    // More evaluations than there are coefficients, so that the prepared form is used too.
    for (std::size_t round = 0; round * parameters.size() < 2 * size; ++round) {
        for (const Rational& t : parameters) {
            std::vector<Rational> values(rows);
            forms.evaluate(t, values);
            const std::size_t bits = std::max(t.numerator().bit_length(), t.denominator().bit_length());
            for (std::size_t j = 0; j < rows; ++j) {
                CHECK(values[j] == horner_value(std::span(coefficients).subspan(j * size, size), t));
                CHECK(std::max(values[j].numerator().bit_length(), values[j].denominator().bit_length()) <=
                      forms.value_bits(bits));
            }
        }
    }
}

void check_random(Random& random, std::size_t size, std::size_t bits, std::size_t parameter_bits) {
    const std::size_t rows = 1 + random.below(2);
    std::vector<Rational> coefficients;
    for (std::size_t k = 0; k < rows * size; ++k) coefficients.push_back(number(random, bits));
    std::vector<Rational> parameters;
    for (int i = 0; i < 6; ++i) parameters.push_back(number(random, parameter_bits));
    check_values(coefficients, parameters, rows);
}

}  // namespace

TEST_CASE("values of prepared polynomials of low degree", "[prepared_polynomial]") {
    Random random(1);
    for (int i = 0; i < 1200; ++i) check_random(random, 1 + random.below(5), 1 + random.below(20), 18);
    for (int i = 0; i < 400; ++i) check_random(random, 1 + random.below(8), 70, 70);
}

TEST_CASE("values of prepared polynomials on rows of words", "[prepared_polynomial]") {
    Random random(2);
    for (int i = 0; i < 200; ++i)
        check_random(random, 1 + random.below(40), 1 + random.below(12), 1 + random.below(64));
    for (int i = 0; i < 60; ++i) check_random(random, 1 + random.below(20), 60, 60);
}

TEST_CASE("values of prepared polynomials by halves", "[prepared_polynomial]") {
    Random random(3);
    for (int i = 0; i < 60; ++i) check_random(random, 1 + random.below(40), 100, 1 + random.below(200));
}

TEST_CASE("values whose numerator and denominator share primes with the coefficients",
          "[prepared_polynomial]") {
    Random random(4);
    const Integer primes[] = {2, 3, 5, 137, 139, 10007, (Integer(1) << 61) - 1};
    const auto smooth = [&](std::size_t factors) {
        Integer product = 1;
        for (std::size_t i = 0; i < factors; ++i) product *= primes[random.below(std::size(primes))];
        return product;
    };
    for (int i = 0; i < 600; ++i) {
        std::vector<Rational> coefficients;
        for (std::size_t k = random.below(i % 4 == 0 ? 30 : 5) + 1; k > 0; --k)
            coefficients.emplace_back(smooth(random.below(3)), smooth(random.below(4)));
        std::vector<Rational> parameters{0, 1};
        for (int j = 0; j < 6; ++j)
            parameters.emplace_back(smooth(random.below(4)), -smooth(random.below(4)));
        check_values(coefficients, parameters);
    }
}
