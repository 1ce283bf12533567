// Eight tuples of factors side by side, at the limits of what lanes hold.

#include "differential/sum_cases.hpp"

using namespace blossom;
using namespace blossom::testing;

TEST_CASE("lanes of eight: sums and denominators that end at 51, 52 and 63 bits", "[differential]") {
    std::size_t computed = 0;
    each_case("lanes of eight", [&](Random& random) {
        const std::size_t limits[] = {51, 52, 63};
        const std::size_t limit = limits[random.below(3)] + 1 - random.below(random.one_in(3) ? 3 : 16);
        const std::size_t n = random.below(10);
        const std::size_t bits =
            n == 0 ? 1 : std::clamp<std::size_t>(limit / (n + random.below(3)), 2, 62) - 1;
        // Such that all denominators together end near the limit, or far below.
        const std::size_t share = n == 0 ? 1 : limit / n;
        const std::size_t denominator_bits =
            n == 0             ? 1
            : random.one_in(2) ? std::min<std::size_t>(62, share + 1 - std::min(share, random.below(5)))
                               : std::max<std::size_t>(1, share / 2);
        const Signs signs = any_signs(random);
        std::vector<std::vector<WordFactor>> tuples;
        for (int l = 0; l < 8; ++l) tuples.push_back(factors_near(random, n, bits, denominator_bits, signs));
        // The widest decides on the numbers.
        const SumCase widest = case_at_limit(
            random,
            *std::ranges::max_element(
                tuples, [](const auto& a, const auto& b) { return size_of_product(a) < size_of_product(b); }),
            limit, signs);
        std::vector<WordFactorOctet> octets(n);
        for (std::size_t l = 0; l < 8; ++l) {
            for (std::size_t i = 0; i < n; ++i) {
                octets[i].constants[l] = tuples[l][i].constant;
                octets[i].slopes[l] = tuples[l][i].slope;
                octets[i].denominators[l] = tuples[l][i].denominator;
            }
        }
        const std::size_t rows = widest.rows();
        std::vector<Rational> values(8 * rows);
        const bool fits = widest.sums().evaluate_eight(octets, values);
        count_as(fits ? "computed" : "refused");
        if (!fits) return;
        ++computed;
        for (std::size_t l = 0; l < 8; ++l) {
            const std::vector<Rational> expected =
                evident_values(widest.numerators, widest.denominator, beyond_words(tuples[l]));
            CHECK(std::equal(expected.begin(), expected.end(),
                             values.begin() + static_cast<std::ptrdiff_t>(l * rows)));
        }
    });
    // Where the processor has no lanes nothing is computed.
    CHECK((computed == 0 || 8 * computed + 20 > differential_cases()));
}
