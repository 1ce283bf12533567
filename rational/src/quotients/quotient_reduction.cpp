#include "quotient_reduction.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "limbs/limb_arithmetic.hpp"
#include "long_gcds.hpp"
#include "number/rational_access.hpp"
#include "word_gcds.hpp"

namespace blossom {

namespace {

using limbs::Limb;

/// A number > 0 in limbs, the top one not 0. The initial value is 1, which takes no memory.
class Natural {
public:
    Natural() = default;
    explicit Natural(std::span<const Limb> limbs)
        : limbs_(limbs.begin(),
                 limbs.begin() + static_cast<std::ptrdiff_t>(limbs::used(limbs.data(), limbs.size()))) {
        if (limbs_.size() == 1 && limbs_[0] == 1) limbs_.clear();
    }

    bool is_one() const { return limbs_.empty(); }
    /// The limbs of a number other than 1.
    std::span<const Limb> span() const { return limbs_; }
    void multiply(std::span<const Limb> factor) {
        if (is_one()) {
            *this = Natural(factor);
            return;
        }
        std::vector<Limb> product(limbs_.size() + factor.size());
        limbs::multiply_any(product.data(), limbs_, factor);
        product.resize(limbs::used(product.data(), product.size()));
        limbs_ = std::move(product);
    }

private:
    std::vector<Limb> limbs_;
};

/// gcd(a, b) for a >= 0 and b > 0 whose top limbs are not 0.
Natural gcd(std::span<const Limb> a, std::span<const Limb> b) {
    const std::size_t a_size = limbs::used(a.data(), a.size());
    if (a_size == 0) return Natural(b);
    if (b.size() == 1) {
        const Limb common = gcd_of_words(limbs::remainder(a.data(), a_size, b[0]), b[0]);
        return Natural({&common, 1});
    }
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

/// A tree of the factors of a denominator: words and numbers of a few limbs in groups at the leaves, and in
/// each inner node the product of its two children.
class FactorTree {
public:
    FactorTree(std::span<const std::uint64_t> words, std::span<const Integer> longer) {
        std::size_t all = words.size();
        for (const Integer& factor : longer) all += limbs::size_of(factor);
        const std::size_t most_leaves = words.size() / most_words + longer.size() + 1;
        limbs_.resize((all + 1) * static_cast<std::size_t>(std::bit_width(most_leaves) + 2));
        nodes_.reserve(2 * most_leaves);
        short_factors_.reserve(longer.size());
        Limb* next = limbs_.data();
        for (; !words.empty(); words = words.subspan(nodes_.back().words.size()))
            next = add_leaf(words.first(std::min(words.size(), most_words)), next);
        for (const Integer& factor : longer) {
            const std::size_t size = limbs::size_of(factor);
            limbs::write_magnitude(factor, next, size);
            if (size <= LongGcds::most_limbs && LongGcds::are_quick()) {
                short_factors_.emplace_back(next, size);
            } else {
                nodes_.push_back({{next, size}, {}, {}, {}});
            }
            next += size;
        }
        for (std::span<const Factor> left = short_factors_; !left.empty();
             left = left.subspan(nodes_.back().factors.size()))
            next = add_leaf(left.first(std::min(left.size(), LongGcds::most_factors)), next);
        for (std::size_t i = 0; i + 1 < nodes_.size(); i += 2) {
            const Factor a = nodes_[i].product;
            const Factor b = nodes_[i + 1].product;
            limbs::multiply_any(next, a, b);
            nodes_.push_back({{next, limbs::used(next, a.size() + b.size())}, {}, {}, i});
            next += nodes_.back().product.size();
        }
    }

    std::span<const Limb> product() const { return nodes_.back().product; }

    /// prod gcd(numerator, factor)
    Natural common(std::span<const Limb> numerator) {
        const auto depth = static_cast<std::size_t>(std::bit_width(nodes_.size()));
        room_.resize(numerator.size() + depth * product().size() + 1);
        Natural result;
        gather(numerator, nodes_.back(), room_.data(), result);
        return result;
    }

private:
    using Factor = std::span<const Limb>;

    struct Node {
        Factor product;
        std::span<const std::uint64_t> words;  ///< the factors of a leaf of words
        std::span<const Factor> factors;       ///< the factors of a leaf of longer numbers
        std::optional<std::size_t> below;      ///< the first of the two children, unless this is a leaf
    };

    /// If a product is fewer limbs shorter than the remainder, no division is made on the way down.
    static constexpr std::size_t least_taken_off = 4;
    static constexpr std::size_t most_words = 16;

    Limb* add_leaf(std::span<const std::uint64_t> words, Limb* next) {
        std::size_t size = 0;
        for (const std::uint64_t word : words) limbs::multiply_by_word(next, size, word);
        nodes_.push_back({{next, size}, words, {}, {}});
        return next + size;
    }
    Limb* add_leaf(std::span<const Factor> factors, Limb* next) {
        std::vector<Limb> product(factors[0].begin(), factors[0].end());
        for (const Factor& factor : factors.subspan(1)) {
            limbs::multiply_any(next, product, factor);
            product.assign(next, next + limbs::used(next, product.size() + factor.size()));
        }
        std::ranges::copy(product, next);
        nodes_.push_back({{next, product.size()}, {}, factors, {}});
        return next + product.size();
    }

    void gather(std::span<const Limb> number, const Node& node, Limb* room, Natural& result) {
        const std::size_t size = node.product.size();
        if (number.size() >= size + least_taken_off) {
            limbs::divide(room + size, room, number.data(), number.size(), node.product.data(), size);
            number = {room, limbs::used(room, size)};
            room += size;
            if (number.empty()) return result.multiply(node.product);
        }
        const auto multiply = [&](std::span<const Limb> common) {
            if (common.size() != 1 || common[0] != 1) result.multiply(common);
        };
        if (node.below) {
            gather(number, nodes_[*node.below], room, result);
            gather(number, nodes_[*node.below + 1], room, result);
        } else if (!node.words.empty()) {
            Limb common[most_words];
            gcds_with_words(number, node.words, common);
            for (const Limb& factor : std::span(common).first(node.words.size())) multiply({&factor, 1});
        } else if (!node.factors.empty()) {
            LongGcds(number, node.factors).visit(multiply);
        } else if (const Natural common = gcd(number, node.product); !common.is_one()) {
            result.multiply(common.span());
        }
    }

    std::vector<Limb> limbs_;
    std::vector<Limb> room_;
    std::vector<Factor> short_factors_;
    std::vector<Node> nodes_;
};

Integer quotient(std::span<const Limb> dividend, std::span<const Limb> divisor, bool negative) {
    std::vector<Limb> room(dividend.size() + 1);
    Limb* const result = room.data();
    std::vector<Limb> rest(divisor.size());
    limbs::divide(result, rest.data(), dividend.data(), dividend.size(), divisor.data(), divisor.size());
    return IntegerAccess::from_magnitude(std::span(result, dividend.size() - divisor.size() + 1), negative);
}

}  // namespace

Rational reduced_quotient(std::span<const Limb> numerator, bool negative, std::span<const Limb> words,
                          std::span<const Integer> longer) {
    const std::span<const Limb> top = numerator.first(limbs::used(numerator.data(), numerator.size()));
    if (top.empty()) return 0;
    if (words.empty() && longer.empty()) return IntegerAccess::from_magnitude(top, negative);
    FactorTree tree(words, longer);
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
