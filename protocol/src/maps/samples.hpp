#pragma once

#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <map>
#include <optional>

namespace blossom::protocol {

/// Values of an unknown polynomial of a given degree, which the inverse formula determines.
struct Samples {
    std::size_t degree;
    Interval interval;
    std::map<Rational, Coordinates> values;

    std::size_t dimension() const { return values.begin()->second.size(); }
};

inline std::optional<Interval> own_interval(const Samples& samples) { return samples.interval; }

}  // namespace blossom::protocol
