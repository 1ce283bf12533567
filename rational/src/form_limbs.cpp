#include "form_limbs.hpp"

#include <blossom/rational/rational_vector.hpp>

#include <algorithm>

#include "backend.hpp"
#include "wide.hpp"

namespace blossom {

namespace {

/// to += from * factor or to -= from * factor, in two's complement of the length of `to`.
void add_multiple(std::span<std::uint64_t> to, std::span<const std::uint64_t> from, std::uint64_t factor,
                  bool subtract) {
    const std::size_t size = std::min(from.size(), to.size());
    std::uint64_t carry = 0;
    if (subtract) {
        for (std::size_t i = 0; i < size; ++i) {
            const Wide product = Wide{from[i]} * factor + carry;
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
        const Wide sum = Wide{from[i]} * factor + to[i] + carry;
        to[i] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
    }
    for (std::size_t i = size; carry != 0 && i < to.size(); ++i) {
        to[i] += carry;
        carry = static_cast<std::uint64_t>(to[i] < carry);
    }
}

void multiply(std::span<std::uint64_t> number, std::uint64_t factor) {
    Wide carry = 0;
    for (std::uint64_t& word : number) {
        carry += Wide{word} * factor;
        word = static_cast<std::uint64_t>(carry);
        carry >>= 64;
    }
}

/// Makes a number in two's complement its magnitude; whether it was negative.
bool take_magnitude(std::span<std::uint64_t> number) {
    if (static_cast<std::int64_t>(number.back()) >= 0) return false;
    bool carry = true;
    for (std::uint64_t& word : number) {
        word = ~word + static_cast<std::uint64_t>(carry);
        carry = carry && word == 0;
    }
    return true;
}

/// base^0, ..., base^count, all of which are words.
template <std::size_t size>
void set_powers(std::uint64_t (&powers)[size], std::uint64_t base, std::size_t count) {
    powers[0] = 1;
    for (std::size_t i = 0; i < count; ++i) powers[i + 1] = powers[i] * base;
}

}  // namespace

FormLimbs::FormLimbs(std::span<const Integer> coefficients)
    : width_(greatest_bit_length(coefficients) / 64 + 1) {
    magnitudes_.resize(width_ * coefficients.size());
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        const std::span<std::uint64_t> words = std::span(magnitudes_).subspan(k * width_, width_);
        IntegerAccess::to_twos_complement(abs(coefficients[k]), words);
        negative_.push_back(coefficients[k].sign() < 0);
        std::size_t size = width_;
        while (size > 0 && words[size - 1] == 0) --size;
        sizes_.push_back(size);
    }
}

bool FormLimbs::evaluate(std::int64_t u, std::int64_t v, std::span<std::uint64_t> value) const {
    const std::size_t count = sizes_.size();
    const std::uint64_t top = magnitude(u);
    const auto bottom = static_cast<std::uint64_t>(v);
    constexpr std::size_t most_block = 32;
    const auto bits = static_cast<std::size_t>(std::bit_width(top | bottom));
    const std::size_t block = std::clamp(std::size_t{63} / bits, std::size_t{1}, most_block);
    std::uint64_t powers_of_top[most_block + 1];
    std::uint64_t powers_of_bottom[most_block + 1];
    set_powers(powers_of_top, top, block);
    set_powers(powers_of_bottom, bottom, block);

    // The sum of a block is a word longer than its coefficients.
    std::uint64_t words[most_coefficient_words + 2];
    const std::span<std::uint64_t> sum = std::span(words).first(width_ + 1);
    std::uint64_t power_words[most_words];
    const std::span<std::uint64_t> power = std::span(power_words).first(value.size());
    std::ranges::fill(power, 0);
    power[0] = 1;
    std::size_t power_size = 1;
    std::ranges::fill(value, 0);

    for (std::size_t end = count; end > 0;) {
        // The blocks end at the lowest coefficient, and the first may be shorter.
        const std::size_t size = end % block == 0 ? block : end % block;
        const std::size_t begin = end - size;
        std::ranges::fill(sum, 0);
        for (std::size_t k = begin; k < end; ++k) {
            const bool subtract = negative_[k] != (u < 0 && k % 2 == 1);
            add_multiple(sum, std::span(magnitudes_).subspan(k * width_, sizes_[k]),
                         powers_of_top[k - begin] * powers_of_bottom[end - 1 - k], subtract);
        }
        if (end != count) multiply(value, powers_of_top[size]);
        const bool negative = take_magnitude(sum);
        for (std::size_t i = 0; i < sum.size() && i < value.size(); ++i) {
            if (sum[i] != 0) add_multiple(value.subspan(i), power.first(power_size), sum[i], negative);
        }
        multiply(power.first(std::min(power_size + 1, power.size())), powers_of_bottom[size]);
        if (power_size < power.size() && power[power_size] != 0) ++power_size;
        end = begin;
    }
    return take_magnitude(value);
}

}  // namespace blossom
