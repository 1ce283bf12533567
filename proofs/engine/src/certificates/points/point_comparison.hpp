#pragma once

#include "certificates/reading/second_reading.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

/// What evaluating both sides at points that satisfy the hypotheses shows.
struct Comparison {
    enum class Result { agree, differ, no_point } result = Result::no_point;
    std::size_t points = 0;  ///< at which both sides were evaluated
    std::string note;        ///< why there is no point, or where the sides differ
};

/// What the other road found out about the hypotheses of a case.
struct Hint {
    std::vector<std::string> dependent;                   ///< symbols that it solved for, in its order
    std::vector<std::pair<std::string, Rational>> point;  ///< a whole point, may be empty
};

/// Compares both sides of a case at random points. Hypotheses are solved here, for symbols of the hint before
/// others; the point of the hint is taken only where that fails, and every point is verified.
///
/// Errors: those of the evaluation but `division_by_zero`, which leads to another point.
Comparison compare(const Reading& reading, const Case& which, const Hint& hint, std::size_t points,
                   std::uint64_t seed);

/// Whether a counterexample is one: assumptions and hypotheses hold, no divisor vanishes, the sides differ.
/// `algebraic` names have no value but are roots of hypotheses.
Comparison confirm(const Reading& reading, const Case& which,
                   const std::vector<std::pair<std::string, Rational>>& values,
                   const std::vector<std::string>& algebraic);

}  // namespace blossom::proofs::second
