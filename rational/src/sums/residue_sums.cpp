#include "residue_sums.hpp"

#include <blossom/rational/resource_budget.hpp>
#include <blossom/rational/row_recurrences.hpp>

#include "factor_blocks.hpp"
#include "residues/residue_numbers.hpp"
#include "residues/residue_products.hpp"

namespace blossom {

namespace {

using residues::Digits;
using residues::groups_for;
using residues::integer_with;
using residues::Moduli;
using residues::moduli;
using residues::montgomery_powers;
using residues::Numbers;
using residues::operations;
using residues::ResidueVector;

/// This many factors are multiplied in integers before residues are taken.
constexpr std::size_t integer_block = 4;

/// Appends the product of two blocks whose coefficients are below 2^63.
void append_product(FactorBlocks& blocks, std::span<const std::int64_t> a, std::span<const std::int64_t> b) {
    for (std::size_t k = 0; k < a.size() + b.size() - 1; ++k) {
        Int128 sum = 0;
        for (std::size_t j = k < a.size() ? 0 : k - a.size() + 1; j < b.size() && j <= k; ++j)
            sum += Int128{a[k - j]} * b[j];
        blocks.coefficients.push_back(sum);
    }
    blocks.sizes.push_back(a.size() + b.size() - 1);
}

void append(FactorBlocks& blocks, std::span<const WordFactor> factors) {
    constexpr std::int64_t one[] = {1};
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
}

void append(FactorBlocks& blocks, std::span<const IntegerFactor> factors) {
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
}

template <class R>
FactorBlocks leaf_by_leaf(std::span<const LinearFactor<R>> factors) {
    FactorBlocks blocks;
    blocks.coefficients.reserve(factors.size() + factors.size() / 2, 3);
    blocks.plan = residues::transform_plan(factors.size());
    if (!blocks.plan) {
        append(blocks, factors);
        return blocks;
    }
    blocks.leaves.push_back(0);
    for (std::size_t i = 0; i < blocks.plan.leaves(); ++i) {
        const std::size_t begin = blocks.plan.begin(i, factors.size());
        append(blocks, factors.subspan(begin, blocks.plan.begin(i + 1, factors.size()) - begin));
        blocks.leaves.push_back(blocks.sizes.size());
    }
    return blocks;
}

/// The length in memory of a row of `size` numbers.
std::size_t width(const Moduli& group, std::size_t size) {
    const residues::TransformPlan plan = residues::transform_plan(size - 1);
    return plan && has_transform(group, plan.size()) ? plan.size() : size;
}

/// Writes the residues, or their transforms, of rows of `count` numbers.
void read_rows(const Numbers& numbers, std::size_t count, const Moduli& group, ResidueVector* rows) {
    const std::size_t width_of_row = width(group, count);
    if (width_of_row == count) return numbers.residues(group, rows);
    const residues::Buffer residues(numbers.size());
    numbers.residues(group, residues.data());
    const residues::Roots roots(group, width_of_row);
    for (std::size_t k = 0; k < numbers.size(); k += count, rows += width_of_row)
        transform_numbers(group, roots, residues.data() + k, count, width_of_row, rows);
}

/// The product of all factors in the form that matches `ResidueRows`.
class FactorProduct {
public:
    explicit FactorProduct(const FactorBlocks& factors)
        : factors_(factors),
          tree_(factors.sizes),
          coefficients_(factors.coefficients.size()),
          leaves_(factors.plan ? factors.plan.size() : 0),
          values_(factors.plan ? factors.plan.size() : 0) {}

    /// The number of coefficients.
    std::size_t size() const { return tree_.product_size(); }

    const ResidueVector* of(const Moduli& group) {
        const Digits& digits = factors_.coefficients;
        digits.residues(group, montgomery_powers(group, digits.most_digits()).data(), coefficients_.data());
        const residues::TransformPlan& plan = factors_.plan;
        if (width(group, size()) == size()) return tree_.product(group, coefficients_.data());
        for (std::size_t i = 0; i < plan.leaves(); ++i) {
            ResidueVector* const leaf = leaves_.data() + i * plan.leaf;
            const std::size_t begin = factors_.leaves[i];
            const std::size_t end = factors_.leaves[i + 1];
            tree_.product(group, coefficients_.data(), begin, end, leaf);
            std::fill(leaf + tree_.product_size(begin, end), leaf + plan.leaf, ResidueVector{});
        }
        product_values(group, residues::Roots(group, plan.size()), plan, leaves_.data(), values_.data());
        return values_.data();
    }

private:
    const FactorBlocks& factors_;
    residues::ProductTree tree_;
    residues::Buffer coefficients_;
    residues::Buffer leaves_;
    residues::Buffer values_;
};

}  // namespace

FactorBlocks blocks_of(std::span<const WordFactor> factors) { return leaf_by_leaf(factors); }
FactorBlocks blocks_of(std::span<const IntegerFactor> factors) { return leaf_by_leaf(factors); }

ResidueCache::Rows ResidueCache::of(const RationalVector& numbers, std::size_t size,
                                    std::size_t groups) const {
    {
        const std::lock_guard lock(mutex_);
        if (kept_ && kept_->begins.size() > groups) return kept_;
    }
    auto made = std::make_shared<ResidueRows>();
    for (std::size_t g = 0; g < groups; ++g)
        made->begins.push_back(made->begins.back() + numbers.size() / size * width(moduli(g), size));
    if (made->begins.back() * sizeof(ResidueVector) > most_kept) return nullptr;
    const Numbers all(numbers.numerators(), numbers.denominator(), groups);
    made->vectors.resize(made->begins.back());
    for (std::size_t g = 0; g < groups; ++g)
        read_rows(all, size, moduli(g), made->vectors.data() + made->begins[g]);
    const std::lock_guard lock(mutex_);
    kept_ = made;
    return made;
}

std::vector<Integer> residue_sums(const RationalVector& numbers, const ResidueCache* cache,
                                  const FactorBlocks& factors, std::size_t bits, std::size_t first_row,
                                  std::size_t count) {
    constexpr std::uint64_t words_per_coefficient = 64;
    const std::size_t groups = groups_for(bits);
    FactorProduct product(factors);
    const std::size_t size = product.size();
    const ResidueCache::Rows prepared = cache ? cache->of(numbers, size, groups) : nullptr;
    const Numbers asked =
        prepared ? Numbers()
                 : Numbers(std::span(numbers.numerators()).subspan(first_row * size, count * size),
                           numbers.denominator(), groups);
    const residues::Buffer unprepared(prepared ? 0 : count * std::max(size, factors.plan.size()));
    std::vector<ResidueVector> sums(count * groups);
    for (std::size_t g = 0; g < groups; ++g) {
        const Moduli& group = moduli(g);
        const std::size_t length = width(group, size);
        spend_work(words_per_coefficient * (count + 1) * length);
        const ResidueVector* values = product.of(group);
        const ResidueVector* rows = unprepared.data();
        if (prepared) {
            rows = prepared->vectors.data() + prepared->begins[g] + first_row * length;
        } else {
            read_rows(asked, size, group, unprepared.data());
        }
        for (std::size_t j = 0; j < count; ++j)
            sums[j * groups + g] = operations().dot(group, values, rows + j * length, length);
    }
    std::vector<Integer> integers;
    integers.reserve(count);
    for (std::size_t j = 0; j < count; ++j)
        integers.push_back(integer_with(std::span(sums).subspan(j * groups, groups)));
    return integers;
}

}  // namespace blossom
