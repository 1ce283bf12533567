#pragma once

// The oracle of the splines: the Cox-de Boor recursion and polarization, on plain rational numbers.

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom::textbook {

/// A spline as its numbers, in the textbook convention.
struct Spline {
    std::size_t degree;
    std::vector<Rational> knots;
    std::vector<Coordinates> points;
};

/// The same spline when one knot at each end was left out; any other two would do as well.
Spline with_end_knots(std::size_t degree, std::vector<Rational> knots, std::vector<Coordinates> points);

/// N_0(t), ..., with every basis function replaced by the polynomial that it is on [t_span, t_(span+1)).
std::vector<Rational> basis_polynomials(const Spline& spline, std::size_t span, const Rational& t);

/// The polynomial of one span, at any t.
Coordinates segment_value(const Spline& spline, std::size_t span, const Rational& t);

/// The span of t: the last one that does not begin behind t, at the end of the domain the last that is not
/// empty.
std::size_t span_of(const Spline& spline, const Rational& t);

Coordinates value(const Spline& spline, const Rational& t);

/// The blossom of one span's polynomial, from its values alone. A vector is taken as the difference of two
/// points, a pair (u, v) with v != 0 as v times the point u / v.
Coordinates segment_blossom(const Spline& spline, std::size_t span, std::span<const Argument> arguments);

/// Whether two splines of any degrees are the same map on the same domain.
bool same_map(const Spline& a, const Spline& b);

}  // namespace blossom::textbook
