#pragma once

#include <blossom/proofs/certificate.hpp>

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

/// Compares both sides of a case at random points. Hypotheses are solved here, for the symbols of `hint`, the
/// steps of the other road, before others. Where that fails the steps themselves are solved; every point is
/// verified against the text.
///
/// Errors: those of the evaluation but `division_by_zero`, which leads to another point.
Comparison compare(const Reading& reading, const Case& which, const std::vector<Step>& hint,
                   std::size_t points, std::uint64_t seed);

/// Whether a counterexample is one: assumptions and hypotheses hold, no divisor vanishes, the sides differ.
/// `algebraic` names have no value but are roots of hypotheses, which `hint` may give as in `compare`.
Comparison confirm(const Reading& reading, const Case& which,
                   const std::vector<std::pair<std::string, Rational>>& values,
                   const std::vector<std::string>& algebraic, const std::vector<Step>& hint);

}  // namespace blossom::proofs::second
