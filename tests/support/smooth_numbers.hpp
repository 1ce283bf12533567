#pragma once

// Numbers with few distinct primes, so that numerators and denominators have many common factors.

#include <array>
#include <cstdint>
#include <vector>

#include "number_generators.hpp"

namespace blossom::testing {

/// Primes on both sides of the limit of the table of small primes, and primes near the limit of a word.
inline constexpr std::array<std::int64_t, 8> primes{2,     3,          137,        139,
                                                    65537, 2147483647, 1000000007, 2305843009213693951};

/// A product of these primes below 2^62, sometimes 1.
inline std::int64_t smooth_word(Random& random) {
    std::int64_t product = 1;
    while (!random.one_in(9)) {
        std::int64_t next = 0;
        if (__builtin_mul_overflow(product, primes[random.below(primes.size())], &next) || next >> 62 != 0)
            break;
        product = next;
    }
    return product;
}

inline Integer smooth(Random& random, std::size_t words) {
    Integer product = 1;
    for (std::size_t i = 0; i < words; ++i) product *= smooth_word(random);
    return product;
}

/// Numbers and factors of up to `words` words each.
inline std::vector<Rational> smooth_numbers(Random& random, std::size_t count, std::size_t words) {
    std::vector<Rational> numbers;
    for (std::size_t k = 0; k < count; ++k) {
        const Integer top = random.one_in(9) ? Integer() : smooth(random, random.below(words + 1));
        numbers.emplace_back(random.one_in(2) ? top : -top, smooth(random, random.below(words + 1)));
    }
    return numbers;
}

}  // namespace blossom::testing
