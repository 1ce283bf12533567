#include "residue_sums.hpp"

#include <blossom/rational/row_recurrences.hpp>

#include "factor_blocks.hpp"
#include "residue_products.hpp"

namespace blossom {

namespace {

using residues::Digits;
using residues::groups_for;
using residues::integer_with;
using residues::Moduli;
using residues::moduli;
using residues::montgomery_powers;
using residues::Octet;
using residues::operations;
using residues::plain_powers;

/// As many factors are multiplied out in integers before residues are taken.
constexpr std::size_t integer_block = 4;

/// The product of the coefficients of two blocks of less than 2^63 each.
void append_product(FactorBlocks& blocks, std::span<const std::int64_t> a, std::span<const std::int64_t> b) {
    for (std::size_t k = 0; k < a.size() + b.size() - 1; ++k) {
        SignedWide sum = 0;
        for (std::size_t j = k < a.size() ? 0 : k - a.size() + 1; j < b.size() && j <= k; ++j)
            sum += SignedWide{a[k - j]} * b[j];
        blocks.coefficients.push_back(sum);
    }
    blocks.sizes.push_back(a.size() + b.size() - 1);
}

Digits digits_of(std::span<const Integer> numbers) {
    Digits digits;
    digits.reserve(numbers.size(), 1);
    for (const Integer& number : numbers) digits.push_back(number);
    return digits;
}

}  // namespace

FactorBlocks blocks_of(std::span<const WordFactor> factors) {
    constexpr std::int64_t one[] = {1};
    FactorBlocks blocks;
    blocks.coefficients.reserve(factors.size() + factors.size() / 2, 3);
    FactorBlock first;
    FactorBlock second;
    while (!factors.empty()) {
        first.fill(factors);
        factors = factors.subspan(first.degree());
        std::span<const std::int64_t> further = one;
        if (first.fits() && !factors.empty()) {
            second.fill(factors);
            if (second.fits()) {
                further = second.coefficients();
                factors = factors.subspan(second.degree());
            }
        }
        append_product(blocks, first.coefficients(), further);
    }
    return blocks;
}

FactorBlocks blocks_of(std::span<const IntegerFactor> factors) {
    FactorBlocks blocks;
    while (!factors.empty()) {
        const auto block = factors.first(std::min(factors.size(), integer_block));
        factors = factors.subspan(block.size());
        std::vector<Integer> constants;
        std::vector<Integer> slopes;
        for (const IntegerFactor& factor : block) {
            constants.push_back(factor.constant);
            slopes.push_back(factor.slope);
        }
        for (const Integer& coefficient :
             product_of_linear_factors(std::span<const Integer>(constants), std::span<const Integer>(slopes)))
            blocks.coefficients.push_back(coefficient);
        blocks.sizes.push_back(block.size() + 1);
    }
    return blocks;
}

ResidueCache::Residues ResidueCache::of(std::span<const Integer> numbers, std::size_t groups) const {
    const std::size_t size = groups * numbers.size();
    {
        const std::lock_guard lock(mutex_);
        if (kept_ && kept_->size() >= size) return kept_;
    }
    if (size * sizeof(Octet) > most_kept) return nullptr;
    const Digits digits = digits_of(numbers);
    auto made = std::make_shared<std::vector<Octet>>(size);
    for (std::size_t g = 0; g < groups; ++g) {
        digits.residues(moduli(g), plain_powers(moduli(g), digits.most_digits()).data(),
                        made->data() + g * numbers.size());
    }
    const std::lock_guard lock(mutex_);
    kept_ = made;
    return made;
}

std::vector<Integer> residue_sums(std::span<const Integer> numbers, const ResidueCache* cache,
                                  const FactorBlocks& factors, std::size_t bits, std::size_t first_row,
                                  std::size_t count) {
    const std::size_t groups = groups_for(bits);
    residues::ProductTree tree(factors.sizes);
    const std::size_t size = tree.product_size();
    const auto asked = numbers.subspan(first_row * size, count * size);
    const ResidueCache::Residues prepared = cache ? cache->of(numbers, groups) : nullptr;
    const Digits digits = prepared ? Digits() : digits_of(asked);
    const residues::Buffer unprepared(prepared ? 0 : asked.size());
    const residues::Buffer coefficients(factors.coefficients.size());
    std::vector<Octet> sums(count * groups);
    for (std::size_t g = 0; g < groups; ++g) {
        const Moduli& group = moduli(g);
        factors.coefficients.residues(
            group, montgomery_powers(group, factors.coefficients.most_digits()).data(), coefficients.data());
        const Octet* product = tree.product(group, coefficients.data());
        const Octet* rows = unprepared.data();
        if (prepared) {
            rows = prepared->data() + g * numbers.size() + first_row * size;
        } else {
            digits.residues(group, plain_powers(group, digits.most_digits()).data(), unprepared.data());
        }
        for (std::size_t j = 0; j < count; ++j)
            sums[j * groups + g] = operations().dot(group, product, rows + j * size, size);
    }
    std::vector<Integer> integers;
    integers.reserve(count);
    for (std::size_t j = 0; j < count; ++j)
        integers.push_back(integer_with(std::span(sums).subspan(j * groups, groups)));
    return integers;
}

}  // namespace blossom
