#pragma once

#include <blossom/testing/ulps.hpp>

#if __has_include(<catch2/matchers/catch_matchers.hpp>)
#include <catch2/matchers/catch_matchers.hpp>
#else
#include <catch2/catch.hpp>
#endif

/// Matchers for Catch2, versions 2 and 3:
///
///     CHECK_THAT(library.evaluate(0.25), blossom::IsWithinUlps(evaluate(curve, Rational(1, 4))[0],
///     1));

namespace blossom {

#if __has_include(<catch2/matchers/catch_matchers.hpp>)
template <class T>
using MatcherBase = Catch::Matchers::MatcherBase<T>;
#else
template <class T>
using MatcherBase = Catch::MatcherBase<T>;
#endif

/// Whether doubles are at most `most` units in the last place from exact numbers.
template <class Computed, class Exact>
class UlpMatcher : public MatcherBase<Computed> {
public:
    UlpMatcher(Exact exact, Rational most) : exact_(std::move(exact)), most_(std::move(most)) {}

    bool match(const Computed& computed) const override {
        const UlpComparison comparison(computed, exact_, most_);
        text_ = comparison.text;
        return comparison.within;
    }
    std::string describe() const override { return "\n" + text_; }

private:
    Exact exact_;
    Rational most_;
    mutable std::string text_;  ///< of the last comparison
};

/// A double near an exact number, and a point near an exact point.
using IsWithinUlps = UlpMatcher<double, Rational>;
using PointIsWithinUlps = UlpMatcher<std::vector<double>, std::vector<Rational>>;

}  // namespace blossom
