#pragma once

// The operations as templates over the number of lanes.

#include "taylor_lanes.hpp"

namespace blossom::taylor_lanes {

/// Level::Vector is a vector of words, by the extension of GCC and Clang.
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

    static void multiply(std::int64_t* entries, std::size_t count, std::int64_t* previous,
                         std::int64_t* carries, bool top) {
        auto* row = reinterpret_cast<Vector*>(entries);
        auto* left_of_row = reinterpret_cast<Vector*>(previous);
        auto* below = reinterpret_cast<Vector*>(carries);
        Vector digit_mask;
        Vector carry_mask;
        for (std::size_t i = 0; i < lanes; ++i) {
            const bool keeps = top && i + 1 == lanes;
            digit_mask[i] = keeps ? -1 : (std::int64_t{1} << digit_bits) - 1;
            carry_mask[i] = keeps ? 0 : -1;
        }
        const auto finish = [&](std::size_t j, const Vector& entry) {
            const Vector carry = (entry >> digit_bits) & carry_mask;
            row[j] = (entry & digit_mask) + moved_up(below[j], carry);
            below[j] = carry;
        };
        Vector kept[levels];
        std::size_t level = 0;
        for (Vector& one : kept) one = left_of_row[level++];
        for (std::size_t j = 0; j < count; j += 2) {
            Vector left = row[j];
            Vector right = row[j + 1];
#pragma GCC unroll 14
            // NOLINTNEXTLINE(modernize-loop-convert): the pragma needs a counting loop
            for (std::size_t i = 0; i < levels; ++i) {
                const Vector sum = left + kept[i];
                kept[i] = right;
                right += left;
                left = sum;
            }
            finish(j, left);
            finish(j + 1, right);
        }
        level = 0;
        for (const Vector& one : kept) left_of_row[level++] = one;
    }

    static constexpr Operations table{lanes, multiply};
};

}  // namespace blossom::taylor_lanes
