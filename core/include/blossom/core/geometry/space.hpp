#pragma once

#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// The abstract data types of affine geometry: spaces, their points and vectors, simplices, affine maps and
/// blossoms. Coordinates are needed only to create points. Source: DeRose, Goldman, Lounsbery: A Tutorial
/// Introduction to Blossoming, section 6.

namespace blossom::geometry {

class Point;
class Vector;

/// An affine space over Q. Each constructed space is distinct: its points cannot be combined with those of
/// another space, even of the same dimension. A copy is the same space.
class Space {
public:
    /// Messages use `name`.
    explicit Space(std::size_t dimension, std::string name = "");

    std::size_t dimension() const { return description_->dimension; }
    const std::string& name() const { return description_->name; }

    /// Errors: `mismatched_dimensions` if the number of coordinates is not the dimension.
    Point point(Coordinates coordinates) const;
    Vector vector(Coordinates coordinates) const;
    Point origin() const;

    /// Whether they are the same space.
    friend bool operator==(const Space&, const Space&) = default;

private:
    struct Description {
        std::size_t dimension;
        std::string name;
    };
    std::shared_ptr<const Description> description_;
};

/// A vector of a space: a difference of points.
class Vector {
public:
    const Space& space() const { return space_; }
    const Coordinates& coordinates() const { return coordinates_; }

    /// Errors of this and all other operations on two vectors: `different_spaces`.
    friend Vector operator+(const Vector& a, const Vector& b);
    friend Vector operator-(const Vector& a, const Vector& b);
    friend Vector operator-(const Vector& a);
    friend Vector operator*(const Rational& scale, const Vector& a);
    friend bool operator==(const Vector&, const Vector&) = default;

private:
    friend class Space;
    Vector(Space space, Coordinates coordinates)
        : space_(std::move(space)), coordinates_(std::move(coordinates)) {}

    Space space_;
    Coordinates coordinates_;
};

/// A point of a space. Points cannot be added or multiplied; see `affine_combination`.
class Point {
public:
    const Space& space() const { return space_; }
    const Coordinates& coordinates() const { return coordinates_; }

    friend Vector operator-(const Point& a, const Point& b);
    friend Point operator+(const Point& a, const Vector& b);
    friend Point operator-(const Point& a, const Vector& b);
    friend bool operator==(const Point&, const Point&) = default;

private:
    friend class Space;
    Point(Space space, Coordinates coordinates)
        : space_(std::move(space)), coordinates_(std::move(coordinates)) {}

    Space space_;
    Coordinates coordinates_;
};

/// sum weights[i] points[i] with weights of sum 1, a point that does not depend on the origin.
///
/// Errors: `not_affine` if the sum is not 1, `different_spaces`, `wrong_arity` if there is no point or
/// another number of weights. Source: DeRose, equation (1). Statement: derose-affine-comb.
Point affine_combination(std::span<const Point> points, std::span<const Rational> weights);

/// Errors: `different_spaces`, naming both.
void require_same_space(const Space& expected, const Space& given);

}  // namespace blossom::geometry
