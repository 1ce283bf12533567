#pragma once

#include <blossom/core/maps/interval.hpp>

#include <optional>
#include <utility>

namespace blossom {

/// The numbers from `lower` to `upper`, where these are given.
struct ParameterRange {
    std::optional<Rational> lower;
    std::optional<Rational> upper;

    ParameterRange() = default;
    /// Ends in either order.
    ParameterRange(std::optional<Rational> from, std::optional<Rational> to)
        : lower(std::move(from)), upper(std::move(to)) {
        if (lower && upper && *upper < *lower) std::swap(lower, upper);
    }
    ParameterRange(const Interval& interval)  // NOLINT(google-explicit-constructor)
        : ParameterRange(interval.a(), interval.b()) {}

    friend bool operator==(const ParameterRange&, const ParameterRange&) = default;
};

}  // namespace blossom
