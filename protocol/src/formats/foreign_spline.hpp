#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "json/fields.hpp"
#include "maps/map.hpp"

/// The numbers of a spline in the document of another library.

namespace blossom::protocol {

/// The directions of a flat net, from the one whose index runs fastest to the one whose index runs slowest.
using FlatOrder = std::vector<std::size_t>;

/// 0, 1, 2, ...: the index of the first direction runs fastest.
FlatOrder first_fastest(std::size_t directions);

/// Where a document has the numbers of a map; a text without places has no degrees here.
struct NumberPlaces {
    Place document = {};              ///< of the map, to which the others are relative
    std::vector<Place> degrees = {};  ///< one per direction
    std::vector<Place> knots = {};
    std::vector<Place> sizes = {};  ///< of the net; none where the document does not state them
    Place points = {};
    Place weights = {};
    std::size_t flat_dimension = 0;  ///< of points whose coordinates are one list; 0 for a list of points
    bool by_coordinate = false;      ///< there is a list per coordinate, not per point
    FlatOrder order = {0};
    std::vector<std::size_t> counts = {0};  ///< of control points, per direction

    /// The place in the document of the number at `of_map` in the map.
    Place of(const Place& of_map) const;

private:
    Place inside(const Place& of_map) const;
};

/// A map that a document has, of the kind bspline or bezier.
struct ForeignSpline {
    Map map;
    NumberPlaces places;
};

/// What a document says of one spline.
struct SplineNumbers {
    std::vector<std::size_t> degrees;
    std::vector<std::vector<Rational>> knots;
    std::vector<std::size_t> counts;  ///< none for a curve
    std::vector<Coordinates> points;  ///< in the order of the places
    std::optional<std::vector<Rational>> weights;
};

/// The map of these numbers: a curve for one direction. `places` may leave the counts out.
/// Errors, at the places of the document: `wrong_arity` if a list does not have one element per direction;
/// `incomplete_net` unless there are as many points as the sizes say; `zero_weight` for a weight that is not
/// positive; those of the engine.
ForeignSpline foreign_spline(SplineNumbers numbers, NumberPlaces places);

/// A list of doubles, and a list of points, which must all have one dimension.
std::vector<Rational> read_doubles(const Json& value);
std::vector<Coordinates> read_rows(const Json& value);
/// Weights, as numbers or as lists of one number each.
std::vector<Rational> read_weight_list(const Json& value);

/// Errors: `mismatched_dimensions` unless the number that a document states, if it does, is the one that it
/// has; `what` says of what.
void require_stated(Fields& fields, std::string_view name, std::size_t found, std::string_view what);

/// A spline as the documents of other libraries have it, each number the nearest double.
struct WrittenSpline {
    std::vector<std::size_t> degrees;
    std::vector<std::size_t> counts;
    std::vector<Json::Array> knots;
    Json::Array points;   ///< in the order that was asked for
    Json::Array weights;  ///< none for a polynomial map
    std::size_t dimension = 0;
};

/// Of a bspline map in any number of directions. Errors: `overflow`.
WrittenSpline written_spline(const Map& map, const FlatOrder& order);
Json::Array written_doubles(std::span<const Rational> numbers);

/// The knot vectors of a bspline map, one per direction, and its control points.
std::span<const KnotVector> knots_of(const Map& map);
const std::vector<Coordinates>& control_points_of(const Map& map);

/// Errors: `bad_knots`, `zero_weight`, `overflow` if the nearest doubles of the numbers of a bspline map make
/// no such map, at their places in it.
void require_valid_as_doubles(const Map& map);

}  // namespace blossom::protocol
