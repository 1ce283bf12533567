#include "residue_sums.hpp"

namespace blossom {

namespace {

using residues::Digits;
using residues::groups_for;
using residues::integer_with;
using residues::moduli;
using residues::Moduli;
using residues::montgomery_powers;
using residues::Octet;
using residues::operations;
using residues::plain_powers;

/// The coefficients of the product of the factors modulo the primes of one group, by a tree of products.
class ProductTree {
public:
    explicit ProductTree(const Digits& factors)
        : degree_(factors.size() / 2), factors_(factors), level_(2 * degree_ + 1), next_(2 * degree_ + 1) {}

    /// degree + 1 coefficients times 2^52.
    const Octet* coefficients(const Moduli& moduli) {
        read_factors(moduli);
        // Polynomials of degree `step`, but for the last one, lie one after the other.
        for (std::size_t done = 0; done < degree_; done += leaf) {
            operations().multiply_linear(moduli, level_.data() + 2 * done, std::min(leaf, degree_ - done),
                                         next_.data() + done / leaf * (leaf + 1));
        }
        std::swap(level_, next_);
        for (std::size_t step = leaf; step < degree_; step *= 2) {
            const Octet* from = level_.data();
            Octet* to = next_.data();
            for (std::size_t done = 0; done < degree_;) {
                const std::size_t first = std::min(step, degree_ - done);
                const std::size_t second = std::min(step, degree_ - done - first);
                if (second == 0) {
                    std::copy(from, from + first + 1, to);
                } else {
                    operations().multiply(moduli, from, first, from + first + 1, second, to);
                }
                from += first + 1 + (second == 0 ? 0 : second + 1);
                to += first + second + 1;
                done += first + second;
            }
            std::swap(level_, next_);
        }
        return level_.data();
    }

private:
    /// The degree from which on halves are multiplied.
    static constexpr std::size_t leaf = 8;

    void read_factors(const Moduli& moduli) {
        const std::vector<Octet> powers =
            montgomery_powers(moduli, std::max(std::size_t{2}, factors_.most_digits()));
        if (const auto* words = factors_.words()) {
            operations().residues_of_words(moduli, words->data(), words->size(), powers.data(),
                                           level_.data());
            return;
        }
        for (std::size_t i = 0; i < factors_.size(); ++i)
            level_[i] = factors_.residues(i, moduli, powers.data());
    }

    std::size_t degree_;
    const Digits& factors_;
    std::vector<Octet> level_;
    std::vector<Octet> next_;
};

}  // namespace

ResidueCache::Residues ResidueCache::of(std::span<const Integer> numbers, std::size_t groups) const {
    const std::size_t size = groups * numbers.size();
    {
        const std::lock_guard lock(mutex_);
        if (kept_ && kept_->size() >= size) return kept_;
    }
    Digits digits;
    for (const Integer& number : numbers) digits.push_back(number);
    auto made = std::make_shared<std::vector<Octet>>();
    made->reserve(size);
    for (std::size_t g = 0; g < groups; ++g) {
        const std::vector<Octet> powers = plain_powers(moduli(g), digits.most_digits());
        for (std::size_t k = 0; k < numbers.size(); ++k)
            made->push_back(digits.residues(k, moduli(g), powers.data()));
    }
    if (size * sizeof(Octet) <= most_kept) {
        const std::lock_guard lock(mutex_);
        kept_ = made;
    }
    return made;
}

std::vector<Integer> residue_sums(std::span<const Integer> numbers, const ResidueCache& cache,
                                  const Digits& factors, std::size_t bits, std::size_t first_row,
                                  std::size_t count) {
    const std::size_t groups = groups_for(bits);
    const std::size_t size = factors.size() / 2 + 1;
    const ResidueCache::Residues prepared = cache.of(numbers, groups);
    ProductTree tree(factors);
    std::vector<std::vector<Octet>> sums(count);
    for (std::size_t g = 0; g < groups; ++g) {
        const Moduli& group = moduli(g);
        const Octet* product = tree.coefficients(group);
        const Octet* rows = prepared->data() + g * numbers.size() + first_row * size;
        for (std::size_t j = 0; j < count; ++j)
            sums[j].push_back(operations().dot(group, product, rows + j * size, size));
    }
    std::vector<Integer> integers;
    integers.reserve(count);
    for (const auto& residues_of_sum : sums) integers.push_back(integer_with(residues_of_sum));
    return integers;
}

}  // namespace blossom
