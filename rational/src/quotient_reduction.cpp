#include "quotient_reduction.hpp"

#include <algorithm>

namespace blossom {

namespace {

constexpr std::size_t most_words = DenominatorWords::most_words + 1;

std::uint64_t remainder(std::span<const std::uint64_t> words, std::uint64_t divisor) {
    std::uint64_t rest = 0;
    for (std::size_t i = words.size(); i-- > 0;) {
        rest = static_cast<std::uint64_t>((Wide{rest} << 64 | words[i]) % divisor);
    }
    return rest;
}

/// A number >= 0 in words on the stack.
struct Words {  // NOLINT(cppcoreguidelines-pro-type-member-init): only the first `size` are ever read
    std::uint64_t words[most_words];
    std::size_t size = 1;

    std::span<const std::uint64_t> span() const { return {words, size}; }

    void multiply(std::uint64_t factor) {
        Wide carry = 0;
        for (std::size_t i = 0; i < size; ++i) {
            carry += Wide{words[i]} * factor;
            words[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        if (carry != 0) words[size++] = static_cast<std::uint64_t>(carry);
    }
    void divide(std::uint64_t divisor) {
        Wide rest = 0;
        for (std::size_t i = size; i-- > 0;) {
            rest = rest << 64 | words[i];
            words[i] = static_cast<std::uint64_t>(rest / divisor);
            rest %= divisor;
        }
    }
};

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

Rational reduced_quotient(std::span<const std::uint64_t> numerator, bool negative,
                          std::span<const std::uint64_t> denominator, const Integer& further) {
    std::uint64_t shared = 1;
    bool shared_fits = further.is_one() && numerator.size() <= most_words;
    for (const std::uint64_t factor : denominator) {
        if (!shared_fits) break;
        const std::uint64_t common = gcd_of_words(remainder(numerator, factor), factor);
        shared_fits = !__builtin_mul_overflow(shared, common, &shared);
    }
    Words bottom;
    bottom.words[0] = 1;
    for (const std::uint64_t factor : denominator) bottom.multiply(factor);
    if (!shared_fits) {
        return {IntegerAccess::from_magnitude(numerator, negative),
                IntegerAccess::from_magnitude(bottom.span(), false) * further};
    }
    if (shared != 1 && denominator.size() > 1) {
        shared = gcd_of_words(remainder(numerator, shared), shared);
    }
    if (shared == 1) {
        return RationalAccess::from_lowest_terms(IntegerAccess::from_magnitude(numerator, negative),
                                                 IntegerAccess::from_magnitude(bottom.span(), false));
    }
    Words top;
    top.size = numerator.size();
    std::ranges::copy(numerator, top.words);
    top.divide(shared);
    bottom.divide(shared);
    return RationalAccess::from_lowest_terms(IntegerAccess::from_magnitude(top.span(), negative),
                                             IntegerAccess::from_magnitude(bottom.span(), false));
}

}  // namespace blossom
