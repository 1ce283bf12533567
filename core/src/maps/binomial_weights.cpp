#include "binomial_weights.hpp"

#include <blossom/rational/combinatorics.hpp>

#include <deque>
#include <mutex>

namespace blossom {

namespace {

std::shared_ptr<const BinomialWeights> computed(std::size_t n) {
    auto weights = std::make_shared<BinomialWeights>();
    weights->denominator = binomial_row_lcm(n);
    weights->numerators.reserve(n + 1);
    for (const Integer& binomial : binomial_row(n))
        weights->numerators.push_back(divide_exactly(weights->denominator, binomial));
    return weights;
}

}  // namespace

std::shared_ptr<const BinomialWeights> binomial_weights(std::size_t n) {
    constexpr std::size_t most_kept = 16;
    constexpr std::size_t greatest_kept = 1000;
    if (n > greatest_kept) return computed(n);
    static std::mutex mutex;
    static std::deque<std::shared_ptr<const BinomialWeights>> kept;
    {
        const std::lock_guard lock(mutex);
        for (const auto& weights : kept) {
            if (weights->numerators.size() == n + 1) return weights;
        }
    }
    auto weights = computed(n);
    const std::lock_guard lock(mutex);
    kept.push_back(weights);
    if (kept.size() > most_kept) kept.pop_front();
    return weights;
}

}  // namespace blossom
