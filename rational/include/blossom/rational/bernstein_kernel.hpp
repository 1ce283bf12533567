#pragma once

#include <blossom/rational/integer.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// A quotient of words, the denominator positive and both below 2^48 in magnitude.
struct WordQuotient {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
};

/// The coefficients w_k of the form sum_k c_k u^k v^(n-k) on the line through a and b: it is
/// sum_k w_k x^(n-k) y^k for u = a.numerator x + b.numerator y and v = a.denominator x + b.denominator y.
///
/// Modulo primes, where nothing is lost by division: two Taylor shifts by number theoretic transforms between
/// scalings. Nothing where the processor has no vectors for it, and for no or one coefficient, more than
/// 4096, or results of 25'000 bits. Cost: n log n multiply-adds for each prime, and for n numbers of P primes
/// n P^2 to combine them.
std::optional<std::vector<Integer>> form_on_line(std::span<const Integer> coefficients, const WordQuotient& a,
                                                 const WordQuotient& b);

/// weights[k] w_k q^k s^(n-k) with the w_k of `form_on_line`, where q and s are the denominators of a and b
/// over their greatest common divisor: numerators of Bernstein coefficients for positive weights 1 / C(n, k)
/// over a common denominator. Nothing unless all fit in a few words. Cost: n^2 multiply-adds of fixed width;
/// no memory but that of the result.
std::optional<std::vector<Integer>> bernstein_in_words(std::span<const Integer> coefficients,
                                                       const WordQuotient& a, const WordQuotient& b,
                                                       std::span<const Integer> weights);

}  // namespace blossom
