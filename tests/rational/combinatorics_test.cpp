#include "rational_test.hpp"

TEST_CASE("factorials follow their recurrence", "[combinatorics]") {
    Integer expected = 1;
    for (std::size_t n = 0; n <= 200; ++n) {
        if (n > 0) expected *= n;
        CHECK(factorial(n) == expected);
    }
    CHECK(to_string(factorial(20)) == "2432902008176640000");
    CHECK(to_string(factorial(21)) == "51090942171709440000");
    CHECK(to_string(factorial(25)) == "15511210043330985984000000");
}

TEST_CASE("falling factorials are products of k descending factors", "[combinatorics]") {
    for (std::size_t n = 0; n <= 40; ++n) {
        Integer expected = 1;
        for (std::size_t k = 0; k <= n + 3; ++k) {
            CAPTURE(n, k);
            CHECK(falling_factorial(n, k) == expected);
            expected *= k <= n ? Integer(n - k) : Integer(0);
        }
    }
}

TEST_CASE("binomials follow Pascal's triangle", "[combinatorics]") {
    std::vector<Integer> row{1};
    for (std::size_t n = 0; n <= 140; ++n) {
        CAPTURE(n);
        CHECK(binomial_row(n) == row);
        for (std::size_t k = 0; k <= n; ++k) CHECK(binomial(n, k) == row[k]);
        CHECK(binomial(n, n + 1) == 0);
        CHECK(binomial(n, n + 100) == 0);
        std::vector<Integer> next{1};
        for (std::size_t k = 0; k < n; ++k) next.push_back(row[k] + row[k + 1]);
        next.emplace_back(1);
        row = std::move(next);
    }
    CHECK(to_string(binomial(100, 50)) == "100891344545564193334812497256");
}

TEST_CASE("the least common multiple of a row of binomials", "[combinatorics]") {
    for (std::size_t n = 0; n <= 120; ++n) {
        Integer multiple = 1;
        for (std::size_t k = 0; k <= n; ++k) multiple = lcm(multiple, binomial(n, k));
        CAPTURE(n);
        CHECK(binomial_row_lcm(n) == multiple);
    }
}
