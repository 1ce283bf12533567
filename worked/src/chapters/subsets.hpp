#pragma once

#include <cstddef>
#include <vector>

namespace blossom::worked {

/// The subsets of {0, ..., n - 1} with k elements, in lexicographic order. Cost: C(n, k) lists.
std::vector<std::vector<std::size_t>> subsets_of_size(std::size_t n, std::size_t k);

}  // namespace blossom::worked
