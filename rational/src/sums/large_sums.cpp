#include "large_sums.hpp"

#include <blossom/rational/resource_budget.hpp>

#include "limbs/limb_arithmetic.hpp"

namespace blossom {

namespace {

using limbs::Limb;

bool is_negative(const Limb* number, std::size_t size) { return number[size - 1] >> 63 != 0; }

/// product[0..m + size) in two's complement = a number in two's complement times a magnitude; m >= 1.
void multiply_signed(Limb* product, const Limb* number, std::size_t size, const Limb* factor, std::size_t m) {
    if (m > size) {
        limbs::multiply(product, factor, m, number, size);
    } else {
        limbs::multiply(product, number, size, factor, m);
    }
    // The limbs of a negative number, read as unsigned, are the number plus 2^(64 size).
    if (is_negative(number, size)) limbs::subtract(product + size, product + size, factor, m);
}

/// number += change modulo 2^(64 size), for a change of -1, 0 or 1.
void step(Limb* number, std::size_t size, int change) {
    if (change == 0) return;
    for (std::size_t i = 0; i < size; ++i) {
        if (change > 0 ? ++number[i] != 0 : number[i]-- != 0) return;
    }
}

}  // namespace

FactorRow::FactorRow(std::span<const IntegerFactor> factors, std::size_t bits)
    : stride_(bits / 64 + 1), words_(stride_ * (factors.size() + 1)) {
    words_[0] = 1;
    std::size_t next_bits = 1;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        next_bits += bits_of(factors[i]);
        multiply(factors[i], i, std::min(stride_, next_bits / 64 + 1));
    }
}

void FactorRow::multiply(const IntegerFactor& factor, std::size_t degree, std::size_t next_width) {
    const std::size_t sizes[] = {limbs::size_of(factor.constant), limbs::size_of(factor.slope)};
    weights_.resize(sizes[0] + sizes[1]);
    limbs::write_magnitude(factor.constant, weights_.data(), sizes[0]);
    limbs::write_magnitude(factor.slope, weights_.data() + sizes[0], sizes[1]);
    const Weight own{weights_.data(), sizes[0], factor.constant.sign() < 0};
    const Weight neighbours{weights_.data() + sizes[0], sizes[1], factor.slope.sign() < 0};
    const Weight none{nullptr, 0, false};
    spend_work(degree * words_of_product(next_width, sizes[0] + sizes[1]));
    room_.resize(2 * (width_ + std::max({sizes[0], sizes[1], next_width})));
    combine(degree + 1, none, neighbours, next_width);
    for (std::size_t k = degree; k > 0; --k) combine(k, own, neighbours, next_width);
    combine(0, own, none, next_width);
    width_ = next_width;
}

void FactorRow::weighted(const Limb* entry, const Weight& weight, std::size_t width, Limb* to) {
    multiply_signed(to, entry, width_, weight.limbs, weight.size);
    const std::size_t size = width_ + weight.size;
    if (size < width) std::fill(to + size, to + width, is_negative(to, size) ? ~Limb{0} : 0);
}

void FactorRow::combine(std::size_t k, const Weight& own, const Weight& neighbours, std::size_t width) {
    Limb* const first = room_.data();
    Limb* const second = first + room_.size() / 2;
    Limb* const result = entry(k);
    if (own.size == 0 || neighbours.size == 0) {
        const Weight& weight = own.size == 0 ? neighbours : own;
        weighted(own.size == 0 ? entry(k - 1) : result, weight, width, first);
        std::copy_n(first, width, result);
        if (weight.negative) limbs::negate(result, width);
        return;
    }
    weighted(result, own, width, first);
    weighted(entry(k - 1), neighbours, width, second);
    if (own.negative == neighbours.negative) {
        limbs::add(result, first, second, width);
        if (own.negative) limbs::negate(result, width);
    } else if (own.negative) {
        limbs::subtract(result, second, first, width);
    } else {
        limbs::subtract(result, first, second, width);
    }
}

void large_dot(std::span<const Integer> numbers, const LimbView& entries, std::span<std::uint64_t> sum) {
    std::size_t longest = 1;
    for (const Integer& number : numbers) longest = std::max(longest, limbs::size_of(number));
    std::vector<Limb> room(2 * longest + entries.width);
    Limb* const magnitude = room.data();
    Limb* const product = magnitude + longest;
    std::ranges::fill(sum, 0);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (numbers[k].is_zero()) continue;
        const std::size_t size = limbs::size_of(numbers[k]);
        spend_work(words_of_product(entries.width, size));
        limbs::write_magnitude(numbers[k], magnitude, size);
        multiply_signed(product, entries.words + k * entries.stride, entries.width, magnitude, size);
        const std::size_t all = entries.width + size;
        const std::size_t common = std::min(all, sum.size());
        const int extension = is_negative(product, all) ? 1 : 0;
        if (numbers[k].sign() > 0) {
            const Limb carry = limbs::add(sum.data(), sum.data(), product, common);
            step(sum.data() + common, sum.size() - common, static_cast<int>(carry) - extension);
        } else {
            const Limb borrow = limbs::subtract(sum.data(), sum.data(), product, common);
            step(sum.data() + common, sum.size() - common, extension - static_cast<int>(borrow));
        }
    }
}

}  // namespace blossom
