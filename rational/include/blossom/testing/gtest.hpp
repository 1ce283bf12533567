#pragma once

#include <blossom/testing/ulps.hpp>

#include <gtest/gtest.h>

/// Assertions for GoogleTest, of doubles and of the coordinates of points:
///
///     EXPECT_TRUE(blossom::WithinUlps(library.evaluate(0.25), evaluate(curve, Rational(1, 4))[0],
///     1));

namespace blossom {

/// Whether a double is at most `most` units in the last place from an exact number.
inline ::testing::AssertionResult WithinUlps(double computed, const Rational& exact, const Rational& most) {
    const UlpComparison comparison(computed, exact, most);
    return (comparison.within ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
           << comparison.text;
}

/// The same for each coordinate of a point.
inline ::testing::AssertionResult WithinUlps(std::span<const double> computed,
                                             std::span<const Rational> exact, const Rational& most) {
    const UlpComparison comparison(computed, exact, most);
    return (comparison.within ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
           << comparison.text;
}

}  // namespace blossom
