#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/lists.hpp>

#include <string>

namespace blossom {

namespace {

void require_points(std::size_t count) {
    if (count == 0) throw Error(ErrorCode::wrong_arity, "at least one point is needed");
}

void require_complete(std::size_t dimension, std::size_t numbers) {
    require_points(numbers);
    if (dimension != 0 && numbers % dimension == 0) return;
    throw Error(ErrorCode::wrong_arity,
                std::to_string(numbers) + " numbers are no points of dimension " + std::to_string(dimension));
}

/// The numbers coordinate(i, j) of `count` points, row by row.
template <class Coordinate>
RationalVector row_by_row(std::size_t count, std::size_t dimension, const Coordinate& coordinate) {
    std::vector<Rational> numbers;
    numbers.reserve(count * dimension);
    for (std::size_t j = 0; j < dimension; ++j) {
        for (std::size_t i = 0; i < count; ++i) numbers.push_back(coordinate(i, j));
    }
    return RationalVector(numbers);
}

RationalVector transposed(std::span<const Coordinates> points) {
    require_points(points.size());
    const std::size_t dimension = points.front().size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].size() == dimension && dimension > 0) continue;
        throw Error(ErrorCode::mismatched_dimensions,
                    "point " + std::to_string(i) + " has " + std::to_string(points[i].size()) +
                        " coordinates; every point needs the same number, at least 1, and point 0 has " +
                        std::to_string(dimension),
                    Place{i});
    }
    return row_by_row(points.size(), dimension, [&](std::size_t i, std::size_t j) { return points[i][j]; });
}

}  // namespace

PointArray::PointArray(std::span<const Coordinates> points)
    : dimension_(points.empty() ? 1 : points.front().size()), numbers_(transposed(points)) {}

PointArray::PointArray(Count dimension, RationalVector numbers)
    : dimension_(dimension), numbers_(std::move(numbers)) {
    require_complete(dimension_, numbers_.size());
}

PointArray PointArray::point_by_point(Count dimension, std::span<const Rational> numbers) {
    require_complete(dimension, numbers.size());
    if (dimension == 1) return {1, RationalVector(numbers)};
    return {dimension, row_by_row(numbers.size() / dimension, dimension,
                                  [&](std::size_t i, std::size_t j) { return numbers[i * dimension + j]; })};
}

void PointArray::refuse_moved() {
    throw Error(ErrorCode::internal, "the points were moved to another object");
}

std::vector<std::span<const Integer>> PointArray::rows() const {
    std::vector<std::span<const Integer>> rows;
    rows.reserve(dimension_);
    for (std::size_t j = 0; j < dimension_; ++j) rows.push_back(coordinate(j));
    return rows;
}

Coordinates PointArray::operator[](std::size_t i) const {
    require_index(i, size());
    Coordinates point;
    point.reserve(dimension_);
    for (std::size_t j = 0; j < dimension_; ++j) point.push_back(numbers_[j * size() + i]);
    return point;
}

std::vector<Coordinates> PointArray::to_points() const {
    std::vector<Coordinates> points;
    points.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) points.push_back((*this)[i]);
    return points;
}

std::string to_string(const PointArray& points) {
    return joined(points.to_points(),
                  [](const Coordinates& point) { return to_string(RationalVector(point)); });
}

}  // namespace blossom
