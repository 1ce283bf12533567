#pragma once

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>
#include <blossom/worked/formula.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace blossom::worked {

/// The exact coordinates of a point in the plane.
struct PlanePoint {
    Rational x;
    Rational y;

    friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// The role of an element of a picture, which determines its colour and width.
enum class Role {
    before,        ///< the map before the operation, faint
    control,       ///< the given control polygon
    construction,  ///< intermediate points and lines
    result,        ///< the computed point or polygon
    second,        ///< a second result beside the first
};

/// "control", "construction", ...: its name in JSON and in style sheets.
std::string role_name(Role role);

/// A point with the formula that names it; without parts and words it has no name.
struct PicturePoint {
    PlanePoint place;
    Formula label;
    Role role = Role::construction;
    /// The formula for the place, if it is not the label.
    std::optional<Formula> meaning = {};  // NOLINT(readability-redundant-member-init): may be left out
};

struct PictureLine {
    std::vector<PlanePoint> places;
    Role role = Role::construction;
};

/// A curve through places, or as cubic Bezier arcs: 3 k + 1 control points of k arcs.
struct PictureCurve {
    std::vector<PlanePoint> places;
    bool cubic = false;
    Role role = Role::control;
    std::string name = {};  // NOLINT(readability-redundant-member-init): of the legend, may be left out
};

/// A face of a surface with its own colours, and how strong the line is from each corner to the next.
struct PictureFace {
    enum class Edge : unsigned char { none, inner, border };

    std::vector<PlanePoint> places;
    std::vector<Edge> edges;
    std::string fill;
    std::string line;
};

/// Words at a distance in pixels to the right of a place and below it.
struct PictureWords {
    PlanePoint place;
    std::string words;
    int right = 0;
    int below = 0;
};

/// A drawing in the plane. Renderings choose the scale and put labels where they cover nothing.
struct Picture {
    std::string caption;
    std::string description;  ///< a text alternative for screen readers
    std::vector<PictureCurve> curves;
    std::vector<PictureLine> lines;
    std::vector<PicturePoint> points;
    bool graph =
        false;  ///< the picture is the graph of a function: both axes are drawn, each with its own scale
    /// For points in space: the two rows of the projection to the plane.
    std::vector<Coordinates> projection = {};  // NOLINT(readability-redundant-member-init): may be left out
    /// Of arguments, not values: where the vertices of the triangle are drawn. A point is at the mean of the
    /// arguments of its name.
    std::vector<PlanePoint> corners = {};  // NOLINT(readability-redundant-member-init): may be left out
    bool grid = false;  ///< lines at round numbers behind the picture, also if it is not a graph
    std::vector<PictureFace> faces = {};   // NOLINT(readability-redundant-member-init): in order of painting
    std::vector<PictureWords> words = {};  // NOLINT(readability-redundant-member-init): may be left out
    std::size_t width = 360;               ///< in pixels, without margins
};

/// The first two coordinates, of rational points divided by the weight, in lines that end at each point at
/// infinity.
std::vector<std::vector<PlanePoint>> lines_through(std::span<const Coordinates> points,
                                                   bool rational = false);

/// The curve over an interval: an exact cubic arc up to degree 3, otherwise and for a rational curve lines
/// through exact points, `steps` parts of the interval.
std::vector<PictureCurve> curves_over(const PolynomialMap& map, const Interval& interval, Role role,
                                      const Limits& limits, bool rational = false, std::size_t steps = 96);

/// The number; if it is long, with at most this many digits, and "≈" in front if it was rounded.
std::string short_text(const Rational& value, std::int64_t digits = 4);

}  // namespace blossom::worked
