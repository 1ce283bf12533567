#pragma once

// The oracle for the splines: the Cox-de Boor recursion and polarization, on plain rational numbers.

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom::textbook {

/// The numbers of a spline in the textbook convention.
struct Spline {
    std::size_t degree;
    std::vector<Rational> knots;
    std::vector<Coordinates> points;
};

/// The spline with one knot added at each end, where the polar convention omits it; any other two knots would
/// do.
Spline with_end_knots(std::size_t degree, std::vector<Rational> knots, std::vector<Coordinates> points);

/// N_0(t), ..., where every basis function is replaced by the polynomial that equals it on [t_span,
/// t_(span+1)).
std::vector<Rational> basis_polynomials(const Spline& spline, std::size_t span, const Rational& t);

/// The polynomial of one span, at any t.
Coordinates segment_value(const Spline& spline, std::size_t span, const Rational& t);

/// The span of t: the last one that does not begin after t; at the end of the domain, the last non-empty one.
std::size_t span_of(const Spline& spline, const Rational& t);

Coordinates value(const Spline& spline, const Rational& t);

/// The blossom of one span's polynomial, from its values alone. A vector is the difference of two points, and
/// a pair (u, v) with v != 0 is v times the point u / v.
Coordinates segment_blossom(const Spline& spline, std::size_t span, std::span<const Argument> arguments);

/// Whether two splines of any degrees are the same map on the same domain.
bool same_map(const Spline& a, const Spline& b);

}  // namespace blossom::textbook
