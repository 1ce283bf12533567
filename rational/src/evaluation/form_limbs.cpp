#include "form_limbs.hpp"

#include <blossom/rational/rational_vector.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include "limbs/limb_arithmetic.hpp"
#include "number/backend.hpp"
#include "number/uint128.hpp"

namespace blossom {

namespace {

/// to += from * factor or to -= from * factor, in two's complement with the length of `to`.
void add_multiple(std::span<std::uint64_t> to, std::span<const std::uint64_t> from, std::uint64_t factor,
                  bool subtract) {
    const std::size_t size = std::min(from.size(), to.size());
    std::uint64_t carry = 0;
    if (subtract) {
        for (std::size_t i = 0; i < size; ++i) {
            const UInt128 product = UInt128{from[i]} * factor + carry;
            const auto low = static_cast<std::uint64_t>(product);
            carry = static_cast<std::uint64_t>(product >> 64) + static_cast<std::uint64_t>(to[i] < low);
            to[i] -= low;
        }
        for (std::size_t i = size; carry != 0 && i < to.size(); ++i) {
            const std::uint64_t before = to[i];
            to[i] -= carry;
            carry = static_cast<std::uint64_t>(before < carry);
        }
        return;
    }
    for (std::size_t i = 0; i < size; ++i) {
        const UInt128 sum = UInt128{from[i]} * factor + to[i] + carry;
        to[i] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
    }
    for (std::size_t i = size; carry != 0 && i < to.size(); ++i) {
        to[i] += carry;
        carry = static_cast<std::uint64_t>(to[i] < carry);
    }
}

void multiply(std::span<std::uint64_t> number, std::uint64_t factor) {
    UInt128 carry = 0;
    for (std::uint64_t& word : number) {
        carry += UInt128{word} * factor;
        word = static_cast<std::uint64_t>(carry);
        carry >>= 64;
    }
}

constexpr unsigned part_bits = 62;
constexpr std::uint64_t part_mask = (std::uint64_t{1} << part_bits) - 1;
constexpr std::size_t most_parts = 64 * FormLimbs::most_coefficient_words / part_bits + 1;
/// The most bits of the products of powers, and the most products that are summed.
constexpr std::size_t most_weight_bits = 58;
constexpr std::size_t most_block = 16;

/// base^0, ..., base^count, all of which are words.
void set_powers(std::uint64_t (&powers)[most_block + 1], std::uint64_t base, std::size_t count) {
    powers[0] = 1;
    for (std::size_t i = 0; i < count; ++i) powers[i + 1] = powers[i] * base;
}

/// sums[i] = sum_k parts[k width + i] weights[k]
template <std::size_t width>
void add_parts(const std::int64_t* parts, std::span<const std::int64_t> weights, Int128* sums) {
    Int128 here[width] = {};
    for (const std::int64_t weight : weights) {
        for (std::size_t i = 0; i < width; ++i) here[i] += Int128{parts[i]} * weight;
        parts += width;
    }
    std::copy_n(here, width, sums);
}

/// One instance per width, from 1.
constexpr auto add_parts_of_width = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{&add_parts<i + 1>...};
}(std::make_index_sequence<most_parts>());

/// Writes the sum of the parts in two's complement to `words`, which has room for it.
void gather(std::span<const Int128> parts, std::span<std::uint64_t> words) {
    Int128 carry = 0;
    UInt128 gathered = 0;
    unsigned filled = 0;
    std::size_t next = 0;
    for (std::uint64_t& word : words) {
        while (filled < 64) {
            carry += next < parts.size() ? parts[next] : 0;
            ++next;
            gathered |= UInt128{static_cast<std::uint64_t>(carry) & part_mask} << filled;
            carry >>= part_bits;
            filled += part_bits;
        }
        word = static_cast<std::uint64_t>(gathered);
        gathered >>= 64;
        filled -= 64;
    }
}

}  // namespace

FormLimbs::FormLimbs(std::span<const Integer> coefficients)
    : bits_(greatest_bit_length(coefficients)), width_(bits_ / part_bits + 1) {
    parts_.reserve(width_ * coefficients.size());
    std::vector<std::uint64_t> words(bits_ / 64 + 2);
    for (const Integer& coefficient : coefficients) {
        IntegerAccess::to_twos_complement(abs(coefficient), words);
        for (std::size_t i = 0; i < width_; ++i) {
            const std::size_t bit = i * part_bits;
            const UInt128 pair =
                UInt128{bit / 64 + 1 < words.size() ? words[bit / 64 + 1] : 0} << 64 | words[bit / 64];
            const auto part =
                static_cast<std::int64_t>(static_cast<std::uint64_t>(pair >> (bit % 64)) & part_mask);
            parts_.push_back(coefficient.sign() < 0 ? -part : part);
        }
    }
}

bool FormLimbs::evaluate(std::int64_t u, std::int64_t v, std::span<std::uint64_t> value) const {
    const std::size_t count = parts_.size() / width_;
    const std::uint64_t top = magnitude(u);
    const auto bottom = static_cast<std::uint64_t>(v);
    const auto bits = static_cast<std::size_t>(std::bit_width(top | bottom));
    const std::size_t block = std::min({63 / bits, most_weight_bits / bits + 1, most_block});
    std::uint64_t powers_of_top[most_block + 1];
    std::uint64_t powers_of_bottom[most_block + 1];
    set_powers(powers_of_top, top, block);
    set_powers(powers_of_bottom, bottom, block);

    std::uint64_t sum_words[most_coefficient_words + 3];
    std::uint64_t power_words[most_words];
    power_words[0] = 1;
    std::size_t power_size = 1;
    std::size_t used = 0;  // the words in use so far
    for (std::size_t end = count; end > 0;) {
        // The first block may be shorter than the others; the last one ends at the lowest coefficient.
        const std::size_t size = end % block == 0 ? block : end % block;
        const std::size_t begin = end - size;
        std::int64_t weights[most_block];
        for (std::size_t k = begin; k < end; ++k) {
            const auto weight =
                static_cast<std::int64_t>(powers_of_top[k - begin] * powers_of_bottom[end - 1 - k]);
            weights[k - begin] = u < 0 && k % 2 == 1 ? -weight : weight;
        }
        Int128 part_sums[most_parts];
        add_parts_of_width[width_ - 1](parts_.data() + begin * width_, std::span(weights).first(size),
                                       part_sums);
        const std::size_t sum_bits =
            bits_ + bits * (size - 1) + static_cast<std::size_t>(std::bit_width(size));
        const std::span<std::uint64_t> sum = std::span(sum_words).first(sum_bits / 64 + 1);
        gather(std::span(part_sums).first(width_), sum);

        const std::size_t value_bits =
            bits_ + bits * (count - begin - 1) + static_cast<std::size_t>(std::bit_width(count - begin));
        const std::size_t size_now = std::min(value_bits / 64 + 1, value.size());
        const bool below_zero = used > 0 && static_cast<std::int64_t>(value[used - 1]) < 0;
        for (; used < size_now; ++used) value[used] = below_zero ? ~std::uint64_t{0} : 0;
        const std::span<std::uint64_t> now = value.first(used);
        if (end != count) multiply(now, powers_of_top[size]);
        const bool negative = limbs::take_magnitude(sum);
        for (std::size_t i = 0; i < sum.size() && i < used; ++i) {
            if (sum[i] != 0)
                add_multiple(now.subspan(i), std::span(power_words).first(power_size), sum[i], negative);
        }
        if (begin > 0) {
            if (power_size < most_words) power_words[power_size++] = 0;
            multiply(std::span(power_words).first(power_size), powers_of_bottom[size]);
            if (power_words[power_size - 1] == 0) --power_size;
        }
        end = begin;
    }
    for (const bool negative = static_cast<std::int64_t>(value[used - 1]) < 0; used < value.size(); ++used)
        value[used] = negative ? ~std::uint64_t{0} : 0;
    return limbs::take_magnitude(value);
}

}  // namespace blossom
