#pragma once

#include <blossom/core/blossom.hpp>
#include <blossom/rational/limits.hpp>

#include <string>

#include "fields.hpp"
#include "json.hpp"

namespace blossom::cli {

/// How the points of a map are written.
struct PointForm {
    bool scalar = true;        ///< as a number, not as an array
    bool rational = false;     ///< the last coordinate of the engine's points is a weight
    bool homogeneous = false;  ///< a rational map whose points are written with the weight, undivided
};

/// A map of one parameter as a request gives it. A rational one is a polynomial map into one dimension more:
/// (w x, w), the weight last.
struct Map {
    PolynomialMap curve;
    PointForm form;
    std::string variable = "t";  ///< what its text called the parameter
};

std::size_t degree_of(const Map& map);
std::size_t dimension_of(const Map& map);

/// A map of any kind. Errors: `wrong_kind` for a kind that is not known, those of the kind.
Map read_map(const Json& value, const Limits& limits);

/// The map as a request may give it again.
Json to_json(const Map& map);

/// One point of a map. Errors: `zero_weight` for a point without place, unless the form is homogeneous.
Json to_json(const Coordinates& point, const PointForm& form);

/// Points as they stand in a request: all numbers, or all arrays of one length.
struct Points {
    std::vector<Coordinates> points;
    bool scalar;
};
/// Errors: `wrong_arity` for none, `mismatched_dimensions`, `limit_exceeded` for more than `limits.degree`
/// + 1.
Points read_points(const Json& value, const Limits& limits);

/// Whether "homogeneous" is asked for.
bool read_homogeneous(Fields& fields);
/// The form of points that carry their weight. Errors: `mismatched_dimensions` when there is nothing but a
/// weight.
PointForm homogeneous_form(const Points& points);

/// Errors: `limit_exceeded` when `count` points of `dimension` coordinates exceed `limits.numbers`.
void require_numbers(std::size_t count, std::size_t dimension, const Limits& limits);

}  // namespace blossom::cli
