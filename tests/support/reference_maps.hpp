#pragma once

// The worked examples of the literature that several tests use.

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/maps/bezier_curve.hpp>

#include <string_view>

namespace blossom::testing {

inline Polynomial univariate(std::string_view text) { return parse_univariate(text).polynomial; }

/// The curve of degree 10 of Fernandez-Jambrina, example 2.
inline std::vector<Polynomial> degree_ten_curve() {
    return {univariate("t^10 - 3t^8 + 2t^7 - t^5 + t^2 + t - 3"),
            univariate("-2t^10 + t^9 - t^7 + t^5 + t^3 + t^2")};
}

}  // namespace blossom::testing
