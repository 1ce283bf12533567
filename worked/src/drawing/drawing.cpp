#include "drawing.hpp"
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "document/letters.hpp"

namespace blossom::worked {

namespace {

/// Points on cubic arcs by de Casteljau's algorithm, exact places or, rounded, spots: fine enough to find how
/// far a curve goes and what covers what.
template <class Point>
std::vector<Point> flattened(const std::vector<Point>& points) {
    using Number = decltype(Point::x);
    constexpr std::int64_t pieces = 24;
    std::vector<Point> all{points.front()};
    for (std::size_t arc = 0; arc + 3 < points.size(); arc += 3) {
        for (std::int64_t k = 1; k <= pieces; ++k) {
            const auto value = [&](auto member) {
                const Number v(k);
                const Number u(pieces - k);
                const Number sum = u * u * u * points[arc].*member + 3 * u * u * v * points[arc + 1].*member +
                                   3 * u * v * v * points[arc + 2].*member +
                                   v * v * v * points[arc + 3].*member;
                return Number(sum / Number(pieces * pieces * pieces));
            };
            all.push_back({value(&Point::x), value(&Point::y)});
        }
    }
    return all;
}

constexpr Length least_height = 700;
constexpr Length side_margin = 620;
constexpr Length end_margin = 420;
constexpr Length axis_width = 440;   ///< of the strip with the numbers of the y axis
constexpr Length axis_height = 320;  ///< of the strip with those of the x axis

Length length_of(const Rational& value) { return rounded(value).to_int64().value_or(0); }

std::vector<PlanePoint> all_places(const Picture& picture) {
    std::vector<PlanePoint> places;
    const auto append = [&](const std::vector<PlanePoint>& more) {
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

/// How the places of a picture lie on paper: an exact affine map, rounded at the end.
class Paper {
public:
    explicit Paper(const Picture& picture) : axes_(picture.graph || picture.grid) {
        const std::vector<PlanePoint> places = all_places(picture);
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
        x_ = extent(&PlanePoint::x);
        y_ = extent(&PlanePoint::y);
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

    Length width() const { return width_; }
    Length height() const { return height_; }
    Spot spot(const PlanePoint& place) const {
        const Length bottom = y_.begin + y_.length();
        return {x_.at(place.x), bottom - (y_.at(place.y) - y_.begin)};
    }

    std::vector<Spot> spots(const std::vector<PlanePoint>& places) const {
        return mapped(places, [&](const PlanePoint& place) { return spot(place); });
    }

    /// Where labels may stand.
    Box room() const {
        return {axes_ ? axis_width + 40 : 20, 20, width_ - 20, height_ - (axes_ ? axis_height + 40 : 20)};
    }

    /// The two axes, if there are any.
    std::vector<Segment> axes() const {
        if (!axes_) return {};
        const Length left = axis_width;
        const Length bottom = height_ - axis_height;
        return {{{left, bottom}, {width_ - 40, bottom}}, {{left, bottom}, {left, 40}}};
    }

    /// The numbers on the axes, at multiples of 1, 2 or 5 times a power of ten, with lines across the paper.
    std::vector<Drawing::Tick> ticks() const {
        if (!axes_) return {};
        std::vector<Drawing::Tick> ticks;
        const Length bottom = height_ - axis_height;
        for (const auto& [value, text] : x_.marks(900)) {
            const Length x = x_.at(value);
            ticks.push_back({{{x, bottom}, {x, 40}}, text, true});
        }
        for (const auto& [value, text] : y_.marks(700)) {
            const Length y = spot({x_.least, value}).y;
            ticks.push_back({{{axis_width, y}, {width_ - 40, y}}, text, false});
        }
        return ticks;
    }

private:
    /// One direction: world = least + (paper - begin) / scale.
    struct Axis {
        /// A number on an axis, and its exact text.
        struct Mark {
            Rational value;
            std::string text;
        };

        Rational least;
        Rational greatest;
        Rational scale;
        Length begin = 0;

        Length length() const { return length_of((greatest - least) * scale); }

        Length at(const Rational& value) const { return begin + length_of((value - least) * scale); }

        /// At both ends, so that it becomes `length` long if it is shorter.
        void widen(Length length) {
            const Rational more = (Rational(length) / scale - (greatest - least)) / 2;
            if (more.sign() <= 0) return;
            least -= more;
            greatest += more;
        }

        /// Multiples of a round number, at least `apart` from each other.
        std::vector<Mark> marks(Length apart) const {
            const Rational step = round_step(Rational(apart) / scale);
            const Rational quotient = least / step;
            Integer k = quotient.numerator() / quotient.denominator();
            while (Rational(k - 1) * step >= least) k -= 1;
            while (Rational(k) * step < least) k += 1;
            std::vector<Mark> marks;
            for (; Rational(k) * step <= greatest; k += 1) {
                // A multiple of 1, 2 or 5 has at most one digit more than its factor.
                const auto digits = static_cast<std::int64_t>(to_string(k).size()) + 1;
                marks.push_back(
                    {Rational(k) * step, short_text(Rational(k) * step, std::max<std::int64_t>(digits, 4))});
            }
            return marks;
        }
    };

    bool axes_;
    Axis x_;
    Axis y_;
    Length width_ = 0;
    Length height_ = 0;
};

void append_segments(std::vector<Segment>& segments, const std::vector<Spot>& spots) {
    for (std::size_t i = 0; i + 1 < spots.size(); ++i) segments.push_back({spots[i], spots[i + 1]});
}

bool has_name(const PicturePoint& point) {
    return point.label.kind != FormulaKind::words || !point.label.name.empty();
}

/// Whether points at one place are equal. Two points of space may be projected to one place, and the
/// arguments of two values may have one mean.
bool places_are_values(const Picture& picture) {
    return picture.projection.empty() && picture.corners.empty();
}

/// Points that are drawn at one spot have one dot, of the most important role, and one label with all their
/// names.
void add_points(const Picture& picture, const Paper& paper, const Notation& notation, Drawing& drawing) {
    struct Place {
        PlanePoint place;
        std::vector<Formula> names;
    };
    std::vector<std::vector<Place>> places_of_dots;
    for (const PicturePoint& point : picture.points) {
        const Spot spot = paper.spot(point.place);
        const auto same = std::ranges::find(drawing.dots, spot, &Drawing::Dot::spot);
        const auto index = static_cast<std::size_t>(same - drawing.dots.begin());
        if (same == drawing.dots.end()) {
            drawing.dots.push_back({spot, point.role});
            places_of_dots.emplace_back();
        } else {
            same->role = std::max(same->role, point.role);
        }
        if (!has_name(point)) continue;
        std::vector<Place>& places = places_of_dots[index];
        auto own = std::ranges::find(places, point.place, &Place::place);
        if (own == places.end()) own = places.insert(own, {point.place, {}});
        const auto text = [&](const Formula& name) { return to_text(name, notation); };
        if (std::ranges::find(own->names, text(point.label), text) == own->names.end())
            own->names.push_back(point.label);
    }
    const auto is_relation = [](const Formula& name) { return name.kind == FormulaKind::relation; };
    for (const std::vector<Place>& places : places_of_dots) {
        std::vector<Formula>& names = drawing.labels.emplace_back().names;
        for (const Place& place : places) {
            if (places_are_values(picture) && std::ranges::none_of(place.names, is_relation)) {
                names.push_back(equation(place.names));
            } else {
                names.insert(names.end(), place.names.begin(), place.names.end());
            }
        }
    }
}

/// Whether labels of this role are set in bold.
bool bold(Role role) { return role == Role::result || role == Role::second; }

void add_labels(Drawing& drawing, const Box& room, const Notation& notation) {
    std::vector<Segment> segments;
    for (const Drawing::Path& path : drawing.paths)
        append_segments(segments, path.cubic ? flattened(path.spots) : path.spots);
    std::vector<LabelSize> sizes;
    std::vector<Drawing::Label*> named;
    for (std::size_t i = 0; i < drawing.labels.size(); ++i) {
        if (drawing.labels[i].names.empty()) continue;
        const std::string text = to_text(label_formula(drawing.labels[i]), notation);
        sizes.push_back({drawing.dots[i].spot, text_width(text, bold(drawing.dots[i].role)), label_height});
        named.push_back(&drawing.labels[i]);
    }
    const std::vector<PlacedLabel> placed = place_labels(sizes, segments, room);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        named[i]->box = placed[i].box;
        if (placed[i].away) named[i]->leader = leader(sizes[i].anchor, placed[i].box);
    }
}

/// The names of curves above the picture.
void add_legend(const Picture& picture, const Box& room, Drawing& drawing) {
    Length x = room.left + 60;
    for (const PictureCurve& curve : picture.curves) {
        if (curve.name.empty()) continue;
        drawing.legend.push_back({{{x, room.top + 100}, {x + 200, room.top + 100}}, curve});
        x += 400 + text_width(curve.name);
    }
}

}  // namespace

Integer rounded(const Rational& value) {
    const Integer twice = value.numerator() * Integer(2) + value.denominator();
    const Integer divisor = value.denominator() * Integer(2);
    Integer quotient = twice / divisor;
    if (twice.sign() < 0 && !(twice % divisor).is_zero()) quotient -= Integer(1);
    return quotient;
}

Length text_width(std::string_view text, bool bold) {
    struct Kind {
        std::string_view characters;
        Length width;
    };
    // As wide as in DejaVu Sans of 15 pixels, the widest of the fonts that the pictures name.
    static constexpr std::array<Kind, 3> kinds{{{" ,.'/", 51}, {"()[]", 61}, {"=+<>mwMW", 130}}};
    constexpr Length other = 96;
    constexpr Length margin = 20;
    Length width = margin + other * static_cast<Length>(columns(text));
    for (const Kind& kind : kinds) {
        const auto found = std::ranges::count_if(
            text, [&](char c) { return kind.characters.find(c) != std::string_view::npos; });
        width += (kind.width - other) * static_cast<Length>(found);
    }
    return bold ? width * 9 / 8 : width;
}

Formula label_formula(const Drawing::Label& label) { return list_of(label.names); }

std::string pixels(Length length) {
    const std::string sign = length < 0 ? "-" : "";
    const Length size = length < 0 ? -length : length;
    const std::string whole = sign + std::to_string(size / 10);
    return size % 10 == 0 ? (whole == "-0" ? "0" : whole) : whole + "." + std::to_string(size % 10);
}

Drawing drawn(const Picture& picture, const Notation& notation) {
    const Paper paper(picture);
    Drawing drawing;
    drawing.width = paper.width();
    drawing.height = paper.height();
    drawing.axes = paper.axes();
    drawing.ticks = paper.ticks();
    for (const PictureLine& line : picture.lines) {
        drawing.paths.push_back({paper.spots(line.places), false, line.role, false});
    }
    for (const PictureCurve& curve : picture.curves) {
        drawing.paths.push_back({paper.spots(curve.places), curve.cubic, curve.role, true});
    }
    for (const PictureFace& face : picture.faces) drawing.faces.push_back({paper.spots(face.places), face});
    for (const PictureWords& words : picture.words) drawing.words.push_back({paper.spot(words.place), words});
    add_points(picture, paper, notation, drawing);
    Box room = paper.room();
    add_legend(picture, room, drawing);
    if (!drawing.legend.empty()) room.top += label_height;
    add_labels(drawing, room, notation);
    return drawing;
}

}  // namespace blossom::worked
