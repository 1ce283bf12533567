#pragma once

// The oracle for the blossoms: the definitions as sums over all subsets, on numbers of another library.

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace blossom::textbook {

/// sum_k c_k times the average, over the subsets S of k arguments, of prod_{i in S} u_i prod_{i not in S}
/// v_i.
std::vector<std::string> blossom_of_coefficients(std::span<const Coordinates> coefficients,
                                                 std::span<const Argument> arguments);

/// sum_k P_k times the sum, over the subsets S of k arguments, of prod_{i in S} (u_i - a v_i) / (b - a) and
/// of prod_{i not in S} (b v_i - u_i) / (b - a).
std::vector<std::string> blossom_of_control_points(std::span<const Coordinates> control_points,
                                                   const Interval& interval,
                                                   std::span<const Argument> arguments);

/// sum_k c_k t^k, and its derivative of some order.
std::vector<std::string> polynomial_value(std::span<const Coordinates> coefficients, const Rational& t,
                                          std::size_t order = 0);

/// sum_k P_k C(n, k) s^k (1 - s)^(n-k) with s = (t - a) / (b - a).
std::vector<std::string> bernstein_value(std::span<const Coordinates> control_points,
                                         const Interval& interval, const Rational& t);

/// The engine's value in the text form of the oracle.
std::vector<std::string> text(const Coordinates& value);

}  // namespace blossom::textbook
