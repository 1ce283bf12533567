#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/taylor_shift.hpp>

#include <new>

#include "backend.hpp"
#include "digit_rows.hpp"
#include "residue_system.hpp"

namespace blossom {

namespace {

using digit_rows::digit_bits;
using digit_rows::levels;

constexpr std::int64_t digit_mask = (std::int64_t{1} << digit_bits) - 1;
/// Below, what is written for the vectors takes longer than they save.
constexpr std::size_t least_coefficients = 12;

/// The level that the residues run on.
const digit_rows::Operations& row_operations() {
#if defined(BLOSSOM_AVX512_IFMA)
    if (&residues::operations() == &residues::ifma_operations) return digit_rows::avx512_operations;
#endif
    return digit_rows::portable_operations;
}

/// Numbers in planes of digits.
class DigitRow {
public:
    DigitRow(std::size_t numbers, std::size_t planes)
        : lanes_(row_operations().lanes),
          numbers_(numbers),
          planes_(planes),
          digits_(static_cast<std::int64_t*>(
              ::operator new(numbers * planes * lanes_ * sizeof(std::int64_t), alignment))) {
        std::fill_n(digits_, numbers * planes * lanes_, 0);
    }
    DigitRow(const DigitRow&) = delete;
    DigitRow& operator=(const DigitRow&) = delete;
    ~DigitRow() { ::operator delete(digits_, alignment); }

    std::size_t planes() const { return planes_; }
    std::int64_t* plane(std::size_t plane, std::size_t number = 0) const {
        return digits_ + (plane * numbers_ + number) * lanes_;
    }

    void set(std::size_t number, const Integer& value) {
        if (const auto word = value.to_int64()) {
            digit(number, 0) = *word & digit_mask;
            digit(number, 1) = *word >> digit_bits;
            return;
        }
        words_.resize(value.bit_length() / 64 + 2);
        IntegerAccess::to_twos_complement(value, words_);
        const std::size_t digits = (value.bit_length() + digit_bits) / digit_bits;
        for (std::size_t i = 0; i < digits; ++i) {
            const std::size_t bit = i * digit_bits;
            std::uint64_t bits = words_[bit / 64] >> (bit % 64);
            if (bit % 64 != 0) bits |= words_[bit / 64 + 1] << (64 - bit % 64);
            // The greatest digit has the sign.
            digit(number, i) =
                i + 1 < digits ? static_cast<std::int64_t>(bits) & digit_mask
                               : static_cast<std::int64_t>(bits << (64 - digit_bits)) >> (64 - digit_bits);
        }
    }

    /// With at most `bits` bits.
    Integer number(std::size_t number, std::size_t bits) {
        words_.resize(bits / 64 + 1);
        const std::size_t most_digits = planes_ * lanes_;
        std::uint64_t gathered = 0;
        unsigned filled = 0;
        std::int64_t carry = 0;
        std::size_t i = 0;
        for (std::uint64_t& word : words_) {
            while (filled < 64) {
                const std::int64_t sum = carry + (i < most_digits ? digit(number, i) : 0);
                ++i;
                carry = sum >> digit_bits;
                const auto next = static_cast<std::uint64_t>(sum & digit_mask);
                gathered |= next << filled;
                filled += digit_bits;
                rest_ = next;
            }
            word = gathered;
            filled -= 64;
            gathered = filled == 0 ? 0 : rest_ >> (digit_bits - filled);
        }
        return IntegerAccess::from_twos_complement(words_);
    }

private:
    static constexpr std::align_val_t alignment{64};

    std::int64_t& digit(std::size_t number, std::size_t i) { return plane(i / lanes_, number)[i % lanes_]; }

    std::size_t lanes_;
    std::size_t numbers_;
    std::size_t planes_;
    std::int64_t* digits_;
    std::vector<std::uint64_t> words_;
    std::uint64_t rest_ = 0;
};

/// Planes for numbers of at most `bits` bits: the greatest digit stays far below a word.
std::size_t planes_for(std::size_t bits) { return (bits + 2) / (digit_bits * row_operations().lanes) + 1; }

/// Multiplies by X + 1 as often as there are coefficients and adds one of them after each, highest first.
class HornersRule {
public:
    explicit HornersRule(std::span<const Integer> coefficients)
        : size_(coefficients.size()),
          bits_(greatest_bit_length(coefficients)),
          blocks_((size_ + levels - 1) / levels),
          row_(blocks_ * levels, planes_after(blocks_)),
          // At first what is added, which stands left of the entries; after zeros that fill the first block.
          left_(blocks_ * levels, row_.planes()),
          carries_(tile, 1) {
        for (std::size_t k = 0; k < size_; ++k) left_.set(blocks_ * levels - 1 - k, coefficients[k]);
        for (std::size_t block = 0; block < blocks_; block += blocks_a_pass)
            multiply(block, std::min(blocks_, block + blocks_a_pass));
    }

    Integer coefficient(std::size_t k) { return row_.number(k, bits_ + size_); }

private:
    // Entries that stay in the nearest cache while some blocks of levels run over them.
    static constexpr std::size_t tile = 4 * levels;
    static constexpr std::size_t blocks_a_pass = 8;

    std::size_t planes_after(std::size_t blocks) const { return planes_for(bits_ + blocks * levels); }

    void multiply(std::size_t first_block, std::size_t last_block) {
        for (std::size_t begin = 0; begin < last_block * levels; begin += tile) {
            for (std::size_t block = first_block; block < last_block; ++block) {
                const std::size_t end = std::min(begin + tile, (block + 1) * levels);
                if (begin >= end) continue;
                const std::size_t planes = planes_after(block + 1);
                std::fill_n(carries_.plane(0), (end - begin) * row_operations().lanes, 0);
                for (std::size_t p = 0; p < planes; ++p) {
                    row_operations().multiply(row_.plane(p, begin), end - begin,
                                              left_.plane(p, block * levels), carries_.plane(0),
                                              p + 1 == planes);
                }
            }
        }
    }

    std::size_t size_;
    std::size_t bits_;
    std::size_t blocks_;
    DigitRow row_;
    DigitRow left_;
    DigitRow carries_;
};

}  // namespace

std::vector<Integer> shifted_by_one(std::span<const Integer> coefficients) {
    if (coefficients.size() < least_coefficients)
        return row_recurrences::shifted_by_one<Integer>(coefficients);
    HornersRule rule(coefficients);
    std::vector<Integer> result;
    result.reserve(coefficients.size());
    for (std::size_t k = 0; k < coefficients.size(); ++k) result.push_back(rule.coefficient(k));
    return result;
}

}  // namespace blossom
