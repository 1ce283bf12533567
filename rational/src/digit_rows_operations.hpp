#pragma once

// The operations written once for any number of lanes.

#include "digit_rows.hpp"

namespace blossom::digit_rows {

/// Level::Vector: words in lanes, by the extension that GCC and Clang have for them.
template <class Level>
struct OperationsOf {
    using Vector = typename Level::Vector;
    static constexpr std::size_t lanes = sizeof(Vector) / sizeof(std::int64_t);

    /// { last lane of `below`, all but the last lane of `own` }
    static Vector moved_up(const Vector& below, const Vector& own) {
        Vector result = below;
        result[0] = below[lanes - 1];
        for (std::size_t i = 1; i < lanes; ++i) result[i] = own[i - 1];
        return result;
    }

    static void multiply(std::int64_t* plane, std::size_t size, const std::int64_t* added,
                         std::int64_t* carries, bool top) {
        auto* entries = reinterpret_cast<Vector*>(plane);
        const auto* constants = reinterpret_cast<const Vector*>(added);
        auto* below = reinterpret_cast<Vector*>(carries);
        Vector digit_mask;
        Vector carry_mask;
        for (std::size_t i = 0; i < lanes; ++i) {
            const bool keeps = top && i + 1 == lanes;
            digit_mask[i] = keeps ? -1 : (std::int64_t{1} << digit_bits) - 1;
            carry_mask[i] = keeps ? 0 : -1;
        }
        // previous[i]: the entry to the left after i levels
        Vector previous[levels];
        for (std::size_t i = 0; i < levels; ++i) previous[i] = constants[i];
        for (std::size_t j = 0; j < size + levels; ++j) {
            Vector entry = j < size ? entries[j] : Vector{};
#pragma GCC unroll 14
            for (std::size_t i = 0; i < levels; ++i) {
                const Vector sum = entry + previous[i];
                previous[i] = entry;
                entry = sum;
            }
            const Vector carry = (entry >> digit_bits) & carry_mask;
            entries[j] = (entry & digit_mask) + moved_up(below[j], carry);
            below[j] = carry;
        }
    }

    static constexpr Operations table{lanes, multiply};
};

}  // namespace blossom::digit_rows
