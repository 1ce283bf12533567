#pragma once

#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// The coordinates of one point or vector of Q^d.
using Coordinates = std::vector<Rational>;

/// Points of Q^d over one common denominator, stored coordinate by coordinate: the coefficients of
/// polynomials and the points of control polygons. Canonical only on request, see `RationalVector`.
class PointArray {
public:
    /// Errors: `mismatched_dimensions` unless all points have the same dimension d >= 1, with the place `i`
    /// of the first that differs; `wrong_arity` if there is none.
    explicit PointArray(std::span<const Coordinates> points);
    /// `numbers` holds `dimension` rows of equal length, one per coordinate.
    PointArray(std::size_t dimension, RationalVector numbers);
    /// `numbers` holds the coordinates point by point. Errors: `wrong_arity` if there is no point.
    static PointArray point_by_point(std::size_t dimension, std::span<const Rational> numbers);

    std::size_t size() const { return numbers_.size() / dimension_; }
    std::size_t dimension() const { return dimension_; }
    /// The numerators of coordinate j of all points.
    std::span<const Integer> coordinate(std::size_t j) const {
        return std::span(numbers_.numerators()).subspan(j * size(), size());
    }
    /// One row of numerators per coordinate.
    std::vector<std::span<const Integer>> rows() const;
    const Integer& denominator() const { return numbers_.denominator(); }
    const RationalVector& numbers() const { return numbers_; }
    Coordinates operator[](std::size_t i) const;
    std::vector<Coordinates> to_points() const;
    void make_canonical() { numbers_.make_canonical(); }

    friend bool operator==(const PointArray&, const PointArray&) = default;

private:
    std::size_t dimension_;
    RationalVector numbers_;
};

}  // namespace blossom
