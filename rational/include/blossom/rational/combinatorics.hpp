#pragma once

#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <vector>

namespace blossom {

/// n! = 1 * 2 * ... * n.
Integer factorial(std::size_t n);

/// n! / (n - k)! = n (n - 1) ... (n - k + 1); 0 for k > n.
Integer falling_factorial(std::size_t n, std::size_t k);

/// C(n, k); 0 for k > n.
Integer binomial(std::size_t n, std::size_t k);

/// C(n, 0), ..., C(n, n). Cost: n multiplications and exact divisions by small integers.
std::vector<Integer> binomial_row(std::size_t n);

/// The least common multiple of C(n, 0), ..., C(n, n), which is lcm(1, ..., n + 1) / (n + 1).
Integer binomial_row_lcm(std::size_t n);

}  // namespace blossom
