#include "blossom_sums_cases.hpp"
#include "rational_test.hpp"

#include <thread>

// Sums by residues, compared at high degree with the product at points, because the evident formula is slow.

TEST_CASE("sums by residues", "[blossom_sums]") {
    Random random(7);
    Met met;
    for (int i = 0; i < 120; ++i) {
        const std::size_t n = 16 + random.below(i % 10 == 0 ? 80 : 20);
        check(random_case(random, n, 60 + random.below(900), 40 + random.below(22)), met);
    }
    CHECK(met[SumKernel::residues] > 80);
}

TEST_CASE("one prepared row is asked by several threads for sums of growing size", "[blossom_sums]") {
    Random random(9);
    std::vector<Case> cases;
    const Case first = random_case(random, 20, 700, 60);
    std::vector<Rational> expected;
    for (std::size_t i = 0; i < 12; ++i) {
        cases.push_back({first.numbers, random_case(random, 20, 1, 6 + 5 * i).factors});
        expected.push_back(evident_sum(first.numbers, cases.back().factors));
    }
    const BlossomSums sums(RationalVector(first.numbers), 1);
    std::vector<Rational> values(24);
    const auto work = [&](std::size_t thread) {
        for (std::size_t i = 0; i < 12; ++i)
            sums.evaluate(cases[i].factors, 0, std::span(values).subspan(12 * thread + i, 1));
    };
    std::jthread other(work, 1);
    work(0);
    other.join();
    for (std::size_t i = 0; i < 24; ++i) CHECK(values[i] == expected[i % 12]);
}
