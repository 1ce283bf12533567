#include <blossom/rational/taylor_shift.hpp>
#include "rational_test.hpp"

// The Taylor shift by one on digits in vector lanes, compared with Horner's rule on integers.

namespace {

void check_shift(const std::vector<Integer>& coefficients) {
    CHECK(shifted_by_one(coefficients) == row_recurrences::shifted_by_one<Integer>(coefficients));
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
