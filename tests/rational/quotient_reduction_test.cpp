#include "blossom_sums_cases.hpp"
#include "rational_test.hpp"
#include "support/smooth_numbers.hpp"

// Sums whose numerators share long and short factors with denominators of many words, compared with the
// evident formula.

TEST_CASE("a numerator that the whole denominator divides", "[quotient_reduction]") {
    for (const std::size_t n : {1U, 2U, 5U, 20U, 40U}) {
        const std::int64_t word = (std::int64_t{1} << 61) - 1;
        const std::vector<IntegerFactor> factors(n, IntegerFactor{word, 0, word});
        std::vector<Rational> numbers(n + 1);
        numbers[0] = Rational(7, 5);
        check_quotient(numbers, factors);
        const Integer longer = pow(Integer(word), 5);
        check_quotient(numbers, std::vector<IntegerFactor>(n, IntegerFactor{longer, 0, longer}));
    }
}

TEST_CASE("factors of as many limbs as are taken together, and one more", "[quotient_reduction]") {
    Random random(33);
    for (const std::size_t bits : {52U, 53U, 104U, 105U, 255U, 256U, 257U, 319U, 320U, 321U, 384U}) {
        for (int i = 0; i < 20; ++i) {
            std::vector<IntegerFactor> factors;
            for (std::size_t k = random.below(20); k > 0; --k) {
                const Integer full = (Integer(1) << bits) - 1;
                const Integer shared = smooth(random, bits / 100);
                const Integer denominator = random.one_in(2) ? full : shared << random.below(bits / 4);
                factors.push_back({random.one_in(2) ? full * shared : shared, shared, denominator});
            }
            check_quotient(smooth_numbers(random, factors.size() + 1, 2), factors);
        }
    }
}
