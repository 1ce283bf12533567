#pragma once

#include <algorithm>
#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>
#include <cstddef>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include "support/random.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"

/// Functions that the tests of the prover share.

namespace blossom::testing {

/// The decisions of all lines of a text without syntax errors.
inline std::vector<proofs::Decision> decided(std::string_view text, const Limits& limits = {}) {
    const proofs::Document document = proofs::parse(text, limits);
    for (const Error& error : document.errors) FAIL(proofs::diagnostic("text", text, error));
    std::vector<proofs::Decision> decisions;
    for (const proofs::Block& block : document.blocks) {
        for (proofs::Decision& decision : proofs::decide(block, limits))
            decisions.push_back(std::move(decision));
    }
    return decisions;
}

/// "proved", "refuted", or the diagnostic of an undecided line; for several lines separated by blanks. A line
/// that is refuted in one case and has an error in another is refuted.
inline std::string verdicts(std::string_view text, const Limits& limits = {}) {
    std::string result;
    for (const proofs::Decision& decision : decided(text, limits)) {
        if (!result.empty()) result += " ";
        const bool decided =
            decision.verdict() == proofs::Verdict::proved || decision.verdict() == proofs::Verdict::refuted;
        if (!decided) REQUIRE(decision.error());
        result += decided ? std::string(proofs::verdict_name(decision.verdict()))
                          : proofs::diagnostic("text", text, *decision.error());
    }
    return result;
}

/// "a != b, w != 0": the conditions of a line, assumed or not.
inline std::string conditions(const proofs::Decision& decision) {
    std::string result;
    for (const proofs::Condition& condition : decision.conditions())
        result += (result.empty() ? "" : ", ") + condition.text;
    return result;
}

/// The verdicts of all cases of the only line, one letter each: proved, refuted, undecided, disagreement.
inline std::string by_case(const proofs::Decision& decision) {
    std::string result;
    for (const proofs::CaseDecision& one : decision.cases)
        result += proofs::verdict_name(one.verdict).front();
    return result;
}

/// "3:7 message": the position and the message of the error of the only line.
inline std::string complaint(std::string_view text) {
    const auto decisions = decided(text);
    REQUIRE(decisions.size() == 1);
    REQUIRE(decisions[0].error());
    const Error& error = *decisions[0].error();
    REQUIRE(error.offset());
    const proofs::LineAndColumn place = proofs::line_and_column(text, *error.offset());
    return std::to_string(place.line) + ":" + std::to_string(place.column) + " " + error.message();
}

}  // namespace blossom::testing

using namespace blossom;
using namespace blossom::testing;
