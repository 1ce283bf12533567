#pragma once

#include "certificate.hpp"

#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace blossom::proofs::second {

/// Checks certificates one after the other; texts that follow one another are read once.
///
/// Everything is computed again: the text is read by the second reader, both sides are expanded as rational
/// functions, and each step is held against the hypotheses. A certificate may be anything; what it costs is
/// bounded by the limits.
class CertificateChecker {
public:
    explicit CertificateChecker(const Limits& limits);
    ~CertificateChecker();
    CertificateChecker(const CertificateChecker&) = delete;
    CertificateChecker& operator=(const CertificateChecker&) = delete;

    /// Nothing if the certificate proves its case; otherwise a sentence that says what is wrong.
    std::string problem_of(const Certificate& certificate);
    /// All cases of all lines `claim` of a text. Errors: those of the second reader.
    const std::vector<Case>& claimed_cases(const std::string& text);

private:
    struct Text;
    Text& read(const std::string& text);

    Limits limits_;
    std::unique_ptr<Text> text_;
};

/// Nothing if the certificate proves its case; otherwise a sentence that says what is wrong.
std::string problem_of(const Certificate& certificate, const Limits& limits);

/// What some certificates say of one line `claim` of a block.
struct Confirmed {
    std::string id;
    std::string title;
    std::size_t line = 0;    ///< among the claim and refute lines of the block, from 0
    bool confirmed = false;  ///< in all cases of its ranges
    std::size_t cases = 0;   ///< of its ranges
    std::size_t proved = 0;  ///< of these
    std::string problem;     ///< the first one met, or nothing
};

/// For each line `claim` of each text, in the order of the first certificate of each text. A text that cannot
/// be read has one entry with the problem.
std::vector<Confirmed> confirmed_theorems(std::span<const Certificate> certificates, const Limits& limits);

}  // namespace blossom::proofs::second
