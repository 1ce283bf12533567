#pragma once

#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <optional>

namespace blossom {

/// Arguments at which two blossoms have different values.
template <class Arguments>
struct DifferenceAt {
    Arguments arguments;
    Coordinates left;
    Coordinates right;

    friend bool operator==(const DifferenceAt&, const DifferenceAt&) = default;
};

/// How smoothly two polynomial maps meet at a parameter, or along a face.
template <class Arguments>
struct ContactAt {
    /// The greatest k such that all derivatives of order at most k are equal; -1 if the values differ,
    /// nullopt if the maps are equal.
    std::optional<std::ptrdiff_t> order;
    /// The first blossom value that differs: for order k, one with k + 1 arguments away from the parameter or
    /// face.
    std::optional<DifferenceAt<Arguments>> first_difference;

    bool is_infinite() const { return !order; }

    friend bool operator==(const ContactAt&, const ContactAt&) = default;
};

}  // namespace blossom
