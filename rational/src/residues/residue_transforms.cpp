#include "residue_transforms.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "residue_system.hpp"

namespace blossom::residues {

namespace {

/// With fewer factors, or if a transform is much longer than the product, other ways are faster (by
/// measurement).
constexpr std::size_t least_factors = 500;
constexpr std::size_t shortest_leaf = 32;

/// 1 / 2^k times the radix.
ResidueVector inverse_power_of_two(const Moduli& moduli, std::size_t k) {
    ResidueVector result{};
    for (std::size_t i = 0; i < lanes; ++i) {
        std::uint64_t value = moduli.radix.lane[i];
        for (std::size_t step = 0; step < k; ++step) {
            if (value % 2 == 1) value += moduli.prime.lane[i];
            value /= 2;
        }
        result.lane[i] = value;
    }
    return result;
}

}  // namespace

TransformPlan transform_plan(std::size_t factors) {
    if (factors < least_factors) return {};
    std::size_t size = std::bit_ceil(factors + 1);
    for (;; size *= 2) {
        for (std::size_t leaf = shortest_leaf; leaf <= most_product_terms; leaf *= 2) {
            const std::size_t leaves = size / leaf;
            if ((factors + leaves - 1) / leaves >= leaf) continue;
            if (factors * 8 < size * 5) return {};
            return {leaf, static_cast<std::size_t>(std::countr_zero(leaves))};
        }
    }
}

Roots::Roots(const Moduli& moduli, std::size_t size) : powers_(size) {
    const Operations& run = operations();
    ResidueVector* const powers = powers_.data();
    ResidueVector root = moduli.root;
    for (std::size_t order = std::size_t{1} << moduli.root_order; order > size; order /= 2)
        run.scale(moduli, &root, root, 1, &root);
    const std::size_t half = size / 2;
    powers[half] = moduli.radix;
    for (std::size_t done = 1; done < half; done *= 2) {
        run.scale(moduli, powers + half, root, done, powers + half + done);
        run.scale(moduli, &root, root, 1, &root);
    }
    run.reduce(moduli, powers + half, half);
    for (std::size_t i = half; i-- > 1;) powers[i] = powers[2 * i];
}

void transform_numbers(const Moduli& moduli, const Roots& roots, const ResidueVector* numbers,
                       std::size_t count, std::size_t size, ResidueVector* values) {
    // The transform with the inverse roots is the transform of the numbers in reverse order.
    values[0] = numbers[0];
    std::fill(values + 1, values + (size - count + 1), ResidueVector{});
    std::reverse_copy(numbers + 1, numbers + count, values + (size - count + 1));
    operations().transform(moduli, roots.data(), values, size);
    const auto k = static_cast<std::size_t>(std::countr_zero(size));
    operations().scale(moduli, values, inverse_power_of_two(moduli, k), size, values);
}

void product_values(const Moduli& moduli, const Roots& roots, const TransformPlan& plan,
                    ResidueVector* leaves, ResidueVector* values) {
    const Operations& run = operations();
    const Buffer room(plan.size());
    const Buffer twiddles(plan.size() / 2);
    // Each polynomial has `size` values; their products need twice as many. The last products go to `values`.
    std::size_t size = plan.leaf;
    ResidueVector* from = leaves;
    ResidueVector* to = plan.levels % 2 == 1 ? values : room.data();
    for (std::size_t count = plan.leaves(); count > 1; count /= 2, size *= 2) {
        const bool are_coefficients = size == plan.leaf;
        const auto k = static_cast<std::size_t>(std::countr_zero(size));
        const ResidueVector factor = are_coefficients ? moduli.radix : inverse_power_of_two(moduli, k);
        run.scale(moduli, roots.data() + size, factor, size, twiddles.data());
        for (std::size_t i = 0; i < count; i += 2) {
            ResidueVector* const left = from + i * size;
            ResidueVector* const right = left + size;
            ResidueVector* const first = to + i * size;
            ResidueVector* const second = first + size;
            if (are_coefficients) {
                run.multiply_each(moduli, left, twiddles.data(), size, first);
                run.multiply_each(moduli, right, twiddles.data(), size, second);
                run.transform(moduli, roots.data(), first, size);
                run.transform(moduli, roots.data(), second, size);
                run.multiply_each(moduli, first, second, size, second);
                run.transform(moduli, roots.data(), left, size);
                run.transform(moduli, roots.data(), right, size);
                run.multiply_each(moduli, left, right, size, first);
            } else {
                run.multiply_each(moduli, left, right, size, first);
                for (ResidueVector* const polynomial : {left, right}) {
                    run.inverse_transform(moduli, roots.data(), polynomial, size);
                    run.multiply_each(moduli, polynomial, twiddles.data(), size, polynomial);
                    run.transform(moduli, roots.data(), polynomial, size);
                }
                run.multiply_each(moduli, left, right, size, second);
            }
        }
        from = std::exchange(to, to == values ? room.data() : values);
    }
}

}  // namespace blossom::residues
