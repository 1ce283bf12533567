#include <blossom/core/geometry/space.hpp>
#include <blossom/rational/error.hpp>

#include <numeric>
#include <utility>

namespace blossom::geometry {

namespace {

std::string described(const Space& space) {
    const std::string dimension = "of dimension " + std::to_string(space.dimension());
    return space.name().empty() ? "a space " + dimension : "the space " + space.name() + " " + dimension;
}

Coordinates required(const Space& space, Coordinates coordinates) {
    if (coordinates.size() == space.dimension()) return coordinates;
    throw Error(
        ErrorCode::mismatched_dimensions,
        std::to_string(coordinates.size()) + " coordinates make no point or vector of " + described(space));
}

Coordinates sum(const Coordinates& a, const Coordinates& b) {
    Coordinates result = a;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += b[i];
    return result;
}

}  // namespace

void require_same_space(const Space& expected, const Space& given) {
    if (expected == given) return;
    throw Error(ErrorCode::different_spaces, "a point or vector of " + described(given) +
                                                 " stands where one of " + described(expected) +
                                                 " is needed");
}

Space::Space(std::size_t dimension, std::string name)
    : description_(std::make_shared<const Description>(Description{dimension, std::move(name)})) {}

Point Space::point(Coordinates coordinates) const { return {*this, required(*this, std::move(coordinates))}; }

Vector Space::vector(Coordinates coordinates) const {
    return {*this, required(*this, std::move(coordinates))};
}

Point Space::origin() const { return {*this, Coordinates(dimension())}; }

Vector operator+(const Vector& a, const Vector& b) {
    require_same_space(a.space_, b.space_);
    return {a.space_, sum(a.coordinates_, b.coordinates_)};
}

Vector operator-(const Vector& a, const Vector& b) { return a + -b; }

Vector operator-(const Vector& a) { return Rational(-1) * a; }

Vector operator*(const Rational& scale, const Vector& a) {
    Coordinates coordinates = a.coordinates_;
    for (Rational& coordinate : coordinates) coordinate *= scale;
    return {a.space_, std::move(coordinates)};
}

Vector operator-(const Point& a, const Point& b) {
    return a.space_.vector(a.coordinates_) - b.space_.vector(b.coordinates_);
}

Point operator+(const Point& a, const Vector& b) {
    require_same_space(a.space_, b.space());
    return {a.space_, sum(a.coordinates_, b.coordinates())};
}

Point operator-(const Point& a, const Vector& b) { return a + -b; }

Point affine_combination(std::span<const Point> points, std::span<const Rational> weights) {
    if (points.empty() || points.size() != weights.size()) {
        throw Error(ErrorCode::wrong_arity,
                    "an affine combination needs one weight for each of at least one point, not " +
                        std::to_string(weights.size()) + " weights for " + std::to_string(points.size()) +
                        " points");
    }
    const Rational total = std::accumulate(weights.begin(), weights.end(), Rational());
    if (total != 1) {
        throw Error(ErrorCode::not_affine, "the weights of an affine combination have the sum " +
                                               to_string(total) + ", which must be 1");
    }
    const Point& first = points.front();
    Point result = first;
    for (std::size_t i = 1; i < points.size(); ++i) result = result + weights[i] * (points[i] - first);
    return result;
}

}  // namespace blossom::geometry
