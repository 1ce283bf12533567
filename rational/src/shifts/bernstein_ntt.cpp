#include "bernstein_ntt.hpp"

#include <blossom/rational/bernstein_kernel.hpp>
#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <bit>

#include "residues/chinese_remainder_batch.hpp"
#include "residues/residue_system.hpp"
#include "residues/taylor_shift_ntt.hpp"
#include "sums/fixed_width_rows.hpp"

namespace blossom {

namespace {

using residues::Buffer;
using residues::ChineseRemainderBatch;
using residues::Digits;
using residues::Moduli;
using residues::operations;
using residues::ResidueVector;
using residues::ShiftTables;

/// As many numbers as there are coefficients, of at most `bits` bits each. `transform(tables, numbers, room)`
/// turns the residues of the coefficients into those of the numbers, with scratch memory for tables.size()
/// residue vectors.
template <class Transform>
std::optional<std::vector<Integer>> in_residues(std::span<const Integer> coefficients, std::size_t bits,
                                                const Transform& transform) {
    const std::size_t count = coefficients.size();
    const std::size_t size = std::bit_ceil(2 * count);
    if (size > std::size_t{1} << operations().root_order) return std::nullopt;
    const auto combination = ChineseRemainderBatch::for_bits(bits);
    if (!combination) return std::nullopt;
    Digits digits;
    digits.reserve(count, 2);
    for (const Integer& coefficient : coefficients) digits.push_back(coefficient);
    const std::size_t stride = (count + residues::lanes - 1) / residues::lanes * residues::lanes;
    constexpr std::uint64_t words_per_number = 256;
    const Buffer numbers(combination->groups() * stride);
    const Buffer room(size);
    for (std::size_t g = 0; g < combination->groups(); ++g) {
        const Moduli& group = residues::moduli(g);
        if (!has_transform(group, size)) return std::nullopt;
        spend_work(words_per_number * size + residues::lanes * combination->groups() * count);
        ResidueVector* const row = numbers.data() + g * stride;
        digits.residues(group, plain_powers(group, digits.most_digits()).data(), row);
        transform(*ShiftTables::of_group(g, size), row, room.data());
    }
    return combination->integers(numbers.data(), stride, count);
}

/// Replaces c_k in `numbers` by m_j with sum_k c_k t^k = sum_j m_j (t - 1)^j.
void shift_by_one(const ShiftTables& tables, std::size_t count, ResidueVector* numbers, ResidueVector* room) {
    const Moduli& group = tables.moduli();
    operations().multiply_each(group, numbers, tables.factorials(), count, room);
    std::reverse(room, room + count);
    tables.multiply_by_exponential(room, count);
    std::reverse(room, room + count);
    operations().multiply_each(group, room, tables.inverse_factorials(), count, numbers);
}

/// numbers[k] *= first * ratio^k
void scale_by_powers(const Moduli& group, const ResidueVector& first, const ResidueVector& ratio,
                     std::size_t count, ResidueVector* numbers, ResidueVector* room) {
    ResidueVector power = ratio;
    room[0] = first;
    for (std::size_t done = 1; done < count; done *= 2) {
        operations().scale(group, room, power, std::min(done, count - done), room + done);
        operations().scale(group, &power, power, 1, &power);
    }
    operations().multiply_each(group, numbers, room, count, numbers);
}

/// The residue of a word below 2^49 in magnitude, times the radix.
ResidueVector residue_of(const Moduli& group, std::int64_t value) {
    ResidueVector result{};
    for (std::size_t i = 0; i < residues::lanes; ++i)
        result.lane[i] = static_cast<std::uint64_t>(value) + (value < 0 ? group.prime.lane[i] : 0);
    operations().scale(group, &result, group.square, 1, &result);
    return result;
}

ResidueVector product(const Moduli& group, const ResidueVector& a, const ResidueVector& b) {
    ResidueVector result{};
    operations().scale(group, &a, b, 1, &result);
    return result;
}

/// base^exponent; base and result are stored times the radix.
ResidueVector power(const Moduli& group, const ResidueVector& base, std::size_t exponent) {
    ResidueVector result = group.radix;
    ResidueVector square = base;
    for (; exponent != 0; exponent >>= 1) {
        if ((exponent & 1) != 0) result = product(group, result, square);
        square = product(group, square, square);
    }
    return result;
}

/// A line t = a + length s modulo the primes of a group, all numbers times the radix.
struct LineResidues {
    LineResidues(const Moduli& group, const WordQuotient& a, const WordQuotient& b)
        : denominator_of_a(residue_of(group, a.denominator)) {
        const bool from_zero = a.numerator == 0;
        const ResidueVector p = residue_of(group, from_zero ? 1 : a.numerator);
        const ResidueVector& q = denominator_of_a;
        const ResidueVector r = residue_of(group, b.numerator);
        const ResidueVector s = residue_of(group, b.denominator);
        const ResidueVector qs = product(group, q, s);
        const ResidueVector reciprocal = inverse(group, product(group, p, qs));  // 1/pqs
        const ResidueVector inverse_of_q = product(group, reciprocal, product(group, p, s));
        const ResidueVector qr = product(group, q, r);
        const ResidueVector ps = product(group, p, s);
        start = product(group, p, inverse_of_q);
        ResidueVector determinant = qr;
        if (!from_zero) operations().subtract(group, &qr, &ps, 1, &determinant);
        // (r/s - p/q) / (p/q), or r/s
        slope = product(group, product(group, determinant, q), reciprocal);
        if (from_zero) slope = product(group, slope, inverse_of_q);
        ratio = product(group, s, inverse_of_q);
    }

    ResidueVector denominator_of_a;
    ResidueVector start{};  ///< a; meaningless if a is 0
    ResidueVector slope{};  ///< length / a, or length if a is 0
    ResidueVector ratio{};  ///< the denominator of b divided by that of a
};

}  // namespace

namespace residues {

std::optional<std::vector<Integer>> shifted_by_one(std::span<const Integer> coefficients, std::size_t bits) {
    return in_residues(coefficients, bits,
                       [&](const ShiftTables& tables, ResidueVector* numbers, ResidueVector* room) {
                           shift_by_one(tables, coefficients.size(), numbers, room);
                       });
}

}  // namespace residues

// With t = a + (b - a) s and F = sum_j m_j (t - a)^j, F is sum_j m_j (b - a)^j s^j (s + (1 - s))^(n-j): the
// coefficients of F in s and 1 - s, in reverse order, are those of the reversed polynomial in s shifted by
// one.
std::optional<std::vector<Integer>> form_on_line(std::span<const Integer> coefficients, const WordQuotient& a,
                                                 const WordQuotient& b) {
    const std::size_t count = coefficients.size();
    if (count < 2) return std::nullopt;
    // |w_k| is at most the value at x = y = 1 of the form whose coefficients are the magnitudes.
    fixed_width::BitBound bound(greatest_bit_length(coefficients) +
                                static_cast<std::size_t>(std::bit_width(count)));
    const std::uint64_t growth = std::max(magnitude(a.numerator) + magnitude(b.numerator),
                                          magnitude(a.denominator) + magnitude(b.denominator));
    for (std::size_t i = 1; i < count; ++i) bound.multiply(growth);
    return in_residues(coefficients, bound.bits(),
                       [&](const ShiftTables& tables, ResidueVector* numbers, ResidueVector* room) {
                           const Moduli& group = tables.moduli();
                           const LineResidues line(group, a, b);
                           if (a.numerator != 0) {
                               scale_by_powers(group, group.radix, line.start, count, numbers, room);
                               shift_by_one(tables, count, numbers, room);
                           }
                           scale_by_powers(group, group.radix, line.slope, count, numbers, room);
                           std::reverse(numbers, numbers + count);
                           shift_by_one(tables, count, numbers, room);
                           std::reverse(numbers, numbers + count);
                           scale_by_powers(group, power(group, line.denominator_of_a, count - 1), line.ratio,
                                           count, numbers, room);
                       });
}

}  // namespace blossom
