// Sums in words, in 128 bits and in rows of limbs, at the limit of each and one bit beyond.

#include "sum_cases.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// A case whose sums are near 2^limit, or some bits below it for bounds that are not close; the numbers have
/// some of the bits, the factors the others.
SumCase case_near(Random& random, std::size_t limit, std::size_t most_factors) {
    const std::size_t n = random.below(most_factors + 1);
    const std::size_t number_bits = 1 + random.below(62);
    const Signs signs = any_signs(random);
    // In about half of the cases, the product of the denominators is near a word.
    const std::size_t denominator_bits = n == 0 ? 1 : std::min<std::size_t>(62, 63 / n + random.below(3));
    const std::size_t bits = limit + 1 - random.below(random.one_in(2) ? 3 : 16);
    return case_at_limit(
        random, factors_filling(random, n, bits - std::min(bits, number_bits), denominator_bits, signs), bits,
        signs);
}

void check_near(std::string_view path, std::size_t limit, std::size_t most_factors, SumKernel kernel) {
    Met met;
    each_case(path, [&](Random& random) {
        const SumCase given = case_near(random, limit, most_factors);
        const std::vector<Rational> expected = evident_values(given);
        check_sums(given, expected, met);
        check_unprepared(std::span(given.numerators).first(given.factors.size() + 1), given.denominator,
                         given.factors, expected[0]);
    });
    require_met(met, kernel);
}

}  // namespace

TEST_CASE("words: sums that end at 63 bits", "[differential]") {
    check_near("words", 63, 22, SumKernel::word);
}

TEST_CASE("wide: sums that end at 127 bits", "[differential]") {
    check_near("wide", 127, 40, SumKernel::wide);
}

TEST_CASE("limbs: sums that end at 511 bits", "[differential]") {
    check_near("limbs", 511, 66, SumKernel::limbs);
}

TEST_CASE("limbs: sums of each number of limbs", "[differential]") {
    Met met;
    each_case("limbs of each number",
              [&](Random& random) { check_sums(case_near(random, 63 + 64 * random.below(9), 45), met); });
    require_met(met, SumKernel::limbs);
}

// Vector lanes hold 52 bits of a number, and coefficients below 2^51.
TEST_CASE("limbs: sums that end at a multiple of 52 bits", "[differential]") {
    each_case("limbs in digits", [](Random& random) {
        const std::size_t n = random.one_in(4) ? 60 + random.below(72) : 7 + random.below(40);
        const std::size_t bits = 52 * (1 + random.below(17)) + 2 - random.below(random.one_in(2) ? 4 : 16);
        const std::size_t number_bits = 1 + random.below(bits);
        const Signs signs = any_signs(random);
        const std::size_t denominator_bits = random.one_in(2) ? 1 + random.below(62) : 30;
        std::vector<WordFactor> factors =
            factors_filling(random, n, bits - number_bits, denominator_bits, signs);
        if (random.one_in(4)) {
            const std::int64_t half = std::int64_t{1} << 50;
            WordFactor& factor = factors[random.below(n)];
            factor = {half, random.one_in(2) ? half : half - 1, 3};
            if (signs == Signs::alternate) factor.slope = -factor.slope;
        }
        // More words of denominators than there is room for without allocation.
        if (random.one_in(16))
            for (WordFactor& factor : factors) factor.denominator = INT64_MAX - random.between(0, 9);
        Met met;
        check_sums(case_at_limit(random, std::move(factors), bits, signs), met);
    });
}
