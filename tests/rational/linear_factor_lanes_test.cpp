// Eight tuples of factors side by side against the evident formula.

#include "rational/linear_factor_cases.hpp"

#include <algorithm>

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Eight tuples of n factors with numbers of `bits` bits, and rows of `row_bits` bits; some denominators have
/// primes beyond all tables.
void check_eight(Random& random, std::size_t n, std::size_t bits, std::size_t row_bits, int& computed) {
    const std::size_t rows = 1 + random.below(3);
    std::vector<Rational> numbers;
    for (std::size_t k = 0; k < rows * (n + 1); ++k)
        numbers.push_back(Rational(word_of_bits(random, row_bits)) / Rational(1 + random.below(3)));
    const LinearFactorSums sums(RationalVector(numbers), rows);
    std::vector<WordFactorOctet> octets(n);
    std::vector<std::vector<WordFactor>> tuples(8);
    const bool smooth = !random.one_in(8);
    for (std::size_t l = 0; l < 8; ++l) {
        for (std::size_t i = 0; i < n; ++i) {
            const std::int64_t denominator = smooth
                                                 ? denominator_of_bits(random, std::min<std::size_t>(bits, 7))
                                                 : denominator_of_bits(random, bits);
            tuples[l].push_back({word_of_bits(random, bits), word_of_bits(random, bits),
                                 denominator << (smooth && random.one_in(4) ? bits / 8 : 0)});
            octets[i].constants[l] = tuples[l][i].constant;
            octets[i].slopes[l] = tuples[l][i].slope;
            octets[i].denominators[l] = tuples[l][i].denominator;
        }
    }
    std::vector<Rational> values(8 * rows, Rational(7, 9));
    if (!sums.evaluate_eight(octets, values)) {
        CHECK(values == std::vector<Rational>(8 * rows, Rational(7, 9)));
        return;
    }
    ++computed;
    for (std::size_t l = 0; l < 8; ++l) {
        for (std::size_t j = 0; j < rows; ++j) {
            const std::span<const Rational> row = std::span(numbers).subspan(j * (n + 1), n + 1);
            CHECK(values[l * rows + j] == evident_sum(row, tuples[l]));
        }
    }
}

}  // namespace

TEST_CASE("eight tuples at a time", "[linear_factor_sums]") {
    Random random(18);
    int computed = 0;
    for (int i = 0; i < 2'000; ++i) {
        const std::size_t n = random.below(10);
        // About as many bits as fit in 51 and in 63, and more.
        const std::size_t bits = 1 + random.below(n == 0 ? 60 : std::clamp<std::size_t>(66 / n, 2, 62));
        check_eight(random, n, bits, 1 + random.below(20), computed);
    }
    for (std::size_t bits = 40; bits <= 62; ++bits)
        for (int i = 0; i < 40; ++i) check_eight(random, 1, bits - 2, 1 + random.below(4), computed);
    // Where the processor has no lanes nothing is computed, and everywhere else most.
    CHECK((computed == 0 || computed > 800));
}
