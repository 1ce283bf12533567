// Quotients whose numerators share primes with denominators of many words, and quotients of numbers of a few
// limbs.

#include "each_case.hpp"
#include "rational/blossom_sums_cases.hpp"
#include "support/smooth_numbers.hpp"

using namespace blossom;
using namespace blossom::testing;

TEST_CASE("word gcds: denominators of up to fifty words", "[differential]") {
    each_case("word gcds", [](Random& random) {
        const std::size_t n = random.below(random.one_in(8) ? 26 : 6);
        std::vector<WordFactor> factors;
        for (std::size_t k = 0; k < n; ++k)
            factors.push_back({smooth_word(random), -smooth_word(random), smooth_word(random)});
        check_quotient(smooth_numbers(random, n + 1, 1), factors);
    });
}

TEST_CASE("long gcds: denominators of numbers around the most limbs taken together", "[differential]") {
    each_case("long gcds", [](Random& random) {
        const std::size_t n = random.below(random.one_in(8) ? 20 : 6);
        const std::size_t bits = 64 * (1 + random.below(6)) - 1 + random.below(3);
        std::vector<IntegerFactor> factors;
        for (std::size_t k = 0; k < n; ++k) {
            const Integer shared = smooth(random, bits / 64);
            const Integer whole = abs(number_near(random, bits)) + 1;
            factors.push_back({random.one_in(2) ? whole : shared, smooth(random, random.below(6)),
                               random.one_in(2) ? whole : shared << random.below(70)});
        }
        check_quotient(smooth_numbers(random, n + 1, 1 + random.below(6)), factors);
    });
}
