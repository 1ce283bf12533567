#pragma once

// Sums over subsets, and the blossom in elementary symmetric functions, which uses neither subsets nor
// residues.

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/subset_sums.hpp>

#include <utility>
#include <vector>

namespace blossom::testing {

struct SubsetCase {
    std::vector<std::vector<Integer>> rows;
    std::vector<SubsetGroup> groups;

    std::vector<std::span<const Integer>> spans() const { return {rows.begin(), rows.end()}; }
};

/// sum_k c_k k! (n - k)! e_k, sum_k e_k X^k = prod (mass_i + u_i X).
inline std::vector<Integer> evident_subset_sums(const SubsetCase& given) {
    std::vector<Integer> elementary{1};
    for (const auto& [u, mass, multiplicity] : given.groups) {
        for (std::size_t i = 0; i < multiplicity; ++i) {
            elementary.emplace_back(0);
            for (std::size_t k = elementary.size() - 1; k > 0; --k)
                elementary[k] = mass * elementary[k] + u * elementary[k - 1];
            elementary[0] *= mass;
        }
    }
    const std::size_t n = elementary.size() - 1;
    std::vector<Integer> sums;
    for (const auto& row : given.rows) {
        Integer sum;
        for (std::size_t k = 0; k <= n; ++k) sum += row[k] * elementary[k] * factorial(k) * factorial(n - k);
        sums.push_back(std::move(sum));
    }
    return sums;
}

}  // namespace blossom::testing
