#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/error.hpp>

#include <string>

namespace blossom {

namespace {

RationalVector transposed(std::span<const Coordinates> points) {
    if (points.empty()) throw Error(ErrorCode::wrong_arity, "at least one point is needed");
    const std::size_t dimension = points.front().size();
    std::vector<Rational> numbers(points.size() * dimension);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].size() != dimension || dimension == 0) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "point " + std::to_string(i) + " has " + std::to_string(points[i].size()) +
                            " coordinates; every point needs the same number, at least 1, and point 0 has " +
                            std::to_string(dimension),
                        Place{i});
        }
        for (std::size_t j = 0; j < dimension; ++j) numbers[j * points.size() + i] = points[i][j];
    }
    return RationalVector(numbers);
}

}  // namespace

PointArray::PointArray(std::span<const Coordinates> points)
    : dimension_(points.empty() ? 1 : points.front().size()), numbers_(transposed(points)) {}

PointArray::PointArray(std::size_t dimension, RationalVector numbers)
    : dimension_(dimension), numbers_(std::move(numbers)) {}

std::vector<std::span<const Integer>> PointArray::rows() const {
    std::vector<std::span<const Integer>> rows;
    rows.reserve(dimension_);
    for (std::size_t j = 0; j < dimension_; ++j) rows.push_back(coordinate(j));
    return rows;
}

Coordinates PointArray::operator[](std::size_t i) const {
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

}  // namespace blossom
