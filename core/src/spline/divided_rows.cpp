#include "divided_rows.hpp"

namespace blossom {

Integer divide_entries(std::span<std::vector<Integer>> rows, std::span<const Integer> divisors) {
    std::vector<Integer> missing;
    missing.reserve(divisors.size());
    Integer factor = 1;
    for (std::size_t i = 0; i < divisors.size(); ++i) {
        Integer common = divisors[i];
        for (const auto& row : rows) common = gcd(common, row[i]);
        if (divisors[i].sign() < 0) common.negate();
        for (auto& row : rows) row[i] = divide_exactly(row[i], common);
        missing.push_back(divide_exactly(divisors[i], common));
        factor = lcm(factor, missing.back());
    }
    if (factor.is_one()) return factor;
    for (std::size_t i = 0; i < divisors.size(); ++i) {
        if (missing[i] == factor) continue;
        const Integer scale = divide_exactly(factor, missing[i]);
        for (auto& row : rows) row[i] *= scale;
    }
    return factor;
}

}  // namespace blossom
