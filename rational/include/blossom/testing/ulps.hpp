#pragma once

#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// For the tests of other programs: the distance of doubles from exact numbers.

namespace blossom {

/// |computed - exact| in units in the last place of the exact number. Errors: `not_a_number` for NaN and
/// infinities; `overflow` for |exact| >= 2^1024.
inline Rational ulps(double computed, const Rational& exact) {
    return abs(exact_rational(computed) - exact) / unit_in_last_place(exact);
}

/// What a test reports of a double: the exact number, the nearest double and the distance. NaN and infinities
/// are never near.
struct UlpComparison {
    bool within = false;
    std::string text;

    UlpComparison(double computed, const Rational& exact, const Rational& most) {
        const std::string number = hexadecimal_float(exact);
        if (!std::isfinite(computed)) {
            text = std::to_string(computed) + " is not finite; the exact number is " + to_string(exact);
            return;
        }
        const Rational distance = ulps(computed, exact);
        within = distance <= most;
        const Integer thousandths = distance.numerator() * 1000 / distance.denominator();
        const std::string rest = to_string(thousandths % 1000 + 1000).substr(1);
        text = hexadecimal_float(exact_rational(computed)) + " is at least " + to_string(thousandths / 1000) +
               "." + rest + " ulp from " + to_string(exact) + " (nearest double " + number + "); at most " +
               to_string(most) + " are allowed";
    }

    /// The first coordinate that is too far away, or the last one.
    UlpComparison(std::span<const double> computed, std::span<const Rational> exact, const Rational& most) {
        within = computed.size() == exact.size();
        if (!within) {
            text = std::to_string(computed.size()) + " coordinates are compared with " +
                   std::to_string(exact.size());
        }
        for (std::size_t i = 0; within && i < exact.size(); ++i) {
            const UlpComparison coordinate(computed[i], exact[i], most);
            within = coordinate.within;
            text = "coordinate " + std::to_string(i) + ": " + coordinate.text;
        }
    }
};

}  // namespace blossom
