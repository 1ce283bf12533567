#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/resource_budget.hpp>
#include <blossom/rational/taylor_shift.hpp>

#include <bit>
#include <cstring>
#include <new>

#include "bernstein_ntt.hpp"
#include "number/backend.hpp"
#include "number/uint128.hpp"
#include "vectors/vector_table.hpp"

namespace blossom {

namespace {

using taylor_lanes::digit_bits;
using taylor_lanes::levels;

constexpr std::int64_t digit_mask = (std::int64_t{1} << digit_bits) - 1;
/// For fewer coefficients, the conversion to vectors takes longer than they save.
constexpr std::size_t least_coefficients = 12;
/// Up to this many coefficients, pairs of words are faster if they suffice.
constexpr std::size_t most_coefficients_in_words = 64;
/// From this many coefficients on, transforms are faster, for results of at most this many bits per
/// coefficient.
constexpr std::size_t least_coefficients_in_residues = 513;
constexpr std::size_t most_bits_a_coefficient = 4;

const taylor_lanes::Operations& row_operations() { return *vectors::table().taylor; }

/// The planes for numbers of at most `bits` bits, in whole groups of four digits; the top digit stays far
/// below a word.
std::size_t planes_for(std::size_t bits) {
    const std::size_t digits_of_plane = row_operations().lanes;
    const std::size_t planes_of_group = digits_of_plane < 4 ? 4 / digits_of_plane : 1;
    return ((bits + 2) / (digit_bits * digits_of_plane * planes_of_group) + 1) * planes_of_group;
}

/// Zeroed memory for vectors.
class DigitRoom {
public:
    explicit DigitRoom(std::size_t digits)
        : digits_(static_cast<std::int64_t*>(::operator new(digits * sizeof(std::int64_t), alignment))) {
        std::fill_n(digits_, digits, 0);
    }
    DigitRoom(DigitRoom&&) = delete;
    DigitRoom(const DigitRoom&) = delete;
    DigitRoom& operator=(DigitRoom&&) = delete;
    DigitRoom& operator=(const DigitRoom&) = delete;
    ~DigitRoom() { ::operator delete(digits_, alignment); }

    std::int64_t* digits() const { return digits_; }

private:
    static constexpr std::align_val_t alignment{64};

    std::int64_t* digits_;
};

/// Numbers in planes of digits, in memory that the caller owns.
class DigitRow {
public:
    DigitRow(std::int64_t* digits, std::size_t numbers)
        : shift_(std::countr_zero(row_operations().lanes)), numbers_(numbers), digits_(digits) {}

    std::int64_t* plane(std::size_t plane, std::size_t number = 0) const {
        return digits_ + ((plane * numbers_ + number) << shift_);
    }

    void set(std::size_t number, const Integer& value) {
        if (const auto word = value.to_int64()) {
            std::int64_t* const to = plane(0, number);
            to[0] = *word & digit_mask;
            to[1] = *word >> digit_bits;
            return;
        }
        const std::size_t bits = value.bit_length();
        words_.resize(words_of_group * (bits / bits_of_group + 1));
        IntegerAccess::to_twos_complement(value, words_);
        const std::uint64_t* from = words_.data();
        for (std::size_t g = 0; g <= bits / bits_of_group; ++g, from += words_of_group) {
            std::int64_t* const low = pair(2 * g, number);
            std::int64_t* const high = pair(2 * g + 1, number);
            low[0] = static_cast<std::int64_t>(from[0]) & digit_mask;
            low[1] = static_cast<std::int64_t>(from[0] >> 48 | from[1] << 16) & digit_mask;
            high[0] = static_cast<std::int64_t>(from[1] >> 32 | from[2] << 32) & digit_mask;
            high[1] = static_cast<std::int64_t>(from[2] >> 16);
        }
        // The top digit has the sign.
        std::int64_t& greatest = pair(2 * (bits / bits_of_group) + 1, number)[1];
        greatest = static_cast<std::int64_t>(from[-1]) >> 16;
    }

    /// Number `number`, of at most `bits` bits.
    Integer number(std::size_t number, std::size_t bits) {
        words_.resize(words_of_group * (bits / bits_of_group + 1));
        std::uint64_t* to = words_.data();
        std::int64_t carry = 0;
        const auto next = [&](std::int64_t digit) {
            const std::int64_t sum = digit + carry;
            carry = sum >> digit_bits;
            return static_cast<std::uint64_t>(sum & digit_mask);
        };
        for (std::size_t g = 0; g <= bits / bits_of_group; ++g, to += words_of_group) {
            const std::int64_t* const low = pair(2 * g, number);
            const std::int64_t* const high = pair(2 * g + 1, number);
            const std::uint64_t digits[] = {next(low[0]), next(low[1]), next(high[0]), next(high[1])};
            to[0] = digits[0] | digits[1] << 48;
            to[1] = digits[1] >> 16 | digits[2] << 32;
            to[2] = digits[2] >> 32 | digits[3] << 16;
        }
        return IntegerAccess::from_twos_complement(words_);
    }

private:
    // The bits of four digits, which are three words.
    static constexpr std::size_t bits_of_group = 192;
    static constexpr std::size_t words_of_group = 3;

    /// Digits 2 i and 2 i + 1: vectors have an even number of lanes.
    std::int64_t* pair(std::size_t i, std::size_t number) const {
        const std::size_t whole = 2 * i >> shift_;
        return plane(whole, number) + (2 * i - (whole << shift_));
    }

    int shift_;  ///< the number of lanes is a power of two
    std::size_t numbers_;
    std::int64_t* digits_;
    std::vector<std::uint64_t> words_;
};

/// Multiplies by X + 1 once per coefficient, and adds one coefficient after each multiplication, highest
/// first.
class HornersRule {
public:
    explicit HornersRule(std::span<const Integer> coefficients)
        : size_(coefficients.size()),
          bits_(greatest_bit_length(coefficients)),
          blocks_((size_ + levels - 1) / levels),
          digits_of_row_(blocks_ * levels * planes_after(blocks_) * row_operations().lanes),
          room_(2 * digits_of_row_ + tile * row_operations().lanes),
          row_(room_.digits(), blocks_ * levels),
          left_(room_.digits() + digits_of_row_, blocks_ * levels),
          carries_(room_.digits() + 2 * digits_of_row_, tile) {
        for (std::size_t k = 0; k < size_; ++k) left_.set(blocks_ * levels - 1 - k, coefficients[k]);
        for (std::size_t block = 0; block < blocks_; block += blocks_a_pass)
            multiply(block, std::min(blocks_, block + blocks_a_pass));
    }

    Integer coefficient(std::size_t k) { return row_.number(k, bits_ + size_); }

private:
    // Entries that stay in the nearest cache while several blocks of levels process them.
    static constexpr std::size_t tile = 4 * levels;
    static constexpr std::size_t blocks_a_pass = 8;

    std::size_t planes_after(std::size_t blocks) const { return planes_for(bits_ + blocks * levels); }

    void multiply(std::size_t first_block, std::size_t last_block) {
        for (std::size_t begin = 0; begin < last_block * levels; begin += tile) {
            for (std::size_t block = first_block; block < last_block; ++block) {
                const std::size_t end = std::min(begin + tile, (block + 1) * levels);
                if (begin >= end) continue;
                const std::size_t planes = planes_after(block + 1);
                spend_work(planes * (end - begin) * levels);
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
    std::size_t digits_of_row_;
    DigitRoom room_;
    DigitRow row_;
    // The entries to the left of the others, initially the coefficients to add, after zeros that fill the
    // first block.
    DigitRow left_;
    DigitRow carries_;
};

/// The shift in 128 bits, which must have room for 2^(n - 1) times the largest of n coefficients.
std::vector<Integer> shifted_in_pairs_of_words(std::span<const Integer> coefficients) {
    std::uint64_t words[2];
    Int128 in_place[most_coefficients_in_words];
    const std::span<Int128> row = std::span(in_place).first(coefficients.size());
    for (std::size_t k = 0; k < row.size(); ++k) {
        IntegerAccess::to_twos_complement(coefficients[k], words);
        std::memcpy(&row[k], words, sizeof words);
    }
    row_recurrences::shift_by_one(row);
    std::vector<Integer> result;
    result.reserve(row.size());
    for (const Int128& value : row) {
        std::memcpy(words, &value, sizeof words);
        result.push_back(IntegerAccess::from_twos_complement(words));
    }
    return result;
}

}  // namespace

std::vector<Integer> shifted_by_one(std::span<const Integer> coefficients) {
    if (coefficients.empty()) return {};
    const std::size_t bits = greatest_bit_length(coefficients) + coefficients.size() - 1;
    if (coefficients.size() <= most_coefficients_in_words && bits < 128)
        return shifted_in_pairs_of_words(coefficients);
    if (coefficients.size() < least_coefficients)
        return row_recurrences::shifted_by_one<Integer>(coefficients);
    if (coefficients.size() >= least_coefficients_in_residues &&
        bits <= most_bits_a_coefficient * coefficients.size()) {
        if (auto shifted = residues::shifted_by_one(coefficients, bits)) return std::move(*shifted);
    }
    HornersRule rule(coefficients);
    std::vector<Integer> result;
    result.reserve(coefficients.size());
    for (std::size_t k = 0; k < coefficients.size(); ++k) result.push_back(rule.coefficient(k));
    return result;
}

}  // namespace blossom
