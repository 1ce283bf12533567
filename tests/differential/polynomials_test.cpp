// The Taylor shift on vectors of digits and in residues, forms on lines, and values of polynomials prepared
// as forms.

#include <blossom/rational/bernstein_kernel.hpp>
#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/prepared_polynomial.hpp>
#include <blossom/rational/taylor_shift.hpp>

#include <vector>

#include "each_case.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// sum_k c_k u^k v^(n-k) / (D v^n)
Rational horner_form(std::span<const Integer> numerators, const Integer& denominator, const Rational& t) {
    Integer sum;
    Integer power = 1;
    for (std::size_t k = numerators.size(); k-- > 0;) {
        sum = sum * t.numerator() + numerators[k] * power;
        if (k > 0) power *= t.denominator();
    }
    return {sum, denominator * power};
}

/// The product polynomial * (constant + slope X).
std::vector<Integer> times(const std::vector<Integer>& polynomial, std::int64_t constant,
                           std::int64_t slope) {
    std::vector<Integer> product(polynomial.size() + 1);
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
        product[k] += polynomial[k] * constant;
        product[k + 1] += polynomial[k] * slope;
    }
    return product;
}

/// Horner's rule in u, times powers of v.
std::vector<Integer> substituted(std::span<const Integer> coefficients, const WordQuotient& a,
                                 const WordQuotient& b) {
    std::vector<Integer> sum{coefficients.back()};
    std::vector<Integer> power{1};
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        sum = times(sum, a.numerator, b.numerator);
        power = times(power, a.denominator, b.denominator);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += coefficients[k] * power[i];
    }
    return sum;
}

/// The bits that the bound on results of `form_on_line` adds to those of the coefficients.
std::size_t bits_of_growth(std::size_t count, const WordQuotient& a, const WordQuotient& b) {
    const auto sum = [](std::int64_t x, std::int64_t y) { return abs(Integer(x)) + abs(Integer(y)); };
    const Integer growth = std::max(sum(a.numerator, b.numerator), sum(a.denominator, b.denominator));
    return (Integer(count) * pow(growth, count - 1)).bit_length();
}

/// A quotient usually of exactly `bits` bits, sometimes 0.
WordQuotient word_quotient(Random& random, std::size_t bits) {
    const Integer denominator = abs(number_near(random, bits));
    return {*number_near(random, bits).to_int64(), denominator.is_zero() ? 1 : *denominator.to_int64()};
}

}  // namespace

TEST_CASE("products of polynomials: coefficients up to the bits that the substitution leaves room for",
          "[differential]") {
    each_case("products of polynomials", [&](Random& random) {
        const auto polynomial = [&](std::size_t size, std::size_t bits) {
            const int sign = static_cast<int>(random.below(3)) - 1;
            std::vector<Integer> coefficients;
            for (std::size_t k = 0; k < size; ++k) coefficients.push_back(number_near(random, bits, sign));
            return coefficients;
        };
        const std::size_t bits = 1 + random.below(random.one_in(4) ? 300 : 40);
        const auto a = polynomial(60 + random.below(10), bits);
        const auto b = polynomial(60 + random.below(random.one_in(8) ? 70 : 10), 1 + random.below(bits));
        std::vector<Integer> expected(a.size() + b.size() - 1);
        for (std::size_t i = 0; i < a.size(); ++i) {
            for (std::size_t j = 0; j < b.size(); ++j) expected[i + j] += a[i] * b[j];
        }
        check_same(product(a, b), expected);
    });
}

TEST_CASE("Taylor shift: coefficients near the limits of digits", "[differential]") {
    each_case("Taylor shift", [&](Random& random) {
        const std::size_t size = 1 + random.below(random.one_in(40) ? 300 : random.one_in(4) ? 80 : 20);
        // A digit has 48 bits and a plane of eight digits 384; a shift adds about as many bits as there are
        // coefficients.
        const std::size_t limit =
            (random.one_in(2) ? 48 : 384) * (1 + random.below(random.one_in(8) ? 20 : 4));
        const std::size_t growth = random.one_in(2) ? size - 1 : 0;
        const std::size_t bits = limit + 3 - std::min(limit + 3, growth + random.below(6));
        const int sign = static_cast<int>(random.below(3)) - 1;
        std::vector<Integer> coefficients;
        for (std::size_t k = 0; k < size; ++k) coefficients.push_back(number_near(random, bits, sign));
        check_same(shifted_by_one(coefficients), row_recurrences::shifted_by_one<Integer>(coefficients));
    });
}

TEST_CASE("Taylor shift: numbers of coefficients that use transforms", "[differential]") {
    each_case(
        "Taylor shift in residues",
        [&](Random& random) {
            // The length of transforms doubles when twice the number of coefficients is a power of 2, and the
            // longest has 4096.
            const bool longest = random.one_in(500);
            const bool longer = random.one_in(50);
            const std::size_t size = longest  ? (random.one_in(4) ? 4095 : 2047) + random.below(3)
                                     : longer ? 1023 + random.below(3)
                                              : 512 + random.below(random.one_in(2) ? 3 : 40);
            count_as(longest ? "of 2047 to 4097 coefficients" : longer ? "of 1023 to 1025" : "of 512 to 551");
            const int sign = static_cast<int>(random.below(3)) - 1;
            // Results in residues have at most four bits per coefficient.
            const std::size_t bits = !longest && random.one_in(3) ? 3 * size + 3 - random.below(6)
                                                                  : random.below(longest ? 60 : 400);
            std::vector<Integer> coefficients;
            for (std::size_t k = 0; k < size; ++k) coefficients.push_back(number_near(random, bits, sign));
            check_same(shifted_by_one(coefficients), row_recurrences::shifted_by_one<Integer>(coefficients));
        },
        20);
}

TEST_CASE("forms on lines: numbers that end where groups of primes do", "[differential]") {
    each_case("forms on lines", [&](Random& random) {
        const bool most = random.one_in(100);
        const std::size_t size = most                ? 40 + random.below(90)
                                 : random.one_in(20) ? 2 + random.below(130)
                                 : random.one_in(4)  ? 2 + random.below(33)
                                                     : 2 + random.below(6);
        const std::size_t bits_of_ends = 1 + random.below(random.one_in(3) ? 48 : 6);
        const WordQuotient a = word_quotient(random, bits_of_ends);
        const WordQuotient b = word_quotient(random, bits_of_ends);
        // A group of eight primes below 2^50 has a product of 400 bits, of which one bit is not used; at most
        // 64 groups are combined.
        const std::size_t groups = most ? 64 : 1 + random.below(random.one_in(8) ? 20 : 4);
        const std::size_t limit = (random.one_in(2) ? 399 : 400) * groups + 3;
        const std::size_t growth = most || random.one_in(2) ? bits_of_growth(size, a, b) : 0;
        const std::size_t bits = limit - std::min(limit, growth + random.below(12));
        const int sign = static_cast<int>(random.below(3)) - 1;
        std::vector<Integer> coefficients;
        for (std::size_t k = 0; k < size; ++k) coefficients.push_back(number_near(random, bits, sign));
        const auto result = form_on_line(coefficients, a, b);
        count_as(std::string(result ? "computed" : "refused") + (most ? " near 64 groups" : ""));
        if (result) check_same(*result, substituted(coefficients, a, b));
    });
}

TEST_CASE("Bernstein coefficients: rows near the limits of words", "[differential]") {
    each_case("Bernstein coefficients in words", [&](Random& random) {
        const std::size_t size = 1 + random.below(random.one_in(4) ? 33 : 8);
        const std::size_t bits_of_ends = 1 + random.below(random.one_in(4) ? 48 : 8);
        const WordQuotient a = word_quotient(random, bits_of_ends);
        const WordQuotient b = word_quotient(random, bits_of_ends);
        const std::size_t limit = 64 * (1 + random.below(random.one_in(2) ? 10 : 3));
        const std::size_t growth = (size - 1) * (2 * bits_of_ends + 1);
        const std::size_t bits = std::max<std::size_t>(limit + 3, growth + random.below(12)) - growth;
        const int sign = static_cast<int>(random.below(3)) - 1;
        std::vector<Integer> coefficients;
        std::vector<Integer> weights;
        for (std::size_t k = 0; k < size; ++k) {
            coefficients.push_back(number_near(random, std::min(bits, limit), sign));
            weights.emplace_back(1 + random.below(random.one_in(2) ? 1 : 1000));
        }
        const auto result = bernstein_in_words(coefficients, a, b, weights);
        if (!result) return;
        const Integer common = gcd(a.denominator, b.denominator);
        const std::vector<Integer> form = substituted(coefficients, a, b);
        REQUIRE(result->size() == size);
        for (std::size_t k = 0; k < size; ++k) {
            CHECK((*result)[k] == form[k] * weights[k] * pow(a.denominator / common, k) *
                                      pow(b.denominator / common, size - 1 - k));
        }
    });
}

TEST_CASE("prepared polynomials: values that end where words and rows of words do", "[differential]") {
    each_case("prepared polynomials", [&](Random& random) {
        const std::size_t limits[] = {63, 64, 127, 128, 191, 256, 511, 512, 1024, 4096};
        const std::size_t limit = limits[random.below(std::size(limits))];
        const std::size_t n = random.below(limit < 130 ? 12 : 40);
        const std::size_t t_bits = std::min<std::size_t>(1 + random.below(limit / (n + 1) + 1), 70);
        const std::size_t bits = limit + 4 - std::min(limit + 3, n * t_bits + random.below(8));
        const std::size_t rows = random.one_in(4) ? 2 : 1;
        std::vector<Integer> numerators;
        const int sign = static_cast<int>(random.below(3)) - 1;
        for (std::size_t k = 0; k < rows * (n + 1); ++k)
            numerators.push_back(number_near(random, bits, sign));
        Integer denominator = 1;
        if (random.one_in(2)) denominator = abs(number_near(random, random.below(limit))) + 1;
        if (random.one_in(4)) denominator *= pow(Integer(2 + random.below(9)), random.below(20));
        const PreparedPolynomial forms(RationalVector(numerators, denominator), rows);
        // More evaluations than there are coefficients, so that the prepared form is used too.
        for (std::size_t i = 0; i < (random.one_in(4) ? n + 3 : 3); ++i) {
            const Rational t(number_near(random, t_bits), abs(number_near(random, t_bits)) + 1);
            std::vector<Rational> values(rows);
            forms.evaluate(t, values);
            for (std::size_t j = 0; j < rows; ++j) {
                CHECK(values[j] ==
                      horner_form(std::span(numerators).subspan(j * (n + 1), n + 1), denominator, t));
            }
        }
    });
}
