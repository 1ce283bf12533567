// Factors of few bits multiplied in blocks of 51 bits, one block per vector lane; and quotients whose
// denominators have only small primes.

#include "sum_cases.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Blocks with as many factors as fit exactly, or with one more.
struct BlockShape {
    std::size_t factors;
    std::size_t bits;  ///< per factor
};

BlockShape random_shape(Random& random) {
    const std::size_t blocks = std::size_t{2} << random.below(3);
    const std::size_t degree = 2 + random.below(6);
    const std::size_t bits = std::clamp<std::size_t>(51 / degree + 1 - random.below(3), 2, 26);
    return {std::max<std::size_t>(4, blocks * degree + 1 - random.below(blocks + 2)), bits};
}

/// A number near a multiple of the bits of digits or of words, up to the most of both.
std::size_t random_limit(Random& random, std::size_t least) {
    const std::size_t unit = random.one_in(3) ? 64 : 52;
    const std::size_t units = least / unit + 1 + random.below(random.one_in(4) ? 16 : 3);
    return std::max(least + 1, unit * units + 2 - random.below(4));
}

/// |constant| + |slope| is just below 2^bits, or has just this many bits.
WordFactor factor_of_bits(Random& random, std::size_t bits, Signs signs) {
    const std::int64_t size = (std::int64_t{1} << bits) - (random.one_in(8) ? 0 : 1);
    const std::int64_t slope = random.between(0, size);
    const std::int64_t denominator =
        random.one_in(8) ? size
                         : random.between(1, std::min<std::int64_t>(size, random.one_in(4) ? 4100 : 140));
    WordFactor factor{size - slope, slope, denominator};
    if (signs == Signs::alternate || (signs == Signs::any && random.one_in(2))) factor.slope = -factor.slope;
    if (signs == Signs::any && random.one_in(2)) factor.constant = -factor.constant;
    return factor;
}

/// u and m of a factor m + u X whose magnitude is about 2^bits.
struct Pair {
    Rational u;
    Rational m;
};

Pair pair_of_bits(Random& random, std::size_t bits) {
    const std::int64_t size = (std::int64_t{1} << bits) - 1;
    const std::int64_t denominator =
        random.between(1, random.one_in(2) ? size : std::min<std::int64_t>(size, 140));
    const std::int64_t numerator = random.between(0, random.one_in(8) ? size : size - denominator);
    return {Rational(random.one_in(2) ? numerator : -numerator, denominator), random.one_in(6) ? 0 : 1};
}

WordFactor factor_of(const Pair& pair) {
    const std::int64_t denominator = *pair.u.denominator().to_int64();
    return {pair.m.is_zero() ? 0 : denominator, *pair.u.numerator().to_int64(), denominator};
}

/// A product of at most `bits` bits of odd primes up to 137, sometimes also of other primes.
Integer smooth_number(Random& random, std::size_t bits) {
    Integer number = 1;
    for (;;) {
        const Integer larger = number * (random.one_in(40) ? 139 + 2 * random.below(400)
                                                           : 1 + random.below(random.one_in(2) ? 12 : 137));
        if (larger.bit_length() > bits) return number;
        number = larger;
    }
}

}  // namespace

TEST_CASE("factor products: blocks that end at 51 bits, sums at digits and words", "[differential]") {
    each_case("factor products", [](Random& random) {
        const BlockShape shape = random_shape(random);
        const Signs signs = any_signs(random);
        std::vector<WordFactor> factors;
        while (factors.size() < shape.factors) factors.push_back(factor_of_bits(random, shape.bits, signs));
        const std::size_t limit = random_limit(random, shape.factors * shape.bits);
        Met met;
        check_sums(case_at_limit(random, std::move(factors), limit, signs), met);
    });
}

TEST_CASE("pairs of numbers: sums that end at 63 bits", "[differential]") {
    std::size_t computed = 0;
    each_case("pairs of numbers", [&](Random& random) {
        const std::size_t n = 1 + random.below(8);
        const std::size_t bits = std::clamp<std::size_t>(62 / n + 1 - random.below(4), 2, 26);
        std::vector<Pair> pairs;
        std::vector<WordFactor> factors;
        while (pairs.size() < n) {
            pairs.push_back(pair_of_bits(random, random.one_in(2) ? bits : 1 + random.below(bits)));
            factors.push_back(factor_of(pairs.back()));
        }
        const SumCase given =
            case_at_limit(random, std::move(factors), 62 + random.below(4), any_signs(random));
        std::vector<Rational> values(given.rows(), Rational(7, 9));
        const std::vector<Rational> before = values;
        static_assert(sizeof(Pair) == 2 * sizeof(Rational));
        if (given.sums().evaluate_pairs(&pairs.front().u, 0, values)) {
            ++computed;
            CHECK(values == evident_values(given));
        } else {
            CHECK(values == before);
        }
    });
    CHECK(8 * computed > differential_cases());
}

TEST_CASE("quotients by small primes", "[differential]") {
    each_case("small primes", [](Random& random) {
        SumCase given;
        const std::size_t n = 1 + random.below(12);
        for (std::size_t i = 0; i < n; ++i) {
            // The primes of numbers beyond 4095 are not in the table.
            const Integer denominator =
                random.one_in(12) ? 4096 + random.below(4096) : smooth_number(random, 1 + random.below(12));
            given.factors.push_back({1, 0, *denominator.to_int64()});
        }
        given.numerators.assign(n + 1, 0);
        // Numbers of one or two words of ones are the largest multiples of a divisor.
        given.numerators[0] = random.one_in(6)
                                  ? (Integer(1) << (64 * (1 + random.below(4)))) - 1
                                  : smooth_number(random, 1 + random.below(random.one_in(4) ? 500 : 130));
        if (random.one_in(3)) given.numerators[0] *= given.factors[random.below(n)].denominator;
        if (random.one_in(2)) given.numerators[0] *= -1;
        given.denominator = smooth_number(random, 1 + random.below(70));
        Met met;
        check_sums(given, met);
    });
}
