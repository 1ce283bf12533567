#pragma once

#include <blossom/core/queries/curve_pieces.hpp>

#include <optional>

namespace blossom {

/// A function N/D in a range, where D is not 0.
struct QuotientPiece {
    Polynomial numerator;
    Polynomial denominator;
    ParameterRange range;
};

struct Extremum {
    Root at;
    Root value;
    bool is_maximum = false;
};

/// The least or the greatest value of a function, and where it is taken.
struct GlobalExtremum {
    Root value;
    std::vector<Root> parameters;        ///< in rising order
    std::vector<ParameterRange> ranges;  ///< where the function is constant with this value
};

struct Extrema {
    std::vector<Extremum> local;           ///< in rising order
    std::vector<ParameterRange> constant;  ///< where the function is constant, in rising order
    std::optional<GlobalExtremum> least;   ///< not there if the function takes no least value
    std::optional<GlobalExtremum> greatest;
};

/// The local and the global extrema of a function of pieces in rising order, the ends of its ranges included.
/// Where pieces with one value meet, the function passes on; where it jumps, each side ends there. Ends of
/// constant ranges are no local extrema.
///
/// The stationary points are the roots of N' D - N D'; values at them are compared exactly.
/// Cost: for each piece `roots` and a resultant. Errors: `zero_weight` if a denominator has a root in the
/// range of its piece; `limit_exceeded`.
Extrema extrema(std::span<const QuotientPiece> pieces, const Rational& width = 0, const Limits& limits = {});

/// a_1 x_1 + ... + a_d x_d along a curve. Errors: `mismatched_dimensions` unless there are d numbers.
std::vector<QuotientPiece> component(std::span<const CurvePiece> pieces, std::span<const Rational> direction);

/// The square of the distance to a point along a curve. Errors: `mismatched_dimensions`.
std::vector<QuotientPiece> squared_distance(std::span<const CurvePiece> pieces,
                                            std::span<const Rational> point);

}  // namespace blossom
