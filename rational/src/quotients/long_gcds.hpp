#pragma once

// Greatest common divisors of one long number and several numbers of a few limbs.

#include <cstddef>
#include <cstdint>
#include <span>

#include "vectors/vector_table.hpp"

namespace blossom {

/// Several gcds at once, one per vector lane.
class LongGcds {
public:
    static constexpr std::size_t most_limbs = 5;
    static constexpr std::size_t most_factors = gcd_lanes::factor_count;

    /// Whether this processor has the instructions; an object can be constructed only then.
    static bool are_quick() { return vectors::table().gcds != nullptr; }

    /// gcd(number, factors[i]) for a number > 0 and at most 8 factors > 0 of at most 5 limbs each; the top
    /// limbs are not 0.
    LongGcds(std::span<const std::uint64_t> number, std::span<const std::span<const std::uint64_t>> factors);

    /// Calls visit(gcd) for each factor, in order.
    template <class Visit>
    void visit(const Visit& visit) const {
        std::uint64_t room[most_limbs];
        for (std::size_t lane = 0; lane < size_; ++lane) visit(value(lane, room));
    }

private:
    std::span<const std::uint64_t> value(std::size_t lane, std::uint64_t* room) const;

    gcd_lanes::Factors gcds_{};
    std::size_t twos_[most_factors] = {};
    std::size_t size_;
};

}  // namespace blossom
