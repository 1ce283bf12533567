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
#if defined(BLOSSOM_AVX2)
    if (&residues::operations() == &residues::avx2_operations) return digit_rows::avx2_operations;
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
    DigitRow(DigitRow&&) = delete;
    DigitRow(const DigitRow&) = delete;
    DigitRow& operator=(DigitRow&&) = delete;
    DigitRow& operator=(const DigitRow&) = delete;
    ~DigitRow() { ::operator delete(digits_, alignment); }

    std::size_t planes() const { return planes_; }
    std::int64_t* plane(std::size_t plane, std::size_t number = 0) const {
        return digits_ + (plane * numbers_ + number) * lanes_;
    }

    void set(std::size_t number, const Integer& value) {
        if (const auto word = value.to_int64()) {
            plane(0, number)[0] = *word & digit_mask;
            plane(0, number)[1] = *word >> digit_bits;
            return;
        }
        constexpr std::size_t group = 4;  // digits in three words
        const std::size_t words = value.bit_length() / 64 + 1;
        const std::size_t groups = (words + 2) / 3;
        words_.resize(3 * groups);
        IntegerAccess::to_twos_complement(value, words_);
        line_.resize(std::max(group * groups, planes_ * lanes_));
        for (std::size_t g = 0; g < groups; ++g) {
            const std::uint64_t* from = words_.data() + 3 * g;
            std::int64_t* to = line_.data() + group * g;
            to[0] = static_cast<std::int64_t>(from[0]) & digit_mask;
            to[1] = static_cast<std::int64_t>(from[0] >> 48 | from[1] << 16) & digit_mask;
            to[2] = static_cast<std::int64_t>(from[1] >> 32 | from[2] << 32) & digit_mask;
            to[3] = static_cast<std::int64_t>(from[2] >> 16);
        }
        // The greatest digit has the sign.
        const std::size_t greatest = value.bit_length() / digit_bits;
        line_[greatest] = static_cast<std::int64_t>(static_cast<std::uint64_t>(line_[greatest]) << 16) >> 16;
        std::fill(line_.begin() + static_cast<std::ptrdiff_t>(greatest) + 1, line_.end(), 0);
        for (std::size_t p = 0; p <= greatest / lanes_; ++p)
            std::copy_n(line_.data() + p * lanes_, lanes_, plane(p, number));
    }

    /// With at most `bits` bits.
    Integer number(std::size_t number, std::size_t bits) {
        const std::size_t groups = bits / 192 + 1;
        line_.assign(std::max(4 * groups, planes_ * lanes_), 0);
        for (std::size_t p = 0; p < planes_; ++p)
            std::copy_n(plane(p, number), lanes_, line_.data() + p * lanes_);
        words_.resize(3 * groups);
        std::int64_t carry = 0;
        const auto next = [&](std::int64_t digit) {
            const std::int64_t sum = digit + carry;
            carry = sum >> digit_bits;
            return static_cast<std::uint64_t>(sum & digit_mask);
        };
        for (std::size_t g = 0; g < groups; ++g) {
            const std::int64_t* from = line_.data() + 4 * g;
            std::uint64_t* to = words_.data() + 3 * g;
            const std::uint64_t digits[] = {next(from[0]), next(from[1]), next(from[2]), next(from[3])};
            to[0] = digits[0] | digits[1] << 48;
            to[1] = digits[1] >> 16 | digits[2] << 32;
            to[2] = digits[2] >> 32 | digits[3] << 16;
        }
        return IntegerAccess::from_twos_complement(words_);
    }

private:
    static constexpr std::align_val_t alignment{64};

    std::size_t lanes_;
    std::size_t numbers_;
    std::size_t planes_;
    std::int64_t* digits_;
    std::vector<std::uint64_t> words_;
    std::vector<std::int64_t> line_;
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
