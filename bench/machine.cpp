// Compares one value of a prepared blossom with lower bounds for the machine: the multiply-adds of plain
// products in residues, and one greatest common divisor of the size of the result.

#include <blossom/core/blossom/blossom.hpp>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "cases.hpp"
#include "families.hpp"

namespace {

using namespace blossom;

#if defined(__x86_64__)

bool has_multiply_adds() { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512ifma"); }

/// Runs pairs of instructions, each with eight products of 52 bits, on sixteen independent sums.
__attribute__((target("avx512f,avx512ifma"))) void run_multiply_adds(std::size_t pairs) {
    constexpr std::size_t chains = 8;
    __m512i low[chains];
    __m512i high[chains];
    for (std::size_t i = 0; i < chains; ++i)
        low[i] = high[i] = _mm512_set1_epi64(static_cast<long long>(i + 1));
    const __m512i factor = _mm512_set1_epi64(0x3'ffff'ffff'ffdf);
    for (std::size_t done = 0; done < pairs; done += chains) {
#pragma GCC unroll 8
        for (std::size_t i = 0; i < chains; ++i) {
            low[i] = _mm512_madd52lo_epu64(low[i], factor, factor);
            high[i] = _mm512_madd52hi_epu64(high[i], factor, factor);
        }
    }
    __m512i sum = low[0];
    for (std::size_t i = 0; i < chains; ++i) sum = _mm512_xor_si512(sum, _mm512_xor_si512(low[i], high[i]));
    alignas(64) std::uint64_t words[8];
    _mm512_store_si512(words, sum);
    volatile std::uint64_t kept = words[0];
    (void)kept;
}

#else

bool has_multiply_adds() { return false; }
void run_multiply_adds(std::size_t) {}

#endif

/// The pairs for n^2 / 2 products per prime of 50 bits that the numerator needs, eight at a time.
std::size_t plain_pairs(std::size_t degree, const Rational& value) {
    const std::size_t primes = value.numerator().bit_length() / 50 + 1;
    return degree * degree / 2 * primes / 8;
}

}  // namespace

void measure_machine(const Report& report) {
    for (const std::size_t bits : {7U, 64U}) {
        for (const std::size_t degree : {3U, 10U, 20U, 100U, 300U, 1000U}) {
            const bool multiply_adds =
                degree >= 100 && has_multiply_adds() && report.wants("bare multiply-adds", degree, bits);
            const bool one_gcd = report.wants("one gcd", degree, bits);
            if (report.quick() && degree > 100) continue;
            if (!multiply_adds && !one_gcd) continue;
            const Case given = make_case(degree, bits);
            const std::vector<Argument> arguments = arguments_of(given);
            const Blossom blossom(curve_of(given));
            Rational value;
            const auto text = [] { return std::string(); };
            const Side engine{"engine", [&] { value = blossom.coordinate(0, arguments); }, text};
            engine.run();
            if (multiply_adds) {
                const std::size_t pairs = plain_pairs(degree, value);
                report.compare("machine", "bare multiply-adds", degree, bits,
                               {engine, {"machine", [&] { run_multiply_adds(pairs); }, text}});
            }
            if (one_gcd) {
                const Rational result = value;
                Integer divisor;
                report.compare(
                    "machine", "one gcd", degree, bits,
                    {engine,
                     {"Integer", [&] { divisor = gcd(result.numerator(), result.denominator()); }, text}});
            }
        }
    }
}
