#pragma once

// Primes below 2^28 in lanes of 64 bits, for processors that multiply the lower 32 bits of each lane.

#include "residue_operations.hpp"

namespace blossom::residues {

/// Instructions provides Vector, of 64-bit lanes, and product(a, b), the products of the lower halves of the
/// lanes.
template <class Instructions>
struct Narrow {
    using Vector = typename Instructions::Vector;

    static constexpr std::size_t prime_bits = 28;
    static constexpr std::size_t radix_bits = 32;
    static constexpr std::size_t delta_bits = 22;
    static constexpr std::size_t root_order = 11;
    static constexpr std::size_t width = sizeof(Vector) / sizeof(std::uint64_t);
    static constexpr std::size_t parts = lanes / width;
    /// Products of residues below 2 p are below 2^58.
    static constexpr std::size_t most_summed = 64;
    static constexpr std::size_t coefficients_at_once = 6;
    static constexpr std::size_t values_at_once = 4;

    struct Sum {
        Vector value = {};
    };
    /// low + 2^32 high
    struct Total {
        Vector low = {};
        Vector high = {};
    };
    struct Constants {
        Constants(const Moduli& moduli, std::size_t part)
            : prime(load(moduli.prime, part)),
              twice(prime + prime),
              delta(load(moduli.delta, part)),
              inverse(load(moduli.inverse, part)) {}
        Vector prime, twice, delta, inverse;
    };

    static Vector load(const ResidueVector& from, std::size_t part) {
        Vector result;
        __builtin_memcpy(&result, from.lane + part * width, sizeof result);
        return result;
    }
    static void store(ResidueVector& to, std::size_t part, Vector value) {
        __builtin_memcpy(to.lane + part * width, &value, sizeof value);
    }
    static Vector broadcast(std::uint64_t value) { return Vector{} + value; }

    static void add_product(Sum& sum, Vector a, Vector b) { sum.value += Instructions::product(a, b); }
    static void collect(Total& total, const Sum& sum) {
        total.low += sum.value & low_32;
        total.high += sum.value >> 32;
    }
    /// The quotient is below 2^32 + p before it is folded.
    static Vector reduced(const Constants& constants, const Sum& sum) {
        return folded(constants, divided(constants, sum.value, sum.value >> 32));
    }
    /// The quotient of a sum of up to 4096 products is below 2^38 + p before it is folded.
    static Vector reduced(const Constants& constants, const Total& total) {
        const Vector quotient = divided(constants, total.low, total.high + (total.low >> 32));
        return folded(constants, folded(constants, quotient));
    }
    static Vector product(const Constants& constants, Vector a, Vector b) {
        const Vector value = Instructions::product(a, b);
        return divided(constants, value, value >> 32);
    }
    static Vector product_of_difference(const Constants& constants, Vector a, Vector b, Vector c) {
        return product(constants, a + constants.twice - b, c);
    }
    static Vector below_prime(const Constants& constants, Vector value) {
        return below(constants.prime, value);
    }
    static Vector sum(const Constants& constants, Vector a, Vector b) {
        return below(constants.twice, a + b);
    }
    static Vector difference(const Constants& constants, Vector a, Vector b) {
        return below(constants.twice, a + constants.twice - b);
    }
    static Vector horner_step(const Constants& constants, Vector value, Vector x, Vector coefficient) {
        return sum(constants, product(constants, value, x), coefficient);
    }

private:
    static constexpr std::uint64_t low_32 = 0xffff'ffff;
    static constexpr std::uint64_t low_28 = 0x0fff'ffff;

    /// value - bound if that is not negative, otherwise value.
    static Vector below(Vector bound, Vector value) {
        const Vector less = value - bound;
        const Vector borrowed = Vector{} - (less >> 63);
        return less + (borrowed & bound);
    }
    static Vector folded(const Constants& constants, Vector value) {
        return (value & low_28) + Instructions::product(value >> 28, constants.delta);
    }
    /// (low + 2^32 high - m p) / 2^32 + p with the multiple m that makes the lowest 32 bits zero: they
    /// cancel, and only upper halves remain.
    static Vector divided(const Constants& constants, Vector low, Vector high) {
        const Vector multiple = Instructions::product(low, constants.inverse);
        return high + constants.prime - (Instructions::product(multiple, constants.prime) >> 32);
    }
};

}  // namespace blossom::residues
