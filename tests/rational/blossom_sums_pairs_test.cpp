#include "blossom_sums_cases.hpp"
#include "rational_test.hpp"

// Factors read from pairs of numbers, one tuple and eight tuples at a time, compared with the evident
// formula.

namespace {

/// u and m of each factor, consecutively.
using Pairs = std::vector<Rational>;

/// Pairs, usually of few bits; sometimes near the limits of words, beyond them, or with a mass other than 0
/// and 1.
Pairs random_pairs(Random& random, std::size_t n, std::size_t bits, bool special_cases) {
    const Integer large = Integer(1) << 64;
    Pairs pairs;
    for (std::size_t i = 0; i < n; ++i) {
        const bool smooth = !random.one_in(8);
        Rational u(word_of_bits(random, bits),
                   denominator_of_bits(random, smooth ? std::min<std::size_t>(bits, 7) : bits));
        Rational m = random.one_in(4) ? 0 : 1;
        if (special_cases && random.one_in(n)) {
            const Rational odd[] = {std::numeric_limits<std::int64_t>::min(),
                                    std::numeric_limits<std::int64_t>::max(), Rational(large),
                                    Rational(1, large), Rational(-large - 1, large)};
            const Rational masses[] = {-1, 2, Rational(1, 2), Rational(large), Rational(1, large), 3};
            random.one_in(2) ? u = odd[random.below(std::size(odd))]
                             : m = masses[random.below(std::size(masses))];
        }
        pairs.push_back(u);
        pairs.push_back(m);
    }
    return pairs;
}

/// Whether the factors can be read according to the documentation.
bool can_be_read(const Pairs& pairs) {
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
        const Rational& u = pairs[i];
        const bool is_word = u.numerator().to_int64() && u.denominator().to_int64() &&
                             u.numerator() != std::numeric_limits<std::int64_t>::min();
        if (!is_word || (pairs[i + 1] != 0 && pairs[i + 1] != 1)) return false;
    }
    return true;
}

std::vector<WordFactor> factors_of(const Pairs& pairs) {
    std::vector<WordFactor> factors;
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
        const std::int64_t denominator = *pairs[i].denominator().to_int64();
        factors.push_back(
            {pairs[i + 1] == 0 ? 0 : denominator, *pairs[i].numerator().to_int64(), denominator});
    }
    return factors;
}

/// The factors, over the line if there is one.
std::vector<WordFactor> factors_over(const WordLine* line, const Pairs& pairs) {
    std::vector<WordFactor> factors = factors_of(pairs);
    if (line == nullptr) return factors;
    for (auto& [constant, slope, denominator] : factors) {
        const std::int64_t x = line->q * slope;
        slope = x - line->a * constant;
        constant = line->b * constant - x;
        denominator *= line->length;
    }
    return factors;
}

struct Given {
    std::size_t rows;
    std::vector<Rational> numbers;
};

Given random_rows(Random& random, std::size_t n) {
    Given given{1 + random.below(3), {}};
    const std::size_t bits = 1 + random.below(20);
    for (std::size_t k = 0; k < given.rows * (n + 1); ++k)
        given.numbers.push_back(Rational(word_of_bits(random, bits)) / Rational(1 + random.below(3)));
    return given;
}

void check_values(const Given& given, const Pairs& pairs, std::span<const Rational> values,
                  const WordLine* line = nullptr) {
    REQUIRE(can_be_read(pairs));
    const std::size_t size = given.numbers.size() / given.rows;
    for (std::size_t j = 0; j < given.rows; ++j) {
        CHECK(values[j] ==
              evident_sum(std::span(given.numbers).subspan(j * size, size), factors_over(line, pairs)));
    }
}

}  // namespace

TEST_CASE("pairs of numbers as factors", "[blossom_sums]") {
    Random random(19);
    int computed = 0;
    const Rational before(7, 9);
    for (int i = 0; i < 4'000; ++i) {
        const std::size_t n = 1 + random.below(9);
        const Given given = random_rows(random, n);
        const BlossomSums sums(RationalVector(given.numbers), given.rows);
        const Pairs pairs = random_pairs(random, n, 1 + random.below(std::clamp<std::size_t>(66 / n, 2, 62)),
                                         random.one_in(3));
        std::vector<Rational> values(given.rows, before);
        if (sums.evaluate_pairs(pairs.data(), 0, values)) {
            ++computed;
            check_values(given, pairs, values);
            std::vector<Rational> last(1);
            CHECK(sums.evaluate_pairs(pairs.data(), given.rows - 1, last));
            CHECK(last[0] == values.back());
        } else {
            CHECK(values == std::vector<Rational>(given.rows, before));
            if (can_be_read(pairs) && n < 8) CHECK(sums.kernel(factors_of(pairs)) != SumKernel::word);
        }
    }
    CHECK(computed > 1'500);
}

TEST_CASE("eight tuples of pairs of numbers", "[blossom_sums]") {
    Random random(20);
    int computed = 0;
    for (int i = 0; i < 4'000; ++i) {
        const bool wide = random.one_in(2);
        const std::size_t n = 1 + random.below(wide ? 17 : 9);
        const Given given = random_rows(random, n);
        const BlossomSums sums(RationalVector(given.numbers), given.rows);
        const bool special_cases = random.one_in(3);
        // About as many bits as fit in 51, 63 and 102, and more.
        const std::size_t bits =
            1 + random.below(std::clamp<std::size_t>((wide ? 105 : 66) / n, 2, random.one_in(2) ? 12 : 62));
        std::vector<Pairs> tuples;
        const Rational* addresses[8];
        for (std::size_t l = 0; l < 8; ++l)
            tuples.push_back(random_pairs(random, n, bits, special_cases && random.one_in(8)));
        for (std::size_t l = 0; l < 8; ++l) addresses[l] = tuples[l].data();
        const std::int64_t a = random.between(-9, 9);
        const std::int64_t length = random.between(1, 6);
        const WordLine lines[] = {{0, 1, 1, 1}, {a, a + length, random.between(1, 4), length}};
        const std::size_t choice = random.below(3);
        const WordLine* line = choice == 2 ? nullptr : &lines[choice];
        // The results may have held more than words before.
        std::vector<Rational> before(8 * given.rows, Rational(7, 9));
        if (random.one_in(3)) before[random.below(before.size())] = Rational(Integer(1) << 70);
        if (random.one_in(3)) before[random.below(before.size())] = Rational(1, Integer(1) << 70);
        std::vector<Rational> values = before;
        if (!sums.evaluate_eight(addresses, values, line)) {
            CHECK(values == before);
            continue;
        }
        ++computed;
        for (std::size_t l = 0; l < 8; ++l)
            check_values(given, tuples[l], std::span(values).subspan(l * given.rows, given.rows), line);
    }
    // Without the vector instructions nothing is computed.
    CHECK((computed == 0 || computed > 1'200));
}

TEST_CASE("eight tuples at a time with more than 52 twos to cancel", "[blossom_sums]") {
    // Vectors, so that the sum is the product of all u.
    for (const std::size_t shift : {51U, 52U, 53U, 54U, 55U, 60U}) {
        for (const std::int64_t odd : {0, 1, -3}) {
            const Integer even = Integer(odd) << shift;
            Pairs pairs{Rational(even), 0};
            for (int i = 0; i < 5; ++i) pairs.insert(pairs.end(), {Rational(1, 2048), 0});
            const std::vector<Rational> numbers{0, 0, 0, 0, 0, 0, 5};
            std::vector<Rational> values(8);
            const Rational* addresses[8];
            std::ranges::fill(addresses, pairs.data());
            if (BlossomSums(RationalVector(numbers), 1).evaluate_eight(addresses, values))
                CHECK(values == std::vector<Rational>(8, Rational(5 * even, Integer(1) << 55)));
        }
    }
}

TEST_CASE("over lines eight tuples at a time have numbers of 32 bits", "[blossom_sums]") {
    const std::vector<Rational> numbers{3, 5};
    const BlossomSums sums(RationalVector(numbers), 1);
    const std::vector<Rational> before(8, Rational(7, 9));
    std::vector<Rational> values;
    const auto evaluate = [&](const Rational& u, const WordLine& line) {
        Pairs pairs{u, 1};
        const Rational* addresses[8];
        std::ranges::fill(addresses, pairs.data());
        values = before;
        if (!sums.evaluate_eight(addresses, values, &line)) return false;
        CHECK(values == std::vector<Rational>(8, evident_sum(numbers, factors_over(&line, pairs))));
        return true;
    };
    const std::int64_t least = INT32_MIN;
    const std::int64_t most = INT32_MAX;
    const bool has_lanes = evaluate(0, {0, 1, 1, 1});
    for (const std::int64_t number : {least + 1, most}) {
        CHECK(evaluate(number, {0, 1, 1, 1}) == has_lanes);
        CHECK(evaluate(Rational(1, 3), {number, least, most, 2}) == has_lanes);
    }
    for (const std::int64_t number : {least - 1, most + 1, 4 * most + 5, -4 * most - 5}) {
        evaluate(number, {0, 1, 1, 1});
        for (const WordLine& line : {WordLine{number, 1, 1, 1}, WordLine{0, number, 1, 1},
                                     WordLine{0, 1, number, 1}, WordLine{0, 1, 1, 4 * most + 5}}) {
            CHECK(!evaluate(Rational(1, 3), line));
            CHECK(values == before);
        }
        CHECK(!evaluate(Rational(1, number), {0, 1, 1, 1}));
    }
}
