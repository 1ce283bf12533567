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
    /// The greatest k such that all derivatives of order at most k are equal there, -1 if the values are not;
    /// none if the maps are the same.
    std::optional<std::ptrdiff_t> order;
    /// The first blossom value that differs: for order k with k + 1 arguments that are not there.
    std::optional<DifferenceAt<Arguments>> first_difference;

    bool is_infinite() const { return !order; }

    friend bool operator==(const ContactAt&, const ContactAt&) = default;
};

}  // namespace blossom
