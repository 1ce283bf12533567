#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "picture.hpp"

namespace blossom::protocol {

/// From exact places to pixels.
class Frame {
public:
    static constexpr std::size_t margin = 48;

    /// Around everything in the picture.
    explicit Frame(const Picture& picture);
    /// Around these places; with `equal_scales` the same length on both axes.
    Frame(const std::vector<PlanePoint>& places, bool equal_scales);

    std::size_t width() const { return width_; }
    std::size_t height() const { return height_; }
    std::string x(const Rational& value) const;
    std::string y(const Rational& value) const;
    /// Round numbers within the range of the picture.
    std::vector<Rational> ticks_of_x() const { return ticks(left_, right_); }
    std::vector<Rational> ticks_of_y() const { return ticks(bottom_, top_); }

private:
    static std::vector<Rational> ticks(const Rational& least, const Rational& greatest);

    Rational left_;
    Rational right_;
    Rational bottom_;
    Rational top_;
    std::size_t width_ = 640;
    std::size_t height_ = 480;
};

}  // namespace blossom::protocol
