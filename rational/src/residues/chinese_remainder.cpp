// Integers from their residues, by the Chinese remainder theorem.

#include <algorithm>

#include <blossom/rational/resource_budget.hpp>
#include <deque>
#include <iterator>
#include <mutex>

#include "limbs/limb_arithmetic.hpp"
#include "modular_words.hpp"
#include "residue_system.hpp"

namespace blossom::residues {

namespace {

using modular::power;
using modular::product;

/// The tables of the Chinese remainder theorem for a number of groups.
struct Tables {
    explicit Tables(std::size_t groups);

    Integer combined(std::span<const ResidueVector> residues) const;

    /// The sum over the primes p of one group of residue_p * (product of the group / p), in cofactor_words +
    /// 1 limbs.
    void group_sum(const ResidueVector& residues, std::size_t group, limbs::Limb* sum) const;

    std::size_t cofactor_words;           ///< the length of a product of seven primes
    std::vector<ResidueVector> inverses;  ///< of (product of all) / p, times the radix
    std::vector<std::uint64_t> cofactors;
    std::vector<std::vector<std::vector<limbs::Limb>>> levels;  ///< products of 1, 2, 4, ... groups
    std::vector<limbs::Limb> half;
};

std::vector<limbs::Limb> limbs_of(const Integer& value) {
    std::vector<limbs::Limb> result(limbs::size_of(value));
    limbs::write_magnitude(value, result.data(), result.size());
    return result;
}

/// product[0..size + b.size()) of a[0..size) and b.
void multiply(limbs::Limb* product, const limbs::Limb* a, std::size_t size,
              const std::vector<limbs::Limb>& b) {
    if (size < b.size()) {
        limbs::multiply(product, b.data(), b.size(), a, size);
    } else {
        limbs::multiply(product, a, size, b.data(), b.size());
    }
}

std::vector<limbs::Limb> product_of(const std::vector<limbs::Limb>& a, const std::vector<limbs::Limb>& b) {
    std::vector<limbs::Limb> result(a.size() + b.size());
    multiply(result.data(), a.data(), a.size(), b);
    result.resize(limbs::used(result.data(), result.size()));
    return result;
}

Tables::Tables(std::size_t groups) : cofactor_words((7 * operations().prime_bits + 63) / 64) {
    levels.emplace_back();
    Digits products;
    for (std::size_t g = 0; g < groups; ++g) {
        Integer group_product = 1;
        for (const std::uint64_t prime : moduli(g).prime.lane) group_product *= prime;
        for (const std::uint64_t prime : moduli(g).prime.lane) {
            cofactors.resize(cofactors.size() + cofactor_words);
            IntegerAccess::to_twos_complement(divide_exactly(group_product, prime),
                                              std::span(cofactors).last(cofactor_words));
        }
        products.push_back(group_product);
        levels[0].push_back(limbs_of(group_product));
    }
    std::vector<ResidueVector> others(groups);
    for (std::size_t g = 0; g < groups; ++g) {
        const Moduli& group = moduli(g);
        products.residues(group, montgomery_powers(group, products.most_digits()).data(), others.data());
        ResidueVector inverse = group.radix;
        for (std::size_t h = 0; h < groups; ++h)
            if (h != g) operations().scale(group, &inverse, others[h], 1, &inverse);
        for (std::size_t i = 0; i < lanes; ++i) {
            const std::uint64_t prime = group.prime.lane[i];
            std::uint64_t other = inverse.lane[i] % prime;
            for (std::size_t j = 0; j < lanes; ++j)
                if (j != i) other = product(other, group.prime.lane[j] % prime, prime);
            // 1 / (other * radix), times the square of the radix
            inverse.lane[i] = product(power(other, prime - 2, prime), group.square.lane[i], prime);
        }
        inverses.push_back(inverse);
    }
    while (levels.back().size() > 1) {
        const auto& below = levels.back();
        std::vector<std::vector<limbs::Limb>> level;
        for (std::size_t i = 0; i + 1 < below.size(); i += 2)
            level.push_back(product_of(below[i], below[i + 1]));
        if (below.size() % 2 == 1) level.push_back(below.back());
        levels.push_back(std::move(level));
    }
    half = levels.back()[0];
    limbs::shift_right(half.data(), half.size(), 1);
}

void Tables::group_sum(const ResidueVector& residues, std::size_t group, limbs::Limb* sum) const {
    std::fill(sum, sum + cofactor_words + 1, 0);
    const std::uint64_t* cofactor = cofactors.data() + group * lanes * cofactor_words;
    for (std::size_t i = 0; i < lanes; ++i, cofactor += cofactor_words) {
        UInt128 carry = 0;
        for (std::size_t w = 0; w < cofactor_words; ++w) {
            carry += UInt128{cofactor[w]} * residues.lane[i] + sum[w];
            sum[w] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        sum[cofactor_words] += static_cast<std::uint64_t>(carry);
    }
}

/// A sum has one limb more than the product of its groups, because it is less than this product times twice
/// the number of primes.
Integer Tables::combined(std::span<const ResidueVector> residues) const {
    const std::vector<limbs::Limb>& all = levels.back()[0];
    // Each sum is stored at the place of its first group, in one half of the memory; products are stored in
    // the other half.
    const std::size_t place = levels[0][0].size() + 2;
    spend_work(4 * words_of_product(all.size(), all.size()));
    std::vector<limbs::Limb> room(3 * place * residues.size() + 8);
    limbs::Limb* const products = room.data() + place * residues.size();
    for (std::size_t g = 0; g < residues.size(); ++g) {
        limbs::Limb* const sum = room.data() + place * g;
        group_sum(operations().dot(moduli(g), &residues[g], &inverses[g], 1), g, sum);
        std::fill(sum + cofactor_words + 1, sum + place, 0);
    }
    std::size_t step = 1;
    for (const auto& factors : std::span(levels).first(levels.size() - 1)) {
        for (std::size_t i = 0; i + 1 < factors.size(); i += 2) {
            const auto& a = factors[i];
            const auto& b = factors[i + 1];
            limbs::Limb* const left = room.data() + place * step * i;
            const limbs::Limb* const right = left + place * step;
            const std::size_t size = a.size() + b.size() + 1;
            limbs::Limb* const other = products + size;
            multiply(products, left, a.size() + 1, b);
            multiply(other, right, b.size() + 1, a);
            limbs::add(left, products, other, size);
        }
        step *= 2;
    }
    limbs::Limb* const value = room.data();
    limbs::divide(products, value, value, all.size() + 1, all.data(), all.size());
    bool negative = false;
    if (std::ranges::lexicographical_compare(half.rbegin(), half.rend(),
                                             std::reverse_iterator(value + all.size()),
                                             std::reverse_iterator(value))) {
        negative = true;
        limbs::subtract(value, all.data(), value, all.size());
    }
    return IntegerAccess::from_magnitude(std::span(value, all.size()), negative);
}

std::shared_ptr<const Tables> tables(std::size_t groups) {
    constexpr std::size_t most_kept = 32;
    static std::mutex mutex;
    static std::deque<std::pair<std::size_t, std::shared_ptr<const Tables>>> kept;
    {
        const std::lock_guard lock(mutex);
        for (const auto& [size, found] : kept) {
            if (size == groups) return found;
        }
    }
    auto made = std::make_shared<const Tables>(groups);
    const std::lock_guard lock(mutex);
    kept.emplace_back(groups, made);
    if (kept.size() > most_kept) kept.pop_front();
    return made;
}

}  // namespace

Integer integer_with(std::span<const ResidueVector> residues) {
    return tables(residues.size())->combined(residues);
}

}  // namespace blossom::residues
