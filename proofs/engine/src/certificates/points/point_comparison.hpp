#pragma once

#include <blossom/proofs/certificate.hpp>

#include "certificates/reading/second_reading.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

/// The result of evaluating both sides at points that satisfy the hypotheses.
struct Comparison {
    enum class Result { agree, differ, no_point } result = Result::no_point;
    std::size_t points = 0;  ///< the number of points at which both sides were evaluated
    std::string note;        ///< why there is no point, or where the sides differ
};

/// Compares both sides of a case at random points. Hypotheses are solved here, preferably for the symbols of
/// `hint`, the steps of the other road. If this fails, the steps themselves are solved; every point is
/// verified against the text.
///
/// Errors: those of the evaluation except `division_by_zero`, after which another point is tried.
Comparison compare(const Reading& reading, const Case& which, const std::vector<Step>& hint,
                   std::size_t points, std::uint64_t seed);

/// Verifies a counterexample: assumptions and hypotheses hold, no divisor vanishes, and the sides differ.
/// `algebraic` names have no value but are roots of hypotheses, which `hint` may contain as in `compare`.
Comparison confirm(const Reading& reading, const Case& which,
                   const std::vector<std::pair<std::string, Rational>>& values,
                   const std::vector<std::string>& algebraic, const std::vector<Step>& hint);

}  // namespace blossom::proofs::second
