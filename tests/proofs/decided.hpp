#pragma once

#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>

#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"

/// What the tests of the prover have in common.

namespace blossom::testing {

/// The decisions of all lines of a text that can be read.
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

/// "proved", "refuted", or the diagnostic of what could not be decided; of several lines with blanks between.
inline std::string verdicts(std::string_view text, const Limits& limits = {}) {
    std::string result;
    for (const proofs::Decision& decision : decided(text, limits)) {
        if (!result.empty()) result += " ";
        result += decision.error ? proofs::diagnostic("text", text, *decision.error)
                                 : std::string(proofs::verdict_name(decision.verdict));
    }
    return result;
}

}  // namespace blossom::testing
