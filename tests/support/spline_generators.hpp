#pragma once

#include <blossom/core/maps/bspline_curve.hpp>

#include <cstddef>
#include <functional>
#include <vector>

#include "map_generators.hpp"
#include "random.hpp"
#include "textbook_spline.hpp"

namespace blossom::testing {

/// The knots before the beginning and behind the end of a domain.
enum class Ends {
    clamped,   ///< copies of the end, as many as the convention permits: n + 1 or n in all
    open,      ///< other knots, in increasing order and partly repeated
    repeated,  ///< some copies of the end, and other knots
};

/// A B-spline as the numbers from which it was made.
struct SplineRecipe {
    std::size_t degree;
    std::vector<Rational> knots;
    std::vector<Coordinates> points;

    BSplineCurve curve() const { return {degree, knots, points}; }
    textbook::Spline oracle() const { return textbook::with_end_knots(degree, knots, points); }
};

textbook::Spline oracle(const BSplineCurve& curve);

/// A spline with one span more than there are inner multiplicities, each of which is 1 to degree + 1. Every
/// control point has influence.
SplineRecipe spline(Random& random, std::size_t degree, std::span<const std::size_t> inner_multiplicities,
                    KnotConvention convention, Ends begin, Ends end, Size size = Size::small);

/// A random spline of at most 8 spans.
SplineRecipe spline(Random& random, std::size_t degree, Size size = Size::small);

/// A plane cubic over the knots 0 to 7.
BSplineCurve example_spline();

/// Calls `visit` with every list of at most `most` multiplicities from 1 to `greatest`.
void for_each_pattern(std::size_t most, std::size_t greatest,
                      const std::function<void(std::span<const std::size_t>)>& visit);

/// A parameter in the domain: a knot in a third of the cases, the ends among them.
Rational parameter(Random& random, const KnotVector& knots);

/// At most `most` knots that can be inserted, some equal to knots of the curve and to each other, in any
/// order.
std::vector<Rational> insertable(Random& random, const KnotVector& knots, std::size_t most);

}  // namespace blossom::testing
