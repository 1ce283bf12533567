#include <blossom/core/constructions/net_shape.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace blossom {

namespace {

/// C(degree + dimension, dimension) for a net in memory.
std::size_t count_of(std::size_t dimension, std::size_t degree) {
    std::size_t count = 1;
    for (std::size_t i = 1; i <= dimension; ++i) count = count * (degree + i) / i;
    return count;
}

/// Replaces `index` by the next index, and returns whether there is one.
bool advance(MultiIndex& index) {
    const std::size_t last = index.size() - 1;
    std::size_t i = last;
    while (i > 0 && index[i - 1] == 0) --i;
    if (i == 0) return false;
    const std::size_t rest = index[last];
    if (i < last) index[last] = 0;
    --index[i - 1];
    index[i] = rest + 1;
    return true;
}

}  // namespace

std::size_t multi_index_count(std::size_t dimension, std::size_t degree, const Limits& limits) {
    // The partial products are increasing binomials, so that the first one beyond the limit decides. Below
    // 2^32 the next product fits in a word.
    const std::size_t limit =
        std::min<std::size_t>(limits.numbers, std::numeric_limits<std::uint32_t>::max());
    const auto require = [&](std::size_t at_least) {
        require_within(at_least, limit, "numbers", "the number of points of a control net, at least");
    };
    std::size_t count = 1;
    for (std::size_t i = 1; i <= dimension && degree > 0; ++i) {
        require(i);
        require(degree + i);
        count = count * (degree + i) / i;
        require(count);
    }
    return count;
}

std::vector<MultiIndex> multi_indices(std::size_t dimension, std::size_t degree) {
    MultiIndex index(dimension + 1);
    index.front() = degree;
    std::vector<MultiIndex> all;
    do {
        all.push_back(index);
    } while (advance(index));
    return all;
}

// Before an index come, for every k, the indices that agree with it before k and have a greater entry at k:
// with m the sum of the entries behind k, the s - k entries behind have a sum of at most m - 1.
std::size_t position(std::span<const std::size_t> index) {
    std::size_t place = 0;
    std::size_t behind = 0;
    for (std::size_t k = index.size() - 1; k-- > 0;) {
        behind += index[k + 1];
        if (behind > 0) place += count_of(index.size() - 1 - k, behind - 1);
    }
    return place;
}

Integer multinomial(std::span<const std::size_t> index) {
    Integer product = 1;
    std::size_t total = 0;
    for (const std::size_t entry : index) {
        total += entry;
        product *= binomial(total, entry);
    }
    return product;
}

NetShape::NetShape(std::vector<SimplexFactor> factors, const Limits& limits) : factors_(std::move(factors)) {
    for (const SimplexFactor& factor : factors_) {
        require_within(factor.degree, limits.degree, "degree", "the formal degree");
        counts_.push_back(multi_index_count(factor.dimension, factor.degree, limits));
        require_product_within({size_, counts_.back()}, limits.numbers, "numbers",
                               "the number of points of a control net");
        size_ *= counts_.back();
    }
}

NetShape NetShape::simplex(Count dimension, Count degree, const Limits& limits) {
    return NetShape({{dimension, degree}}, limits);
}

NetShape NetShape::tensor(std::span<const std::size_t> degrees, const Limits& limits) {
    std::vector<SimplexFactor> factors;
    for (const std::size_t degree : degrees) factors.push_back({1, degree});
    return NetShape(std::move(factors), limits);
}

std::size_t NetShape::before(std::size_t factor) const {
    return std::accumulate(counts_.begin(), counts_.begin() + static_cast<std::ptrdiff_t>(factor),
                           std::size_t{1}, std::multiplies());
}

std::size_t NetShape::behind(std::size_t factor) const {
    return std::accumulate(counts_.begin() + static_cast<std::ptrdiff_t>(factor) + 1, counts_.end(),
                           std::size_t{1}, std::multiplies());
}

std::size_t NetShape::dimension() const {
    std::size_t sum = 0;
    for (const SimplexFactor& factor : factors_) sum += factor.dimension;
    return sum;
}

NetShape NetShape::with_degree(std::size_t factor, std::size_t degree, const Limits& limits) const {
    std::vector<SimplexFactor> factors = factors_;
    factors[factor].degree = degree;
    return NetShape(std::move(factors), limits);
}

std::size_t NetShape::position_of(std::span<const MultiIndex> indices) const {
    std::size_t place = 0;
    for (std::size_t f = 0; f < factors_.size(); ++f) place = place * counts_[f] + position(indices[f]);
    return place;
}

std::vector<Integer> multinomials(const NetShape& shape) {
    std::vector<Integer> products{1};
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        std::vector<Integer> longer;
        longer.reserve(products.size() * shape.count(f));
        const std::vector<Integer> own = multinomial_row(shape[f]);
        for (const Integer& product : products) {
            for (const Integer& factor : own) longer.push_back(product * factor);
        }
        products = std::move(longer);
    }
    return products;
}

// Adding e_i adds 1 to the sums behind every k < i, and therefore C(m + s - k - 1, s - k - 1) to the
// position.
std::vector<std::vector<MultiIndex>> net_indices(const NetShape& shape) {
    std::vector<std::vector<MultiIndex>> all{{}};
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        const std::vector<MultiIndex> own = multi_indices(shape[f].dimension, shape[f].degree);
        std::vector<std::vector<MultiIndex>> longer;
        for (const auto& indices : all) {
            for (const MultiIndex& index : own) {
                longer.push_back(indices);
                longer.back().push_back(index);
            }
        }
        all = std::move(longer);
    }
    return all;
}

std::vector<std::size_t> raised_positions(std::size_t dimension, std::size_t lower_degree) {
    std::vector<std::size_t> positions;
    MultiIndex index(dimension + 1);
    index.front() = lower_degree;
    std::size_t place = 0;
    do {
        std::size_t raised = place++;
        std::size_t behind = lower_degree;
        positions.push_back(raised);
        for (std::size_t k = 0; k < dimension; ++k) {
            behind -= index[k];
            raised += count_of(dimension - k - 1, behind);
            positions.push_back(raised);
        }
    } while (advance(index));
    return positions;
}

}  // namespace blossom
