// Both polarizations by residues, at the sizes where one more group of primes is needed.

#include "each_case.hpp"
#include "rational/subset_cases.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// A case whose results are near the bits of some number of groups of eight primes; in half of the cases all
/// signs are equal.
SubsetCase subset_case(Random& random, std::size_t most_groups) {
    SubsetCase result;
    const int sign = random.one_in(2) ? 1 : 0;
    const std::size_t bits = 1 + random.below(random.one_in(3) ? 120 : 40);
    std::size_t n = 0;
    Integer size = 1;
    for (std::size_t g = random.below(most_groups + 1); g > 0; --g) {
        const std::size_t multiplicity = random.one_in(4) ? 1 + random.below(4) : 1;
        Integer mass = random.one_in(3) ? Integer(1) : number_near(random, bits, sign);
        // A prime of the residues on some level: the greatest that are 1 modulo 2^13 and 2^11.
        if (random.one_in(16))
            mass *= random.one_in(2) ? (std::int64_t{1} << 50) - 16383 : (std::int64_t{1} << 28) - 65535;
        result.groups.push_back({number_near(random, bits, sign), mass, multiplicity});
        size *= pow(abs(result.groups.back().u) + abs(mass), multiplicity);
        n += multiplicity;
    }
    size *= factorial(n);
    const std::size_t of_group = random.one_in(2) ? 400 : 224;
    const std::size_t limit = of_group * (size.bit_length() / of_group + 1) - random.below(6);
    const std::size_t left = limit - std::min(limit, size.bit_length());
    for (std::size_t row = 0; row < (random.one_in(4) ? 2 : 1); ++row) {
        auto& coefficients = result.rows.emplace_back();
        for (std::size_t k = 0; k <= n; ++k) coefficients.push_back(number_near(random, left, sign));
    }
    return result;
}

}  // namespace

TEST_CASE("strict polarization: results near the limits of groups of primes", "[differential]") {
    each_case("strict polarization", [&](Random& random) {
        const SubsetCase given = subset_case(random, 5);
        check_same(strict_subset_sums(given.spans(), given.groups).value(), evident_subset_sums(given));
    });
}

TEST_CASE("regrouped polarization: results near the limits of groups of primes", "[differential]") {
    std::size_t computed = 0;
    each_case("regrouped polarization", [&](Random& random) {
        const SubsetCase given = subset_case(random, random.one_in(8) ? 14 : 7);
        const auto sums = regrouped_subset_sums(given.spans(), given.groups);
        if (!sums) return;
        ++computed;
        check_same(*sums, evident_subset_sums(given));
    });
    CHECK(2 * computed + 10 > differential_cases());
}
