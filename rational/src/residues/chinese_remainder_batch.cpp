#include "chinese_remainder_batch.hpp"

#include <algorithm>

#include "limbs/limb_arithmetic.hpp"
#include "prime_field.hpp"
#include "residue_system.hpp"

namespace blossom::residues {

namespace {

/// The first `count` digits of a number, which has no others.
std::vector<std::uint64_t> digits_of(const Integer& number, std::size_t count) {
    constexpr std::size_t digit_bits = BatchTables::digit_bits;
    constexpr std::uint64_t mask = (std::uint64_t{1} << digit_bits) - 1;
    std::vector<std::uint64_t> words(limbs::size_of(number));
    limbs::write_magnitude(number, words.data(), words.size());
    std::vector<std::uint64_t> digits;
    digits.reserve(count);
    for (std::size_t i = 0; i < count; ++i) digits.push_back(limbs::bits_from(words, i * digit_bits) & mask);
    return digits;
}

}  // namespace

std::optional<ChineseRemainderBatch> ChineseRemainderBatch::for_bits(std::size_t bits) {
    constexpr std::size_t most_groups = BatchTables::most_primes / lanes;
    // The Chinese remainder theorem for batches takes a product twice as large as for one number.
    if (vectors::table().integers_of_residues == nullptr || bits > most_groups * lanes * 50)
        return std::nullopt;
    const std::size_t groups = groups_for(bits + 1);
    if (groups > most_groups) return std::nullopt;
    return ChineseRemainderBatch(groups);
}

ChineseRemainderBatch::ChineseRemainderBatch(std::size_t groups) {
    constexpr std::size_t step = BatchTables::digits_at_once;
    Integer product = 1;
    for (std::size_t g = 0; g < groups; ++g)
        for (const std::uint64_t prime : moduli(g).prime.lane) product *= prime;
    digits_ = (product.bit_length() + BatchTables::digit_bits - 1) / BatchTables::digit_bits;
    const std::size_t held = (digits_ + step - 1) / step * step;
    product_ = digits_of(product, held);
    const std::size_t primes = groups * lanes;
    cofactors_.resize(held * primes);
    for (std::size_t g = 0; g < groups; ++g) {
        const Moduli& group = moduli(g);
        ResidueVector& factor = factors_.emplace_back();
        for (std::size_t i = 0; i < lanes; ++i) {
            const PrimeField field(group.prime.lane[i]);
            const Integer cofactor = divide_exactly(product, field.prime());
            factor.lane[i] = field.product(field.inverse(field.of(cofactor)), group.radix.lane[i]);
            const std::vector<std::uint64_t> digits = digits_of(cofactor, held);
            for (std::size_t d = 0; d < held; ++d)
                cofactors_[(d / step * primes + g * lanes + i) * step + d % step] = digits[d];
            reciprocals_.push_back(static_cast<std::uint64_t>((UInt128{1} << 101) / field.prime()));
        }
    }
}

BatchTables ChineseRemainderBatch::tables() const {
    return {groups() * lanes,  digits_,         (digits_ * BatchTables::digit_bits + 63) / 64,
            cofactors_.data(), product_.data(), reciprocals_.data()};
}

std::vector<Integer> ChineseRemainderBatch::integers(ResidueVector* residues, std::size_t stride,
                                                     std::size_t count) const {
    for (std::size_t g = 0; g < groups(); ++g) {
        ResidueVector* const row = residues + g * stride;
        std::fill(row + count, row + stride, ResidueVector{});
        operations().scale(moduli(g), row, factors_[g], count, row);
        operations().reduce(moduli(g), row, count);
    }
    std::vector<Integer> numbers;
    numbers.reserve(count);
    const BatchTables tables = this->tables();
    const Buffer room(tables.primes + product_.size() + 2);
    const Buffer words(tables.words);
    std::vector<std::uint64_t> number(tables.words);
    for (std::size_t begin = 0; begin < count; begin += lanes) {
        vectors::table().integers_of_residues(tables, residues + begin, stride, room.data(), words.data());
        for (std::size_t i = 0; i < lanes && begin + i < count; ++i) {
            for (std::size_t w = 0; w < number.size(); ++w) number[w] = words.data()[w].lane[i];
            numbers.push_back(IntegerAccess::from_twos_complement(number));
        }
    }
    return numbers;
}

}  // namespace blossom::residues
