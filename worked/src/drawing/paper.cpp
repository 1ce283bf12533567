#include "paper.hpp"
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace blossom::worked {

namespace {

constexpr Length least_height = 700;
constexpr Length side_margin = 620;
constexpr Length end_margin = 420;
constexpr Length axis_width = 440;   ///< of the strip with the numbers of the y axis
constexpr Length axis_height = 320;  ///< of the strip with those of the x axis

Length length_of(const Rational& value) { return rounded(value).to_int64().value_or(0); }

std::vector<Place> all_places(const Picture& picture) {
    std::vector<Place> places;
    const auto append = [&](const std::vector<Place>& more) {
        places.insert(places.end(), more.begin(), more.end());
    };
    for (const PictureCurve& curve : picture.curves)
        append(curve.cubic ? flattened(curve.places) : curve.places);
    for (const PictureLine& line : picture.lines) append(line.places);
    for (const PictureFace& face : picture.faces) append(face.places);
    for (const PicturePoint& point : picture.points) places.push_back(point.place);
    if (places.empty()) places.emplace_back();
    return places;
}

/// The least of 1, 2 and 5 times a power of ten that is at least `least`.
Rational round_step(const Rational& least) {
    Rational power = 1;
    while (power < least) power *= 10;
    while (power >= least * Rational(10)) power /= 10;
    for (const Rational& part : {Rational(1, 10), Rational(1, 5), Rational(1, 2)}) {
        if (power * part >= least) return power * part;
    }
    return power;
}

}  // namespace

Integer rounded(const Rational& value) {
    const Integer twice = value.numerator() * Integer(2) + value.denominator();
    const Integer divisor = value.denominator() * Integer(2);
    Integer quotient = twice / divisor;
    if (twice.sign() < 0 && !(twice % divisor).is_zero()) quotient -= Integer(1);
    return quotient;
}

Length Paper::Axis::length() const { return length_of((greatest - least) * scale); }

Length Paper::Axis::at(const Rational& value) const { return begin + length_of((value - least) * scale); }

void Paper::Axis::widen(Length length) {
    const Rational more = (Rational(length) / scale - (greatest - least)) / 2;
    if (more.sign() <= 0) return;
    least -= more;
    greatest += more;
}

std::vector<Rational> Paper::Axis::marks(Length apart) const {
    const Rational step = round_step(Rational(apart) / scale);
    const Rational quotient = least / step;
    Rational mark = Rational(quotient.numerator() / quotient.denominator()) * step;
    while (mark - step >= least) mark -= step;
    while (mark < least) mark += step;
    std::vector<Rational> marks;
    for (; mark <= greatest; mark += step) marks.push_back(mark);
    return marks;
}

Paper::Paper(const Picture& picture) : axes_(picture.graph || picture.grid) {
    const std::vector<Place> places = all_places(picture);
    const auto extent = [&](auto member) {
        const auto [least, greatest] = std::ranges::minmax(places, {}, member);
        Axis axis{least.*member, greatest.*member, 1, 0};
        // A single value is drawn in the middle of an interval around it.
        if (axis.least == axis.greatest) {
            axis.least -= Rational(1, 2);
            axis.greatest += Rational(1, 2);
        }
        return axis;
    };
    x_ = extent(&Place::x);
    y_ = extent(&Place::y);
    const auto plot_width = static_cast<Length>(10 * picture.width);
    x_.scale = Rational(plot_width) / (x_.greatest - x_.least);
    y_.scale = Rational(plot_width * (picture.graph ? 7 : 8) / 9) / (y_.greatest - y_.least);
    if (!picture.graph) x_.scale = y_.scale = std::min(x_.scale, y_.scale);
    // A narrow picture is centred on paper of the usual width, so that its labels have the usual size.
    x_.widen(plot_width);
    y_.widen(least_height);
    x_.begin = side_margin + (axes_ ? axis_width : 0);
    y_.begin = end_margin;
    width_ = x_.begin + x_.length() + side_margin;
    height_ = y_.length() + 2 * end_margin + (axes_ ? axis_height : 0);
}

Spot Paper::spot(const Place& place) const {
    const Length bottom = y_.begin + y_.length();
    return {x_.at(place.x), bottom - (y_.at(place.y) - y_.begin)};
}

std::vector<Spot> Paper::spots(const std::vector<Place>& places) const {
    return mapped(places, [&](const Place& place) { return spot(place); });
}

Box Paper::room() const {
    return {axes_ ? axis_width + 40 : 20, 20, width_ - 20, height_ - (axes_ ? axis_height + 40 : 20)};
}

std::vector<Segment> Paper::axes() const {
    if (!axes_) return {};
    const Length left = axis_width;
    const Length bottom = height_ - axis_height;
    return {{{left, bottom}, {width_ - 40, bottom}}, {{left, bottom}, {left, 40}}};
}

std::vector<Drawing::Tick> Paper::ticks() const {
    if (!axes_) return {};
    std::vector<Drawing::Tick> ticks;
    const Length bottom = height_ - axis_height;
    for (const Rational& mark : x_.marks(900)) {
        const Length x = x_.at(mark);
        ticks.push_back({{{x, bottom}, {x, 40}}, short_text(mark), true});
    }
    for (const Rational& mark : y_.marks(700)) {
        const Length y = spot({x_.least, mark}).y;
        ticks.push_back({{{axis_width, y}, {width_ - 40, y}}, short_text(mark), false});
    }
    return ticks;
}

}  // namespace blossom::worked
