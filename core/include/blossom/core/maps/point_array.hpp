#pragma once

#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// The coordinates of one point or vector of Q^d.
using Coordinates = std::vector<Rational>;

/// Points of Q^d over one common denominator, stored coordinate by coordinate: the coefficients of
/// polynomials and the points of control polygons. Canonical only on request, see `RationalVector`. There is
/// at least one point; after a move there is none, and the functions throw `internal`.
class PointArray {
public:
    /// Errors: `mismatched_dimensions` unless all points have the same dimension d >= 1, with the place `i`
    /// of the first that differs; `wrong_arity` if there is none.
    explicit PointArray(std::span<const Coordinates> points);
    PointArray(std::initializer_list<Coordinates> points)
        : PointArray(std::span(points.begin(), points.size())) {}
    /// `numbers` holds `dimension` rows of equal length, one per coordinate. Errors: `wrong_arity` if there
    /// is no point or an incomplete one.
    PointArray(Count dimension, RationalVector numbers);
    /// `numbers` holds the coordinates point by point. Errors: as above.
    static PointArray point_by_point(Count dimension, std::span<const Rational> numbers);

    std::size_t size() const {
        if (numbers_.empty()) refuse_moved();
        return numbers_.size() / dimension_;
    }
    std::size_t dimension() const { return dimension_; }
    /// The numerators of coordinate j of all points. Errors: `outside_domain` unless j < dimension().
    std::span<const Integer> coordinate(std::size_t j) const {
        require_index(j, dimension_);
        return std::span(numbers_.numerators()).subspan(j * size(), size());
    }
    /// One row of numerators per coordinate.
    std::vector<std::span<const Integer>> rows() const;
    const Integer& denominator() const { return numbers_.denominator(); }
    const RationalVector& numbers() const { return numbers_; }
    /// Errors: `outside_domain` unless i < size().
    Coordinates operator[](std::size_t i) const;
    std::vector<Coordinates> to_points() const;
    void make_canonical() { numbers_.make_canonical(); }

    friend bool operator==(const PointArray&, const PointArray&) = default;
    /// "(0, 0), (1, 1/2)".
    friend std::string to_string(const PointArray& points);
    friend std::size_t hash_value(const PointArray& points) {
        return hash_of(points.dimension_, points.numbers_);
    }

private:
    [[noreturn]] static void refuse_moved();

    std::size_t dimension_;
    RationalVector numbers_;
};

}  // namespace blossom
