#include "quotient_reduction.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include "limb_arithmetic.hpp"
#include "rational_access.hpp"

namespace blossom {

namespace {

using limbs::Limb;

/// A number > 0 in limbs, none of which is 0 at the top.
class Natural {
public:
    explicit Natural(Limb value) : limbs_{value} {}
    explicit Natural(std::span<const Limb> limbs)
        : limbs_(limbs.begin(),
                 limbs.begin() + static_cast<std::ptrdiff_t>(limbs::used(limbs.data(), limbs.size()))) {}

    std::span<const Limb> span() const { return limbs_; }
    bool is_one() const { return limbs_.size() == 1 && limbs_[0] == 1; }
    void multiply(std::span<const Limb> factor) {
        std::vector<Limb> product(limbs_.size() + factor.size());
        if (factor.size() > limbs_.size()) {
            limbs::multiply(product.data(), factor.data(), factor.size(), limbs_.data(), limbs_.size());
        } else {
            limbs::multiply(product.data(), limbs_.data(), limbs_.size(), factor.data(), factor.size());
        }
        product.resize(limbs::used(product.data(), product.size()));
        limbs_ = std::move(product);
    }

private:
    std::vector<Limb> limbs_;
};

/// gcd(a, b) for a >= 0 and b > 0 without zeros at the top.
Natural gcd(std::span<const Limb> a, std::span<const Limb> b) {
    const std::size_t a_size = limbs::used(a.data(), a.size());
    if (a_size == 0) return Natural(b);
    if (a_size == 1 && b.size() == 1) return Natural(gcd_of_words(a[0], b[0]));
    std::vector<Limb> room(2 * (a_size + b.size()));
    Limb* const x = room.data();
    Limb* const y = x + a_size;
    Limb* const result = y + b.size();
    std::copy_n(a.data(), a_size, x);
    std::ranges::copy(b, y);
    const std::size_t twos = std::min(limbs::trailing_zeros(x), limbs::trailing_zeros(y));
    limbs::shift_right(x, a_size, limbs::trailing_zeros(x));
    limbs::shift_right(y, b.size(), limbs::trailing_zeros(y));
    const std::size_t m = limbs::used(x, a_size);
    const std::size_t n = limbs::used(y, b.size());
    const std::size_t size =
        m < n ? limbs::gcd_with_odd(result, y, n, x, m) : limbs::gcd_with_odd(result, x, m, y, n);
    Natural common(std::span(result, size));
    if (twos > 0) {
        std::vector<Limb> power(twos / 64 + 1);
        power.back() = Limb{1} << (twos % 64);
        common.multiply(power);
    }
    return common;
}

/// The products of 1, 2, 4, ... neighbouring factors.
class FactorTree {
public:
    explicit FactorTree(std::span<const Integer> factors) {
        std::size_t all = 0;
        for (const Integer& factor : factors) all += limbs::size_of(factor);
        const auto depth = static_cast<std::size_t>(std::bit_width(factors.size()));
        limbs_.resize(all * (depth + 1) + 1);
        Limb* next = limbs_.data();
        levels_.emplace_back();
        for (const Integer& factor : factors) {
            const std::size_t size = limbs::size_of(factor);
            limbs::write_magnitude(factor, next, size);
            levels_[0].emplace_back(next, size);
            next += size;
        }
        while (levels_.back().size() > 1) {
            const std::vector<std::span<const Limb>>& below = levels_.back();
            std::vector<std::span<const Limb>> level;
            level.reserve((below.size() + 1) / 2);
            for (std::size_t i = 0; i + 1 < below.size(); i += 2) {
                const bool swap = below[i].size() < below[i + 1].size();
                const auto& a = below[i + (swap ? 1 : 0)];
                const auto& b = below[i + (swap ? 0 : 1)];
                limbs::multiply(next, a.data(), a.size(), b.data(), b.size());
                level.emplace_back(next, limbs::used(next, a.size() + b.size()));
                next += level.back().size();
            }
            if (below.size() % 2 == 1) level.push_back(below.back());
            levels_.push_back(std::move(level));
        }
    }

    std::span<const Limb> product() const { return levels_.back()[0]; }

    /// A multiple of gcd(numerator, product) whose prime factors divide both: itself for short products, and
    /// prod gcd(numerator, factor) for longer ones.
    Natural common(std::span<const Limb> numerator) {
        if (product().size() <= longest_direct) return gcd_of(numerator, product());
        Natural result(1);
        room_.resize(numerator.size() + levels_.size() * (product().size() + 2));
        gather(numerator, levels_.size() - 1, 0, room_.data(), result);
        return result;
    }

private:
    /// In limbs, by measurement.
    static constexpr std::size_t longest_direct = 32;

    Natural gcd_of(std::span<const Limb> number, std::span<const Limb> divisor) {
        if (number.size() < divisor.size()) return gcd(number, divisor);
        room_.resize(number.size() + 1);
        limbs::divide(room_.data() + divisor.size(), room_.data(), number.data(), number.size(),
                      divisor.data(), divisor.size());
        return gcd({room_.data(), divisor.size()}, divisor);
    }

    void gather(std::span<const Limb> number, std::size_t level, std::size_t i, Limb* room, Natural& result) {
        const std::span<const Limb> node = levels_[level][i];
        if (node.size() == 1) {
            const std::uint64_t common =
                gcd_of_words(limbs::remainder(number.data(), number.size(), node[0]), node[0]);
            // A product of factors that is prime to the number ends the search.
            if (common == 1) return;
        }
        std::span<const Limb> rest = number;
        if (number.size() >= node.size()) {
            limbs::divide(room + node.size(), room, number.data(), number.size(), node.data(), node.size());
            rest = {room, node.size()};
            room += node.size();
        }
        if (level == 0) {
            const Natural common = gcd(rest, node);
            if (!common.is_one()) result.multiply(common.span());
            return;
        }
        gather(rest, level - 1, 2 * i, room, result);
        if (2 * i + 1 < levels_[level - 1].size()) gather(rest, level - 1, 2 * i + 1, room, result);
    }

    std::vector<Limb> limbs_;
    std::vector<Limb> room_;
    std::vector<std::vector<std::span<const Limb>>> levels_;
};

Integer quotient(std::span<const Limb> dividend, std::span<const Limb> divisor, bool negative) {
    std::vector<Limb> room(dividend.size() + 1);
    Limb* const result = room.data();
    std::vector<Limb> rest(divisor.size());
    limbs::divide(result, rest.data(), dividend.data(), dividend.size(), divisor.data(), divisor.size());
    return IntegerAccess::from_magnitude(std::span(result, dividend.size() - divisor.size() + 1), negative);
}

}  // namespace

Rational reduced_quotient(const Integer& numerator, std::span<const Integer> factors) {
    std::vector<Limb> words(limbs::size_of(numerator));
    limbs::write_magnitude(numerator, words.data(), words.size());
    return reduced_quotient(words, numerator.sign() < 0, factors);
}

Rational reduced_quotient(std::span<const Limb> numerator, bool negative, std::span<const Integer> factors) {
    const std::span<const Limb> top = numerator.first(limbs::used(numerator.data(), numerator.size()));
    if (top.empty()) return 0;
    if (factors.empty()) return IntegerAccess::from_magnitude(top, negative);
    FactorTree tree(factors);
    Natural shared = tree.common(top);
    if (!shared.is_one()) shared = gcd(top, shared.span());
    if (shared.is_one()) {
        return RationalAccess::from_lowest_terms(IntegerAccess::from_magnitude(top, negative),
                                                 IntegerAccess::from_magnitude(tree.product(), false));
    }
    return RationalAccess::from_lowest_terms(quotient(top, shared.span(), negative),
                                             quotient(tree.product(), shared.span(), false));
}

}  // namespace blossom
