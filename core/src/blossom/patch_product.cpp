#include "patch_product.hpp"

namespace blossom {

namespace {

NetShape sum_of(const NetShape& a, const NetShape& b, const Limits& limits) {
    std::vector<SimplexFactor> factors;
    factors.reserve(a.factors());
    for (std::size_t f = 0; f < a.factors(); ++f)
        factors.push_back({a[f].dimension, a[f].degree + b[f].degree});
    return NetShape(std::move(factors), limits);
}

}  // namespace

ProductTable::ProductTable(const NetShape& a, const NetShape& b, const Limits& limits)
    : shape_(sum_of(a, b, limits)) {
    require_product_within({a.size(), b.size()}, limits.numbers, "numbers",
                           "the number of products of coefficients");
    const auto of_a = net_indices(a);
    const auto of_b = net_indices(b);
    places_.reserve(of_a.size() * of_b.size());
    std::vector<MultiIndex> sum;
    for (const auto& left : of_a) {
        for (const auto& right : of_b) {
            sum = left;
            for (std::size_t f = 0; f < sum.size(); ++f) {
                for (std::size_t k = 0; k < sum[f].size(); ++k) sum[f][k] += right[f][k];
            }
            places_.push_back(shape_.position_of(sum));
        }
    }
}

std::vector<Integer> ProductTable::product(std::span<const Integer> a, std::span<const Integer> b) const {
    std::vector<Integer> result(shape_.size());
    std::size_t pair = 0;
    for (const Integer& left : a) {
        for (const Integer& right : b) result[places_[pair++]] += left * right;
    }
    return result;
}

}  // namespace blossom
