#pragma once

// Many cases for each fast path. The environment variable BLOSSOM_DIFFERENTIAL_CASES sets their number per
// path (300 by default), and BLOSSOM_DIFFERENTIAL_SEED the seed (1 by default). scripts/differential runs
// tens of thousands on each level of vector instructions.

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "support/number_generators.hpp"
#include "support/number_printing.hpp"

namespace blossom::testing {

inline std::uint64_t differential_setting(const char* variable, std::uint64_t otherwise) {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the tests never write the environment
    const char* text = std::getenv(variable);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// The number of cases; `otherwise` if the environment does not set it.
inline std::size_t differential_cases(std::size_t otherwise = 300) {
    return differential_setting("BLOSSOM_DIFFERENTIAL_CASES", otherwise);
}

/// The counts of the current path, for the line that is printed about it.
struct Counts {
    std::string path;
    std::size_t cases = 0;
    std::map<std::string, std::size_t> kinds;  ///< of cases, if the path distinguishes them

    static Counts& of_path() {
        static Counts counts;
        return counts;
    }
};
inline void count_as(const std::string& kind) { ++Counts::of_path().kinds[kind]; }

/// Calls check(random) for each case of a path. Each case has its own random stream, so that it can be
/// repeated without the previous cases.
template <class Check>
void each_case(std::string_view path, const Check& check, std::size_t otherwise = 300) {
    Counts::of_path().path = path;
    std::uint64_t first = differential_setting("BLOSSOM_DIFFERENTIAL_SEED", 1) << 40;
    for (const char letter : path) first = first * 31 + static_cast<unsigned char>(letter);
    for (std::size_t i = 0; i < differential_cases(otherwise); ++i) {
        Random random(first + i);
        INFO("case " << i << " of " << path);
        check(random);
        ++Counts::of_path().cases;
    }
}

/// Compares numbers, and on failure shows the ends of the first one that differs, because Catch takes minutes
/// to print rows of long numbers.
template <class Number>
void check_same(const std::vector<Number>& numbers, const std::vector<Number>& expected) {
    if (numbers.size() != expected.size()) FAIL(numbers.size() << " numbers in place of " << expected.size());
    const auto [number, other] = std::ranges::mismatch(numbers, expected);
    if (number == numbers.end()) {
        SUCCEED();
        return;
    }
    const auto ends = [](const Number& value) {
        const std::string text = to_string(value);
        return text.size() < 100 ? text : text.substr(0, 40) + "..." + text.substr(text.size() - 40);
    };
    FAIL_CHECK("number " << number - numbers.begin() << " is " << ends(*number) << ", not " << ends(*other));
}

/// A number usually of exactly `bits` bits, sometimes zero; `sign` is its sign, or 0 for either.
inline Integer number_near(Random& random, std::size_t bits, int sign = 0) {
    if (random.one_in(12)) return 0;
    const bool all_ones = random.one_in(3);
    const Integer number = all_ones
                               ? (Integer(1) << bits) - 1
                               : integer_of_bits(random, random.one_in(3) ? random.below(bits + 1) : bits);
    if (sign == 0) return random.one_in(2) ? number : -number;
    return sign < 0 ? -abs(number) : abs(number);
}

}  // namespace blossom::testing
