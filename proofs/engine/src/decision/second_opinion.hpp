#pragma once

#include <blossom/proofs/prover.hpp>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "certificates/certificate_checker.hpp"
#include "certificates/points/point_comparison.hpp"
#include "certificates/reading/second_reading.hpp"
#include "decided_case.hpp"

namespace blossom::proofs {

/// The second road for the cases of one block: its own reading of the text, points that satisfy the
/// hypotheses, and the check of certificates. Each function returns an objection, or nullopt.
class SecondOpinion {
public:
    /// Omits the lines `claim` and `refute` of `unfit` from the text, because they have no meaning.
    SecondOpinion(const Block& block, const std::set<std::size_t>& unfit, const Limits& limits);

    /// Compares the cases of each line with those of the text, in any order.
    std::optional<std::string> on_cases(const std::vector<Decision>& decisions);
    /// A case of a line, which is given by its number in the block.
    second::Case case_of(std::size_t statement, Parameters parameters) const;
    const std::string& text() const { return text_; }
    /// Evaluates both sides at points, and checks the certificate of the case.
    std::optional<std::string> on_proof(const GroundBlock& block, const second::Case& which,
                                        const CaseOutcome& outcome, const second::Certificate& certificate);
    /// Evaluates both sides at the counterexample.
    std::optional<std::string> on_refutation(const GroundBlock& block, const second::Case& which,
                                             const CaseOutcome& outcome);

private:
    std::string text_;
    std::vector<std::size_t> lines_;  ///< the numbers in the block of the lines that were read
    std::optional<second::Reading> reading_;
    std::string unread_;  ///< why the text could not be read
    second::CertificateChecker checker_;
};

/// The certificate of a proved case: its text, its conditions, and every step of the elimination.
second::Certificate certificate_of(const Block& block, const std::string& text, const GroundBlock& grounded,
                                   const second::Case& which, const CaseOutcome& outcome);

}  // namespace blossom::proofs
