#pragma once

#include <blossom/rational/integer.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// A quotient of words with a positive denominator; both words are below 2^48 in magnitude.
struct WordQuotient {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
};

/// The coefficients w_k of the form sum_k c_k u^k v^(n-k) on the line through a and b: the form equals
///     sum_k w_k x^(n-k) y^k for u = a.numerator x + b.numerator y and v = a.denominator x + b.denominator y.
///
/// The kernel works modulo primes, where division loses nothing: two Taylor shifts by number theoretic
/// transforms, with scalings before, between and after them. Returns nullopt without vector instructions, for
/// fewer than 2 or more than 4096 coefficients, and for results beyond 25'000 bits. Cost: n log n
/// multiply-adds per prime, and n P^2 to combine n numbers from P primes.
std::optional<std::vector<Integer>> form_on_line(std::span<const Integer> coefficients, const WordQuotient& a,
                                                 const WordQuotient& b);

/// weights[k] w_k q^k s^(n-k) with the w_k of `form_on_line`, where q and s are the denominators of a and b
/// over their greatest common divisor. With the positive weights 1 / C(n, k) over a common denominator, these
/// are numerators of Bernstein coefficients. Returns nullopt unless all of them fit in a few words. Cost: n^2
/// multiply-adds of fixed width; only the result takes memory.
std::optional<std::vector<Integer>> bernstein_in_words(std::span<const Integer> coefficients,
                                                       const WordQuotient& a, const WordQuotient& b,
                                                       std::span<const Integer> weights);

}  // namespace blossom
