#pragma once

#include <blossom/core/maps/stated_value.hpp>

#include <span>
#include <utility>

namespace blossom {

/// Point k is multiple(k) times the value at arguments(k).
template <class Arguments, class Multiple>
std::vector<StatedValue> stated_points(std::string_view name, std::span<const Coordinates> points,
                                       const Arguments& arguments, const Multiple& multiple) {
    std::vector<StatedValue> stated;
    stated.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
        stated.push_back({name, k, arguments(k), multiple(k), points[k]});
    return stated;
}

/// n - k copies of `first` and k of `second`.
inline std::vector<Argument> two_arguments(std::size_t n, std::size_t k, const Argument& first,
                                           const Argument& second) {
    return with_copies(with_copies({}, n - k, first), k, second);
}

}  // namespace blossom
