// Eight tuples of factors at once, at the limits of the numbers in vector lanes.

#include "sum_cases.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Pairs u, m, and the factors that they denote.
struct Tuple {
    std::vector<Rational> pairs;
    std::vector<WordFactor> factors;
};

/// A line whose numbers usually have exactly `bits` bits, up to 32; lanes read 31 bits and the sign.
WordLine line_near(Random& random, std::size_t bits) {
    const auto number = [&] {
        const std::int64_t word = word_near(random, bits);
        return random.one_in(2) ? -word : word;
    };
    return {number(), number(), number(), std::max<std::int64_t>(1, word_near(random, random.below(5)))};
}

/// The factor of a pair, over the line if there is one; nullopt if words do not hold it.
std::optional<WordFactor> factor_of(const Rational& u, bool is_point, const WordLine* line) {
    Integer constant = is_point ? u.denominator() : 0;
    Integer slope = u.numerator();
    Integer denominator = u.denominator();
    if (line != nullptr) {
        const Integer x = line->q * slope;
        slope = x - line->a * constant;
        constant = line->b * constant - x;
        denominator *= line->length;
    }
    const auto words = {constant.to_int64(), slope.to_int64(), denominator.to_int64()};
    for (const auto& word : words)
        if (!word || *word == INT64_MIN) return std::nullopt;
    return WordFactor{*words.begin()[0], *words.begin()[1], *words.begin()[2]};
}

/// n pairs whose factors have about `bits` bits.
std::optional<Tuple> tuple_near(Random& random, std::size_t n, std::size_t bits, std::size_t denominator_bits,
                                const WordLine* line) {
    Tuple tuple;
    for (std::size_t i = 0; i < n; ++i) {
        const WordFactor factor = factor_near(random, bits, denominator_bits, Signs::any);
        const Rational u(factor.slope, factor.denominator);
        const bool is_point = !random.one_in(4);
        const auto moved = factor_of(u, is_point, line);
        if (!moved) return std::nullopt;
        tuple.pairs.push_back(u);
        tuple.pairs.emplace_back(is_point ? 1 : 0);
        tuple.factors.push_back(*moved);
    }
    return tuple;
}

}  // namespace

TEST_CASE("eight sums: sums and denominators that end at 51, 52, 63 and 102 bits", "[differential]") {
    std::size_t computed = 0;
    std::size_t over_lines = 0;
    each_case("eight sums", [&](Random& random) {
        const std::size_t limits[] = {51, 52, 63, 102, 102};
        const std::size_t limit = limits[random.below(5)] + 1 - random.below(random.one_in(3) ? 3 : 16);
        const std::size_t n = 1 + random.below(limit > 64 ? 17 : 9);
        const std::size_t bits = std::clamp<std::size_t>(limit / (n + random.below(3)), 2, 62) - 1;
        // The product of all denominators is near the limit, or far below it.
        const std::size_t share = limit / n;
        const std::size_t denominator_bits =
            random.one_in(2) ? std::min<std::size_t>(62, share + 1 - std::min(share, random.below(5)))
                             : std::max<std::size_t>(1, share / 2);
        std::optional<WordLine> line;
        std::size_t line_bits = 0;
        if (random.one_in(2)) {
            line_bits = random.below(std::min<std::size_t>(bits, 32) + 1);
            line = line_near(random, line_bits);
        }
        const WordLine* given_line = line ? &*line : nullptr;
        std::vector<Tuple> tuples;
        const Rational* addresses[8];
        for (int l = 0; l < 8; ++l) {
            auto tuple =
                tuple_near(random, n, std::max<std::size_t>(1, bits - line_bits),
                           std::max<std::size_t>(1, denominator_bits - std::min(denominator_bits, line_bits)),
                           given_line);
            if (!tuple) return count_as("beyond words");
            tuples.push_back(std::move(*tuple));
        }
        for (std::size_t l = 0; l < 8; ++l) addresses[l] = tuples[l].pairs.data();
        // The widest tuple determines the bits of the numbers.
        const auto widest_tuple = std::ranges::max_element(tuples, [](const Tuple& a, const Tuple& b) {
            return size_of_product(a.factors) < size_of_product(b.factors);
        });
        const SumCase widest = case_at_limit(random, widest_tuple->factors, limit, any_signs(random));
        const std::size_t rows = widest.rows();
        std::vector<Rational> values(8 * rows);
        const bool fits = widest.sums().evaluate_eight(addresses, values, given_line);
        count_as(!fits ? "refused" : line ? "computed over a line" : "computed");
        if (!fits) return;
        ++computed;
        if (line) ++over_lines;
        for (std::size_t l = 0; l < 8; ++l) {
            const std::vector<Rational> expected =
                evident_values(widest.numerators, widest.denominator, beyond_words(tuples[l].factors));
            CHECK(std::equal(expected.begin(), expected.end(),
                             values.begin() + static_cast<std::ptrdiff_t>(l * rows)));
        }
    });
    // Without the vector instructions nothing is computed.
    CHECK((computed == 0 || 8 * computed + 20 > differential_cases()));
    CHECK((computed == 0 || 16 * over_lines + 20 > differential_cases()));
}
