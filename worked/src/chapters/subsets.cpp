#include "subsets.hpp"

#include <numeric>

namespace blossom::worked {

std::vector<std::vector<std::size_t>> subsets_of_size(std::size_t n, std::size_t k) {
    std::vector<std::size_t> subset(k);
    std::iota(subset.begin(), subset.end(), std::size_t{0});
    std::vector<std::vector<std::size_t>> subsets;
    while (true) {
        subsets.push_back(subset);
        std::size_t place = k;
        while (place > 0 && subset[place - 1] == n - k + place - 1) --place;
        if (place == 0) return subsets;
        ++subset[place - 1];
        for (std::size_t i = place; i < k; ++i) subset[i] = subset[i - 1] + 1;
    }
}

}  // namespace blossom::worked
