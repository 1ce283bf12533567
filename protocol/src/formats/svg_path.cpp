#include "svg_path.hpp"

#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/square_root.hpp>
#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "doubles.hpp"
#include "foreign_formats.hpp"

namespace blossom::protocol {

namespace {

struct Vector {
    Rational x;
    Rational y;
    friend bool operator==(const Vector&, const Vector&) = default;
};

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(const Rational& s, const Vector& v) { return {s * v.x, s * v.y}; }
/// Coordinate by coordinate.
Vector scaled(const Vector& v, const Vector& by) { return {v.x * by.x, v.y * by.y}; }
Rational dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
Rational cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

class PathReader {
public:
    PathReader(std::string_view text, Floats floats, const Limits& limits)
        : text_(text), floats_(floats), limits_(limits) {}

    std::vector<Map> read() {
        skip_separators();
        while (at_ < text_.size()) {
            const char letter = text_[at_];
            if (std::string_view("mlhvcsqtaz").find(lower(letter)) == std::string_view::npos) {
                fail(at_, "expected one of the letters MLHVCSQTAZ of a path, found " +
                              quoted(first_character(text_.substr(at_))));
            }
            if (curves_.empty() && !begun_ && lower(letter) != 'm') fail(at_, "a path begins with M");
            begin_ = at_++;
            skip_separators();
            read_segments(letter);
        }
        return std::move(curves_);
    }

private:
    [[noreturn]] void fail(std::size_t place, const std::string& message,
                           ErrorCode code = ErrorCode::syntax) const {
        const std::size_t column = count_characters(text_.substr(0, place)) + 1;
        throw Error(code, "column " + std::to_string(column) + ": " + message, {}, place);
    }

    void skip_separators() {
        constexpr std::string_view separators = " \t\r\n\f,";
        while (at_ < text_.size() && separators.find(text_[at_]) != std::string_view::npos) ++at_;
    }
    bool at_number() const {
        return at_ < text_.size() && (std::string_view("+-.").find(text_[at_]) != std::string_view::npos ||
                                      (text_[at_] >= '0' && text_[at_] <= '9'));
    }

    Rational number() {
        const std::size_t begin = at_;
        const bool negative = at_ < text_.size() && text_[at_] == '-';
        if (negative || (at_ < text_.size() && text_[at_] == '+')) ++at_;
        const std::string_view digits = text_.substr(at_, unsigned_number_length(text_.substr(at_)));
        if (digits.empty()) fail(begin, "expected a number");
        at_ += digits.size();
        skip_separators();
        try {
            const Rational value =
                floats_ == Floats::decimal ? parse_rational(digits, limits_) : read_double(Json(digits));
            return negative ? -value : value;
        } catch (const Error& error) {
            throw error.at(begin);
        }
    }
    bool flag() {
        const char c = at_ < text_.size() ? text_[at_] : '\0';
        if (c != '0' && c != '1') fail(at_, "a flag of an arc is 0 or 1");
        ++at_;
        skip_separators();
        return c == '1';
    }

    Vector point(bool relative) {
        Rational x = number();
        Rational y = number();
        const Vector read{std::move(x), std::move(y)};
        return relative ? current_ + read : read;
    }

    /// What follows a letter, which counts for all the numbers up to the next.
    void read_segments(char letter) {
        const bool relative = letter == lower(letter);
        char kind = lower(letter);
        if (kind == 'z') {
            if (current_ != start_) add_line(start_);
            last_ = kind;
            return;
        }
        do {
            read_segment(kind, relative);
            last_ = kind;
            if (kind == 'm') kind = 'l';
        } while (at_number());
    }

    void read_segment(char kind, bool relative) {
        switch (kind) {
            case 'm':
                start_ = current_ = point(relative && begun_);
                begun_ = true;
                return;
            case 'l':
                return add_line(point(relative));
            case 'h': {
                const Rational x = number();
                return add_line({relative ? current_.x + x : x, current_.y});
            }
            case 'v': {
                const Rational y = number();
                return add_line({current_.x, relative ? current_.y + y : y});
            }
            case 'c': {
                const Vector first = point(relative);
                return add_cubic(first, relative);
            }
            case 's':
                return add_cubic(reflected("cs"), relative);
            case 'q': {
                const Vector control = point(relative);
                return add_quadratic(control, point(relative));
            }
            case 't': {
                const Vector control = reflected("qt");
                return add_quadratic(control, point(relative));
            }
            default:
                read_arc(relative);
        }
    }

    /// The last control point reflected at the current point, after one of the given kinds.
    Vector reflected(std::string_view kinds) const {
        const bool follows = kinds.find(last_) != std::string_view::npos;
        return follows ? current_ + (current_ - control_) : current_;
    }

    void add(std::vector<Coordinates> points, PointForm form) {
        const Rational begin(Integer(curves_.size()));
        require_within((curves_.size() + 1) * points.size() * points.front().size(), limits_.numbers,
                       "numbers", "the count of numbers");
        curves_.push_back({BezierCurve(points, Interval(begin, begin + 1)), form});
    }
    void add_polynomial(std::initializer_list<Vector> points) {
        std::vector<Coordinates> list;
        for (const Vector& point : points) list.push_back({point.x, point.y});
        current_ = *(points.end() - 1);
        add(std::move(list), {.scalar = false});
    }
    void add_line(const Vector& end) { add_polynomial({current_, end}); }
    void add_quadratic(const Vector& control, const Vector& end) {
        control_ = control;
        add_polynomial({current_, control, end});
    }
    void add_cubic(const Vector& first, bool relative) {
        const Vector second = point(relative);
        const Vector end = point(relative);
        control_ = second;
        add_polynomial({current_, first, second, end});
    }

    void read_arc(bool relative) {
        const Rational rx = abs(number());
        const Rational ry = abs(number());
        const Rational rotation = number();
        const bool large = flag();
        const bool sweep = flag();
        const Vector end = point(relative);
        if (end == current_) return;
        if (rx.is_zero() || ry.is_zero()) return add_line(end);
        const Rational quarters = rotation / 90;
        if (rx != ry && !quarters.is_integer()) {
            fail(begin_,
                 "the axes of the arc are turned by " + to_string(rotation) +
                     " degrees, and only multiples of 90 have a rational cosine and sine",
                 ErrorCode::wrong_kind);
        }
        const bool swapped = quarters.is_integer() && quarters.numerator().is_odd();
        add_arc(swapped ? Vector{ry, rx} : Vector{rx, ry}, large, sweep, end);
        current_ = end;
    }

    /// In units of the radii an ellipse is a circle.
    void add_arc(const Vector& radii, bool large, bool sweep, const Vector& end) {
        const Vector unit{Rational(1) / radii.x, Rational(1) / radii.y};
        const Vector half = Rational(1, 2) * scaled(current_ - end, unit);
        const Rational square = dot(half, half);
        Vector centre = Rational(1, 2) * scaled(current_ + end, unit);
        if (square < 1) {
            const auto offset = exact_square_root((Rational(1) - square) / square);
            if (!offset) {
                fail(begin_,
                     "the centre of the arc is not rational, because " +
                         to_string((Rational(1) - square) / square) +
                         " is not the square of a rational number",
                     ErrorCode::wrong_kind);
            }
            const Rational side = large != sweep ? *offset : -*offset;
            centre = centre + side * Vector{half.y, -half.x};
        }
        const Rational direction = sweep ? 1 : -1;
        Vector from = scaled(current_, unit) - centre;
        const Vector to = scaled(end, unit) - centre;
        const auto in_quarter = [&] {
            return (direction * cross(from, to)).sign() > 0 && dot(from, to).sign() >= 0;
        };
        while (!in_quarter()) {
            const Vector next = direction * Vector{-from.y, from.x};
            add_part(centre, radii, from, next);
            from = next;
            if (from == to) return;
        }
        add_part(centre, radii, from, to);
    }

    /// The part between two radii of at most a quarter.
    void add_part(const Vector& centre, const Vector& radii, const Vector& from, const Vector& to) {
        const Rational square = dot(from, from);
        const Rational above = square + dot(from, to);
        const Vector middle = square / above * (from + to);
        const Rational cosine_square = above / (2 * square);
        const auto cosine = exact_square_root(cosine_square);
        const Rational weights[] = {1, cosine.value_or(cosine_square), cosine ? Rational(1) : cosine_square};
        const Vector points[] = {from, middle, to};
        std::vector<Coordinates> list;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector point = scaled(centre + points[i], radii);
            list.push_back(homogeneous_point({point.x, point.y}, weights[i]));
        }
        add(std::move(list), {.scalar = false, .rational = true});
    }

    std::string_view text_;
    Floats floats_;
    const Limits& limits_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;  ///< of the letter that is being read
    bool begun_ = false;
    char last_ = 'm';  ///< the kind of the last segment
    Vector start_;     ///< of the part of the path that Z closes
    Vector current_;
    Vector control_;  ///< the last control point before the current point
    std::vector<Map> curves_;
};

}  // namespace

bool is_svg_path(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && lower(text[first]) == 'm';
}

std::vector<Map> svg_path_curves(std::string_view text, Floats floats, const Limits& limits) {
    return PathReader(text, floats, limits).read();
}

namespace {

// The text of a path is as exact as it is written.
std::vector<ForeignSpline> read_svg(const Json& document, Floats floats, const Limits& limits) {
    return mapped(svg_path_curves(read_text(document), floats, limits),
                  [](const Map& curve) { return ForeignSpline{curve, {}}; });
}

Json write_svg_path(const std::vector<Map>& splines) {
    std::string path;
    for (const Map& map : splines) {
        const auto& curve = std::get<BSplineCurve>(map.value);
        if (map.form.rational || map.form.scalar || curve.dimension() != 2 || curve.degree() == 0 ||
            curve.degree() > 3) {
            throw Error(
                ErrorCode::wrong_kind,
                "a path has curves in the plane without weights, of degree 1 to 3, and this has degree " +
                    std::to_string(curve.degree()) + " and dimension " +
                    std::to_string(curve.dimension() - (map.form.separate_weights() ? 1 : 0)));
        }
        const auto append = [&](const Coordinates& point) {
            path += " " + double_number(point[0]).text + "," + double_number(point[1]).text;
        };
        Coordinates end;
        for (const BezierCurve& segment : bezier_segments(curve)) {
            const std::vector<Coordinates> points = segment.control_points().to_points();
            if (points.front() != end) {
                path += path.empty() ? "M" : " M";
                append(points.front());
            }
            end = points.back();
            path += std::string(" ") + std::string_view("LQC")[curve.degree() - 1];
            for (std::size_t i = 1; i < points.size(); ++i) append(points[i]);
        }
    }
    return path;
}

}  // namespace

constinit const ForeignFormat svg_format{.name = "svg",
                                         .read = read_svg,
                                         .write = write_svg_path,
                                         .floats = Floats::decimal,
                                         .curves_only = true,
                                         .weights = true,
                                         .text = true,
                                         .pieces = true};

}  // namespace blossom::protocol
