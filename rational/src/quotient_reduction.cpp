#include "quotient_reduction.hpp"

#include <vector>

#include "rational_access.hpp"

namespace blossom {

namespace {

/// The products of 1, 2, 4, ... neighbouring factors.
class FactorTree {
public:
    explicit FactorTree(std::span<const Integer> factors) {
        levels_.emplace_back(factors.begin(), factors.end());
        while (levels_.back().size() > 1) {
            const std::vector<Integer>& below = levels_.back();
            std::vector<Integer> level;
            level.reserve((below.size() + 1) / 2);
            for (std::size_t i = 0; i + 1 < below.size(); i += 2) level.push_back(below[i] * below[i + 1]);
            if (below.size() % 2 == 1) level.push_back(below.back());
            levels_.push_back(std::move(level));
        }
    }

    const Integer& product() const { return levels_.back()[0]; }

    /// prod gcd(numerator, factor).
    Integer common(const Integer& numerator) const { return common(numerator, levels_.size() - 1, 0); }

private:
    Integer common(const Integer& numerator, std::size_t level, std::size_t i) const {
        const Integer rest = numerator % levels_[level][i];
        if (level == 0) return gcd(rest, levels_[0][i]);
        Integer product = common(rest, level - 1, 2 * i);
        if (2 * i + 1 < levels_[level - 1].size()) product *= common(rest, level - 1, 2 * i + 1);
        return product;
    }

    std::vector<std::vector<Integer>> levels_;
};

}  // namespace

Rational reduced_quotient(const Integer& numerator, std::span<const Integer> factors) {
    if (numerator.is_zero() || factors.empty()) return numerator;
    const FactorTree tree(factors);
    Integer shared = tree.common(numerator);
    if (!shared.is_one()) shared = gcd(numerator, shared);
    if (shared.is_one()) return RationalAccess::from_lowest_terms(numerator, tree.product());
    return RationalAccess::from_lowest_terms(divide_exactly(numerator, shared),
                                             divide_exactly(tree.product(), shared));
}

}  // namespace blossom
