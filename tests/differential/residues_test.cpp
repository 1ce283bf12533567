// Sums by residues, at the sizes where one more group of primes is needed, by product trees and by
// transforms.

#include "sum_cases.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// A number of bits near that of some groups of eight primes below 2^50 or 2^28, whichever are in use: their
/// product is a few bits shorter, and one bit per group is not used.
std::size_t bits_near_groups(Random& random, std::size_t least) {
    const std::size_t of_group = random.one_in(2) ? 400 : 224;
    const std::size_t groups = least / of_group + 1 + random.below(2);
    return of_group * groups - random.below(groups + 5);
}

SumCase case_near_groups(Random& random, std::vector<WordFactor> factors, Signs signs) {
    const std::size_t least = size_of_product(factors).bit_length() + 1;
    return case_at_limit(random, std::move(factors), bits_near_groups(random, least), signs);
}

/// Factors and numbers whose bits are all ones. They come closer to their bound than the primes to powers of
/// 2.
SumCase case_of_ones(Random& random, std::size_t n, Signs signs) {
    SumCase result;
    const std::int64_t ones = (std::int64_t{1} << (40 + random.below(22))) - 1;
    result.factors.assign(n, {ones, signs == Signs::alternate ? -ones : ones, 1});
    const std::size_t size_bits = size_of_product(result.factors).bit_length();
    const std::size_t bits = bits_near_groups(random, size_bits + 40);
    Integer number = (Integer(1) << (bits - size_bits)) - 1;
    if (random.one_in(2)) number = -number;
    for (std::size_t k = 0; k <= n; ++k)
        result.numerators.push_back(signs == Signs::alternate && k % 2 == 1 ? -number : number);
    return result;
}

/// Numbers near 4096 digits of 50 or 28 bits, where digits are no longer summed at once; sometimes sums of
/// 2'000'000 bits, the longest in residues.
SumCase case_of_long_numbers(Random& random, Signs signs) {
    std::vector<WordFactor> factors = factors_near(random, 16, 1 + random.below(62), 62, signs);
    const bool longest = random.one_in(20);
    count_as(longest ? "of 2'000'000 bits" : "of 4096 digits");
    const std::size_t bits = longest ? 2'000'001
                                     : std::size_t{4096} * (random.one_in(2) ? 50 : 28) +
                                           size_of_product(factors).bit_length() + 2;
    return case_at_limit(random, std::move(factors), bits - random.below(4), signs);
}

/// n factors, all but a few with one term only, so that the evident formula is fast.
std::vector<WordFactor> mostly_monomials(Random& random, std::size_t n, std::size_t bits, Signs signs) {
    std::vector<WordFactor> factors = factors_near(random, n, bits, bits, signs);
    const std::size_t full = random.below(12);
    for (std::size_t left = n; left > 0; --left) {
        if (random.below(left) < full) continue;
        WordFactor& factor = factors[left - 1];
        (random.one_in(2) ? factor.constant : factor.slope) = 0;
        if (factor.constant == 0 && factor.slope == 0) factor.slope = 1;
    }
    return factors;
}

/// If all numbers are equal, the sum is one of them times the value of the product at 1; if their signs
/// alternate, at -1.
std::vector<Rational> values_at_one(const SumCase& given, Signs signs) {
    Integer top = 1;
    Integer bottom = given.denominator;
    for (const auto& [constant, slope, denominator] : given.factors) {
        top *= signs == Signs::alternate ? Integer(constant) - slope : Integer(constant) + slope;
        bottom *= denominator;
    }
    std::vector<Rational> values;
    for (std::size_t row = 0; row < given.numerators.size(); row += given.factors.size() + 1)
        values.emplace_back(given.numerators[row] * top, bottom);
    return values;
}

/// A range of numbers of factors, and the share of the cases, in 64ths, that uses it.
struct Degrees {
    const char* kind;
    std::size_t share;
    std::vector<std::size_t> degrees;
};

/// Transforms of 512 values take 500 to 504 factors, of which the last fill the leaves. With leaves of 32 and
/// 64 coefficients, transforms of 1024 values end at 992 and 1008 factors, those of 2048, the longest for
/// short primes, at 1984 and 2016, and those of 4096 at 3968 and 4032. They begin at 5/8 of a length, and
/// product trees continue to 4095.
const Degrees degrees_of_transforms[] = {
    {"of 500 to 504 factors", 44, {500, 501, 502, 503, 504}},
    {"by transforms of 1024", 8, {640, 641, 700, 991, 992, 993, 1007, 1008}},
    {"of degrees just beyond", 10, {498, 499, 505, 506, 511, 512, 638, 639, 1009}},
    {"by transforms of 2048", 1, {1280, 1281, 1984, 1985, 2016}},
};
const Degrees highest_degrees = {
    "of degrees to 4096",
    1,
    {1023, 1024, 1279, 2017, 2047, 2048, 2559, 2560, 3968, 3969, 4032, 4033, 4095, 4096}};

const Degrees& any_degrees(Random& random) {
    std::size_t place = random.below(64);
    for (const Degrees& degrees : degrees_of_transforms) {
        if (place < degrees.share) return degrees;
        place -= degrees.share;
    }
    return highest_degrees;
}

}  // namespace

TEST_CASE("residues: sums near the limits of groups of primes", "[differential]") {
    Met met;
    each_case("residues", [&](Random& random) {
        const Signs signs = any_signs(random);
        if (random.one_in(200)) return check_sums(case_of_long_numbers(random, signs), met);
        const std::size_t n = 14 + random.below(random.one_in(8) ? 70 : 20);
        if (random.one_in(4)) return check_sums(case_of_ones(random, n, signs), met);
        const std::size_t bits = random.one_in(2) ? 62 : 30 + random.below(33);
        check_sums(
            case_near_groups(random, factors_near(random, n, bits, random.below(62) + 1, signs), signs), met);
    });
    require_met(met, SumKernel::residues);
}

TEST_CASE("residues: small factors of middle degree", "[differential]") {
    Met met;
    each_case("residues of middle degree", [&](Random& random) {
        const Signs signs = any_signs(random);
        const std::size_t n = 60 + random.below(140);
        const std::size_t bits = 1 + random.below(10);
        if (signs == Signs::any) {
            check_sums(case_near_groups(random, mostly_monomials(random, n, bits, signs), signs), met);
        } else {
            const SumCase given = case_near_groups(random, factors_near(random, n, bits, bits, signs), signs);
            check_sums(given, values_at_one(given, signs), met);
        }
    });
    require_met(met, SumKernel::residues);
}

TEST_CASE("residues: factors beyond words and negative denominators", "[differential]") {
    each_case("residues beyond words", [&](Random& random) {
        const std::size_t n = 14 + random.below(12);
        std::vector<IntegerFactor> factors;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t bits = 40 + random.below(random.one_in(4) ? 400 : 90);
            Integer denominator = number_near(random, 1 + random.below(bits));
            if (denominator.is_zero()) denominator = -7;
            factors.push_back({number_near(random, bits), number_near(random, bits), denominator});
        }
        std::vector<Integer> numerators;
        const std::size_t bits = 1 + random.below(600);
        for (std::size_t k = 0; k <= n; ++k) numerators.push_back(number_near(random, bits));
        const Integer denominator = abs(number_near(random, 1 + random.below(200))) + 1;
        Rational value;
        BlossomSums(RationalVector(numerators, denominator), 1).evaluate(factors, 0, {&value, 1});
        CHECK(value == evident_values(numerators, denominator, factors)[0]);
    });
}

TEST_CASE("residues: small fractions over one large denominator", "[differential]") {
    each_case("residues of small fractions", [&](Random& random) {
        // The most bits of fractions for which it is faster to use them than the numerators.
        const std::size_t n = 16 + random.below(30);
        const std::size_t denominator_bits = 1 + random.below(random.one_in(2) ? 300 : 64);
        const std::size_t bits =
            random.one_in(4) ? 1 + random.below(600) : 1 + random.below(denominator_bits);
        std::vector<Integer> bottoms;
        Integer denominator = abs(number_near(random, random.below(3000))) + 1;
        for (std::size_t k = 0; k <= n; ++k) {
            Integer& bottom = bottoms.emplace_back(abs(number_near(random, denominator_bits)) + 1);
            // A prime of the residues on some level.
            if (random.one_in(200))
                bottom *=
                    random.one_in(2) ? (std::int64_t{1} << 50) - 16383 : (std::int64_t{1} << 28) - 65535;
            denominator *= random.one_in(20) ? Integer(1) : bottom;
        }
        std::vector<Integer> numerators;
        for (const Integer& bottom : bottoms) {
            Integer top = number_near(random, random.one_in(30) ? 2000 : bits);
            numerators.push_back((denominator % bottom).is_zero() ? top * divide_exactly(denominator, bottom)
                                                                  : std::move(top));
        }
        const std::vector<WordFactor> factors =
            factors_near(random, n, 1 + random.below(62), 1 + random.below(62), Signs::any);
        const std::vector<IntegerFactor> integers = beyond_words(factors);
        Rational value;
        const auto use = random.one_in(2) ? BlossomSums::Use::many : BlossomSums::Use::once;
        BlossomSums(RationalVector(numerators, denominator), 1, use).evaluate(integers, 0, {&value, 1});
        CHECK(value == evident_values(numerators, denominator, integers)[0]);
    });
}

TEST_CASE("transforms: sums of high degree", "[differential]") {
    Met met;
    std::size_t beyond = 0;
    const auto check = [&](Random& random) {
        const Signs signs = any_signs(random);
        const Degrees& degrees = any_degrees(random);
        count_as(degrees.kind);
        const std::size_t n = degrees.degrees[random.below(degrees.degrees.size())];
        beyond += n == 4096 ? 1 : 0;
        // Short primes with transforms end at sums of about 5900 bits.
        std::size_t bits = 1 + random.below(n < 1280 ? 5 : 2);
        if (n <= 512 && random.one_in(8))
            bits = random.one_in(4) ? 1 + random.below(60) : 9 + random.below(4);
        const bool full = n <= 504 && bits <= 5 && random.one_in(4);
        if (full) count_as("multiplied out");
        if (full || signs == Signs::any) {
            std::vector<WordFactor> factors =
                full ? factors_near(random, n, bits, bits, signs) : mostly_monomials(random, n, bits, signs);
            check_sums(case_near_groups(random, std::move(factors), signs), met);
        } else {
            const SumCase given = case_near_groups(random, factors_near(random, n, bits, bits, signs), signs);
            check_sums(given, values_at_one(given, signs), met);
        }
    };
    each_case("transforms", check, 40);
    CHECK(met[SumKernel::residues] + beyond == differential_cases(40));
}
