#pragma once

#include <cstdint>
#include <random>

namespace blossom::testing {

/// A seeded random stream that is the same on every platform: the standard defines the engine, and the
/// distributions are defined here.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t word() { return engine_(); }

    /// Uniform in 0..bound-1, without the bias of a plain remainder.
    std::uint64_t below(std::uint64_t bound) {
        const std::uint64_t surplus = (0 - bound) % bound;
        std::uint64_t choice = word();
        while (choice < surplus) choice = word();
        return choice % bound;
    }

    /// Uniform in low..high.
    std::int64_t between(std::int64_t low, std::int64_t high) {
        const std::uint64_t width = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) +
                                         (width == 0 ? word() : below(width)));
    }

    bool one_in(std::uint64_t n) { return below(n) == 0; }

private:
    std::mt19937_64 engine_;
};

}  // namespace blossom::testing
