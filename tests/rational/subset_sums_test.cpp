#include "rational_test.hpp"
#include "subset_cases.hpp"

// Sums over subsets by residues, compared with the blossom in elementary symmetric functions.

namespace {

/// The greatest primes below 2^50 that are 1 modulo 2^13, and below 2^28 that are 1 modulo 2^11: the first
/// primes of the residues on some levels.
constexpr std::int64_t first_primes[] = {(std::int64_t{1} << 50) - 16383, (std::int64_t{1} << 28) - 65535};

SubsetCase random_case(Random& random, std::size_t groups, std::size_t bits) {
    SubsetCase result;
    std::size_t n = 0;
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t multiplicity = random.one_in(3) ? 1 + random.below(4) : 1;
        const Integer mass = random.one_in(5) ? Integer(0) : integer_of_bits(random, 1 + random.below(bits));
        result.groups.push_back({integer_of_bits(random, 1 + random.below(bits)), mass, multiplicity});
        if (random.one_in(8)) result.groups.back().u = 0;
        n += multiplicity;
    }
    for (std::size_t row = 0; row < 1 + random.below(3); ++row) {
        auto& coefficients = result.rows.emplace_back();
        for (std::size_t k = 0; k <= n; ++k)
            coefficients.push_back(random.one_in(6) ? Integer(0)
                                                    : integer_of_bits(random, 1 + random.below(bits)));
    }
    return result;
}

void check(const SubsetCase& given) {
    const std::vector<Integer> expected = evident_subset_sums(given);
    CHECK(strict_subset_sums(given.spans(), given.groups) == expected);
    if (const auto regrouped = regrouped_subset_sums(given.spans(), given.groups))
        CHECK(*regrouped == expected);
}

}  // namespace

TEST_CASE("sums over subsets of few arguments", "[subset_sums]") {
    Random random(71);
    for (int i = 0; i < 6'000; ++i) check(random_case(random, random.below(6), 1 + random.below(40)));
}

TEST_CASE("more subsets than are lined up for the lanes", "[subset_sums]") {
    Random random(73);
    for (int i = 0; i < 20; ++i) check(random_case(random, 9 + random.below(5), 1 + random.below(20)));
    // One group with more copies than fit in the lanes.
    SubsetCase copies{{std::vector<Integer>(601, 1)}, {{3, 2, 600}}};
    CHECK(strict_subset_sums(copies.spans(), copies.groups) == evident_subset_sums(copies));
    SubsetCase long_result{{{0, 1}}, {{Integer(1) << 99'990, 1, 1}}};
    CHECK(strict_subset_sums(long_result.spans(), long_result.groups) == evident_subset_sums(long_result));
    long_result.groups[0].u <<= 20;
    CHECK_FALSE(strict_subset_sums(long_result.spans(), long_result.groups));
    long_result.groups[0].u <<= 900'000;
    CHECK_FALSE(regrouped_subset_sums(long_result.spans(), long_result.groups));
}

TEST_CASE("masses that a prime of the residues divides", "[subset_sums]") {
    Random random(74);
    for (const std::int64_t prime : first_primes) {
        for (int i = 0; i < 100; ++i) {
            SubsetCase given = random_case(random, 1 + random.below(5), 30);
            for (SubsetGroup& group : given.groups)
                if (random.one_in(2)) group.mass *= prime;
            check(given);
        }
    }
    // Whether the prime is among those of the current level.
    const auto is_met = [](std::int64_t prime) {
        const SubsetCase given{{{1, 1}}, {{1, prime, 1}}};
        return !regrouped_subset_sums(given.spans(), given.groups).has_value();
    };
    CHECK(is_met(first_primes[0]) != is_met(first_primes[1]));
}
