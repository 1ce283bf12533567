#pragma once

#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>
#include "description/members.hpp"
#include "json/fields.hpp"
#include "text/shapes.hpp"

/// Points in requests and responses.

namespace blossom::protocol {

/// The form in which the points of a map are written.
struct PointForm {
    bool scalar = true;        ///< as a number, not as an array
    bool rational = false;     ///< the last coordinate of the engine's points is a weight
    bool homogeneous = false;  ///< a rational map whose points are written with the weight, undivided

    /// Whether the weight of a point is written apart from it.
    bool separate_weights() const { return rational && !homogeneous; }
};

/// One point of a map in JSON. Errors: `zero_weight` for a point at infinity, unless the form is homogeneous.
Json to_json(const Coordinates& point, const PointForm& form);

/// The numbers of a point that `to_json` has written.
Coordinates answered_point(const Json& value);

/// One point of a map of this form, with its weight last where the form is homogeneous.
/// Errors: `mismatched_dimensions` unless it has `dimension` numbers.
Coordinates read_point(const Json& value, const PointForm& form, std::size_t dimension, const Limits& limits);

/// The points of a request: all numbers, or all arrays of one length.
struct Points {
    std::vector<Rational> numbers;  ///< the coordinates of point after point
    std::size_t dimension = 0;      ///< 0 while there is no point
    bool scalar = true;

    bool empty() const { return numbers.empty(); }
    std::size_t size() const { return empty() ? 0 : numbers.size() / dimension; }
    PointArray array() const { return PointArray::point_by_point(dimension, numbers); }
    std::vector<Coordinates> list() const;
};
/// Reads one point more, of the form of those before. Errors: `mismatched_dimensions`.
void read_next_point(const Json& value, Points& points, const Limits& limits);

/// read(list) of a list, or of the list that a text writes: see `number_list`.
template <class Read>
auto read_written_list(const Json& value, const Read& read) {
    const std::string* text = value.text();
    if (!text) return read(value);
    try {
        return read(number_list(*text));
    } catch (const Error& error) {
        throw error.at(Place());  // there are no places in a text
    }
}

/// Errors: `wrong_arity` for none, `mismatched_dimensions`, `limit_exceeded` for more than `limits.numbers`.
Points read_points(const Json& value, const Limits& limits);

/// Points of a map with their weights, as homogeneous coordinates where the form is rational.
struct WeightedPoints {
    Points points;
    PointForm form;
};
/// A number that is not 0. Errors: `zero_weight`.
Rational read_weight(const Json& value, const Limits& limits);
/// Errors: `wrong_arity` unless there is one weight per point; `zero_weight`.
void require_weights(std::span<const Rational> weights, std::size_t points);
/// Makes (w_i P_i, w_i) of every point.
void append_weights(Points& points, std::span<const Rational> weights);

/// The fields "control_points", "weights" and "homogeneous".
/// Errors: `wrong_arity` unless there is one weight per point; `zero_weight`; `wrong_kind` for both "weights"
/// and "homogeneous".
WeightedPoints read_control_points(Fields& fields, const Limits& limits);
/// Writes the points as field `name`, with "weights" and "homogeneous"; arrange(values) puts a list in the
/// form of the points.
template <class Arrange>
void write_points(Json& map, std::string_view name, std::span<const Coordinates> points,
                  const PointForm& form, const Arrange& arrange) {
    Json::Array written;
    Json::Array weights;
    written.reserve(points.size());
    for (const Coordinates& point : points) {
        written.push_back(to_json(point, form));
        if (form.separate_weights()) weights.emplace_back(point.back());
    }
    map[name] = arrange(std::move(written));
    if (form.separate_weights()) map["weights"] = arrange(std::move(weights));
    if (form.homogeneous) map["homogeneous"] = true;
}
inline void write_control_points(Json& map, std::span<const Coordinates> points, const PointForm& form) {
    write_points(map, "control_points", points, form, [](Json::Array values) { return values; });
}

/// The fields "coefficients", "denominator" and "homogeneous": coefficients are written undivided, only
/// points are divided by a weight.
void write_coefficients(Json& map, std::vector<Coordinates> coefficients, const PointForm& form);

/// Whether the field "homogeneous" is true.
bool read_homogeneous(Fields& fields);
/// Errors: `wrong_kind` for "weights" beside "homogeneous".
void refuse_weights(const Fields& fields);
/// The field "homogeneous".
Field homogeneous_field();
/// The form of points that contain their weight. Errors: `mismatched_dimensions` if there is no coordinate
/// besides the weight.
PointForm homogeneous_form(const Points& points);

/// Reads the field "degree", which must agree with the number of points. Errors: `wrong_arity`.
void check_degree(Fields& fields, std::size_t points, const Limits& limits);

/// Errors: `limit_exceeded` when `count` points of `dimension` coordinates exceed `limits.numbers`.
void require_numbers(std::size_t count, std::size_t dimension, const Limits& limits);
/// Errors: `limit_exceeded` when `points` points make a degree above `limits.degree`.
void require_degree(std::size_t points, const Limits& limits);

/// The control points of a map as text, "(0, 0), (1, 2), weights 1, 2"; if there are very many, only the
/// first and the last.
std::string control_points_text(const Json& map);
/// Numbers as text, abbreviated likewise.
std::string numbers_text(const Json& numbers);

}  // namespace blossom::protocol
