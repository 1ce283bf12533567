// The Taylor shift by one on digits in vector lanes, held against Horner's rule on integers.

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/taylor_shift.hpp>

#include <vector>

#include "support/number_generators.hpp"
#include "support/number_printing.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

void check_shift(const std::vector<Integer>& coefficients) {
    CHECK(shifted_by_one(coefficients) == row_recurrences::shifted_by_one<Integer>(coefficients));
}

/// Now and then all ones or a power of two, which carry far.
Integer coefficient(Random& random, std::size_t bits) {
    const Integer sign = random.one_in(2) ? 1 : -1;
    if (random.one_in(6)) return 0;
    if (random.one_in(6)) return sign * ((Integer(1) << bits) - 1);
    if (random.one_in(6)) return sign * (Integer(1) << random.below(bits + 1));
    return integer_of_bits(random, random.below(bits + 1));
}

}  // namespace

TEST_CASE("a shift by one turns powers of t into binomials", "[taylor_shift]") {
    for (const std::size_t n : {0U, 1U, 11U, 12U, 13U, 40U, 200U}) {
        std::vector<Integer> power(n + 1);
        power[n] = 1;
        CHECK(shifted_by_one(power) == binomial_row(n));
    }
    CHECK(shifted_by_one({}).empty());
}

TEST_CASE("a shift by one on lanes is Horner's rule", "[taylor_shift]") {
    Random random(1);
    for (int i = 0; i < 12'000; ++i) {
        std::vector<Integer> coefficients(1 + random.below(45));
        const std::size_t bits = random.below(i % 8 == 0 ? 900 : 130);
        for (Integer& one : coefficients) one = coefficient(random, bits);
        check_shift(coefficients);
    }
}

TEST_CASE("a shift by one where words and pairs of words just suffice", "[taylor_shift]") {
    for (const std::size_t size : {1U, 2U, 3U, 12U, 40U, 63U, 64U, 65U}) {
        for (const std::size_t limit : {64U, 128U}) {
            for (std::size_t total = limit - 2; total <= limit + 1; ++total) {
                if (total < size) continue;
                const std::size_t bits = total + 1 - size;
                for (const int sign : {1, -1}) {
                    check_shift(std::vector<Integer>(size, sign * ((Integer(1) << bits) - 1)));
                    check_shift(std::vector<Integer>(size, sign * (Integer(1) << (bits - 1))));
                }
            }
        }
    }
}

TEST_CASE("a shift by one where the planes of digits grow", "[taylor_shift]") {
    Random random(2);
    // 48 and 384 bits, and twice as many, are what a plane holds; 14 coefficients are a block.
    for (const std::size_t limit : {96U, 192U, 384U, 768U}) {
        for (const std::size_t size : {13U, 14U, 15U, 28U, 29U, 100U}) {
            for (std::size_t below = 0; below < 2 * size + 6; ++below) {
                const std::size_t bits = limit + 3 - std::min<std::size_t>(below, limit - 1);
                std::vector<Integer> coefficients(size);
                const int sign = random.one_in(2) ? 1 : -1;
                for (Integer& one : coefficients) one = sign * ((Integer(1) << bits) - 1);
                check_shift(coefficients);
                for (Integer& one : coefficients) one = coefficient(random, bits);
                check_shift(coefficients);
            }
        }
    }
    for (const std::size_t size : {300U, 420U}) {
        std::vector<Integer> coefficients(size);
        for (Integer& one : coefficients) one = coefficient(random, 64);
        check_shift(coefficients);
        for (Integer& one : coefficients) one = -((Integer(1) << 63) + 1);
        check_shift(coefficients);
    }
}
