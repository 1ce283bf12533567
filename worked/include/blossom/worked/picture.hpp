#pragma once

#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/rational.hpp>
#include <blossom/worked/formula.hpp>

#include <optional>
#include <string>
#include <vector>

namespace blossom::worked {

/// A place in the plane, exactly.
struct Place {
    Rational x;
    Rational y;

    friend bool operator==(const Place&, const Place&) = default;
};

/// What an element of a picture is, from which its colour and width follow.
enum class Role {
    control,       ///< the given control polygon
    construction,  ///< intermediate points and lines
    result,        ///< the point or polygon that was wanted
    second,        ///< a second result beside the first
};

/// "control", "construction", ...: its name in JSON and in style sheets.
std::string role_name(Role role);

/// A point with the formula that names it.
struct PicturePoint {
    Place place;
    Formula label;
    Role role = Role::construction;
    /// What the place is where it is not the value of the label.
    std::optional<Formula> meaning = {};  // NOLINT(readability-redundant-member-init): may be left out
};

struct PictureLine {
    std::vector<Place> places;
    Role role = Role::construction;
};

/// A curve through places, or as cubic Bezier arcs: 3 k + 1 control points of k arcs.
struct PictureCurve {
    std::vector<Place> places;
    bool cubic = false;
    Role role = Role::control;
};

/// A drawing in the plane. Renderings choose the scale and put labels where they cover nothing.
struct Picture {
    std::string caption;
    std::string description;  ///< in words, for who does not see it
    std::vector<PictureCurve> curves;
    std::vector<PictureLine> lines;
    std::vector<PicturePoint> points;
    bool graph = false;  ///< of a function: both axes are drawn, each with its own scale
    /// Of points in space: two rows that make a place of a point.
    std::vector<Coordinates> projection = {};  // NOLINT(readability-redundant-member-init): may be left out
    /// Of arguments, not values: where the vertices of the triangle are drawn. A point is at the mean of the
    /// arguments of its name.
    std::vector<Place> corners = {};  // NOLINT(readability-redundant-member-init): may be left out
};

}  // namespace blossom::worked
