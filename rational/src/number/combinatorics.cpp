#include <blossom/rational/combinatorics.hpp>

#include <algorithm>

namespace blossom {

namespace {

/// first (first + 1) ... last, recursively by halves so that the factors stay balanced.
Integer product_of_range(std::size_t first, std::size_t last) {
    if (first > last) return 1;
    if (last - first < 8) {
        Integer product = first;
        for (std::size_t factor = first + 1; factor <= last; ++factor) product *= factor;
        return product;
    }
    const std::size_t middle = first + (last - first) / 2;
    return product_of_range(first, middle) * product_of_range(middle + 1, last);
}

}  // namespace

Integer factorial(std::size_t n) { return product_of_range(1, n); }

Integer falling_factorial(std::size_t n, std::size_t k) {
    return k > n ? Integer(0) : product_of_range(n - k + 1, n);
}

Integer binomial(std::size_t n, std::size_t k) {
    if (k > n) return 0;
    const std::size_t shorter = std::min(k, n - k);
    return divide_exactly(falling_factorial(n, shorter), factorial(shorter));
}

std::vector<Integer> binomial_row(std::size_t n) {
    std::vector<Integer> row(n + 1, 1);
    for (std::size_t k = 1; k <= n / 2; ++k) {
        row[k] = divide_exactly(row[k - 1] * Integer(n - k + 1), k);
        row[n - k] = row[k];
    }
    if (n > 0) row[n] = 1;
    return row;
}

Integer binomial_row_lcm(std::size_t n) {
    Integer multiple = 1;
    for (std::size_t factor = 2; factor <= n + 1; ++factor) multiple = lcm(multiple, factor);
    return divide_exactly(multiple, n + 1);
}

}  // namespace blossom
