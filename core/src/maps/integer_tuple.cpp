#include "integer_tuple.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <numeric>

namespace blossom {

namespace {

Tuple<Integer> scaled(const Coordinates& tuple, const Integer& scale) {
    Tuple<Integer> entries;
    entries.reserve(tuple.size());
    for (const Rational& entry : tuple) {
        entries.push_back(entry.denominator() == scale
                              ? entry.numerator()
                              : entry.numerator() * divide_exactly(scale, entry.denominator()));
    }
    return entries;
}

Integer least_denominator(std::span<const Coordinates> tuples, const Limits& limits) {
    Integer scale = 1;
    for (const Coordinates& tuple : tuples) {
        for (const Rational& entry : tuple) scale = lcm(scale, entry.denominator());
        require_result_bits(tuples.size() * (scale.bit_length() - 1), limits);
    }
    return scale;
}

}  // namespace

std::size_t IntegerTuple::bits() const {
    return std::max(greatest_bit_length(entries) + std::bit_width(entries.size()), scale.bit_length());
}

// The longest denominator is usually a multiple of all others, because the sum of barycentric coordinates is
// 1.
IntegerTuple cleared(const Coordinates& tuple) {
    Integer scale = std::ranges::max(tuple, {}, [](const Rational& entry) {
                        return entry.denominator().bit_length();
                    }).denominator();
    for (const Rational& entry : tuple) {
        const Integer& denominator = entry.denominator();
        if (denominator.is_one() || denominator == scale || (scale % denominator).is_zero()) continue;
        scale = lcm(scale, denominator);
    }
    Tuple<Integer> entries = scaled(tuple, scale);
    return {std::move(entries), std::move(scale)};
}

bool WordTuples::add(const Coordinates& tuple) {
    if (size_ + tuple.size() > most_entries || count_ == most_entries) return false;
    last_ = size_;
    std::int64_t scale = 1;
    for (const Rational& entry : tuple) {
        if (!entry.numerator().is_word() || !entry.denominator().is_word()) return false;
        const std::int64_t denominator = entry.denominator().word();
        if (denominator == scale || scale % denominator == 0) continue;
        if (__builtin_mul_overflow(denominator / std::gcd(denominator, scale), scale, &scale)) return false;
    }
    for (const Rational& entry : tuple) {
        const std::int64_t denominator = entry.denominator().word();
        const std::int64_t factor = denominator == scale ? 1 : scale / denominator;
        std::int64_t& word = entries_[size_++];
        if (__builtin_mul_overflow(entry.numerator().word(), factor, &word) ||
            word == std::numeric_limits<std::int64_t>::min())
            return false;
    }
    scales_[count_++] = scale;
    return true;
}

void IntegerTuples::add(const Coordinates& tuple, std::size_t times) {
    IntegerTuple cleared_tuple = cleared(tuple);
    bits_ += times * cleared_tuple.bits();
    last_ = entries_.size();
    std::ranges::move(cleared_tuple.entries, std::back_inserter(entries_));
    scales_.push_back(std::move(cleared_tuple.scale));
}

IntegerArguments cleared_one_by_one(const PatchArguments& arguments, std::size_t net_bits,
                                    const Limits& limits) {
    IntegerArguments result;
    for (const auto& list : arguments) {
        auto& tuples = result.tuples.emplace_back();
        for (const Coordinates& tuple : list) {
            IntegerTuple integers = cleared(tuple);
            result.bits += integers.bits();
            require_result_bits(net_bits + result.bits, limits);
            result.denominator *= integers.scale;
            tuples.push_back(std::move(integers.entries));
        }
    }
    return result;
}

IntegerArguments cleared_together(const PatchArguments& arguments, std::size_t net_bits,
                                  const Limits& limits) {
    IntegerArguments result;
    for (const auto& list : arguments) {
        const Integer scale = least_denominator(list, limits);
        auto& tuples = result.tuples.emplace_back();
        for (const Coordinates& tuple : list) {
            tuples.push_back(scaled(tuple, scale));
            result.bits += greatest_bit_length(tuples.back()) + std::bit_width(tuple.size() * list.size());
            require_result_bits(net_bits + result.bits, limits);
            result.denominator *= scale;
        }
    }
    return result;
}

std::size_t bits_of(const PointArray& points) { return greatest_bit_length(points.numbers().numerators()); }

Integer greatest_magnitude(const PointArray& points) {
    Integer greatest;
    for (const Integer& numerator : points.numbers().numerators()) {
        if (greatest < numerator) {
            greatest = numerator;
        } else if (greatest < -numerator) {
            greatest = -numerator;
        }
    }
    return greatest;
}

PointArray canonical_points(std::size_t dimension, std::vector<Integer> numerators,
                            const Integer& denominator) {
    PointArray points(dimension, RationalVector(std::move(numerators), denominator));
    points.make_canonical();
    return points;
}

PointArray canonical_points(const std::vector<std::vector<Integer>>& rows, const Integer& denominator) {
    std::vector<Integer> numerators;
    numerators.reserve(rows.size() * rows.front().size());
    for (const auto& row : rows) numerators.insert(numerators.end(), row.begin(), row.end());
    return canonical_points(rows.size(), std::move(numerators), denominator);
}

}  // namespace blossom
