#include "frame.hpp"

#include <fmt/format.h>
#include <blossom/rational/double_conversion.hpp>

#include <algorithm>
#include <optional>

namespace blossom::protocol {

namespace {

constexpr std::size_t inner_width = 544;
constexpr std::size_t least_height = 200;
constexpr std::size_t greatest_height = 560;
constexpr std::size_t height_of_graphs = 360;

std::string pixels(const Rational& value) { return fmt::format("{:.2f}", nearest_double(value)); }

/// The greatest integer that is not above the value.
Integer floor(const Rational& value) {
    const Integer quotient = value.numerator() / value.denominator();
    return value.sign() < 0 && Rational(quotient) != value ? quotient - 1 : quotient;
}

struct Bounds {
    std::optional<Rational> least;
    std::optional<Rational> greatest;

    void include(const Rational& value) {
        least = least ? std::min(*least, value) : value;
        greatest = greatest ? std::max(*greatest, value) : value;
    }
    /// The range, with some room where it is a single number.
    std::pair<Rational, Rational> range() const {
        if (!least) return {0, 1};
        if (*least == *greatest) return {*least - 1, *greatest + 1};
        return {*least, *greatest};
    }
};

std::vector<PlanePoint> places_of(const Picture& picture) {
    std::vector<PlanePoint> places;
    for (const PictureLayer& layer : picture.layers) {
        for (const auto* lines : {&layer.curve.lines, &layer.curve.polygon}) {
            for (const auto& line : *lines) places.insert(places.end(), line.begin(), line.end());
        }
    }
    for (const Mark& mark : picture.points) places.push_back(mark.place);
    return places;
}

}  // namespace

Frame::Frame(const Picture& picture) : Frame(places_of(picture), picture.equal_scales) {}

Frame::Frame(const std::vector<PlanePoint>& places, bool equal_scales) {
    Bounds horizontal;
    Bounds vertical;
    for (const PlanePoint& place : places) {
        horizontal.include(place.x);
        vertical.include(place.y);
    }
    std::tie(left_, right_) = horizontal.range();
    std::tie(bottom_, top_) = vertical.range();
    std::size_t inner_height = height_of_graphs;
    if (equal_scales) {
        const Rational ratio = (top_ - bottom_) / (right_ - left_) * Rational(inner_width);
        inner_height = ratio <= Rational(least_height) ? least_height
                       : ratio >= Rational(greatest_height)
                           ? greatest_height
                           : static_cast<std::size_t>(*floor(ratio).to_int64());
        const Rational scale =
            std::max((right_ - left_) / Rational(inner_width), (top_ - bottom_) / Rational(inner_height));
        const auto widen = [&](Rational& least, Rational& greatest, std::size_t length) {
            const Rational more = (scale * Rational(length) - (greatest - least)) / 2;
            least -= more;
            greatest += more;
        };
        widen(left_, right_, inner_width);
        widen(bottom_, top_, inner_height);
    }
    width_ = inner_width + 2 * margin;
    height_ = inner_height + 2 * margin;
}

std::string Frame::x(const Rational& value) const {
    return pixels(Rational(margin) + (value - left_) / (right_ - left_) * Rational(width_ - 2 * margin));
}

std::string Frame::y(const Rational& value) const {
    return pixels(Rational(margin) + (top_ - value) / (top_ - bottom_) * Rational(height_ - 2 * margin));
}

std::vector<Rational> Frame::ticks(const Rational& least, const Rational& greatest) {
    constexpr std::size_t most_ticks = 9;
    constexpr std::size_t most_powers = 400;
    const Rational length = greatest - least;
    Rational power = 1;
    for (std::size_t i = 0; i < most_powers && power > length; ++i) power /= 10;
    for (std::size_t i = 0; i < most_powers && power * 10 <= length; ++i) power *= 10;
    power /= 10;
    for (const int factor : {1, 2, 5, 10}) {
        const Rational step = power * factor;
        if (length / step > Rational(most_ticks)) continue;
        std::vector<Rational> list;
        for (Rational tick = -Rational(floor(-least / step)) * step; tick <= greatest; tick += step)
            list.push_back(tick);
        return list;
    }
    return {};
}

}  // namespace blossom::protocol
