#pragma once

#include <blossom/proofs/certificate.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace blossom::proofs::second {

/// Checks certificates one after the other; consecutive certificates of the same text read it once.
///
/// Everything is recomputed: the second reader reads the text, both sides are expanded as rational functions,
/// and each step is checked against the hypotheses. A certificate may be arbitrary; the limits bound the cost
/// of its check.
class CertificateChecker {
public:
    explicit CertificateChecker(const Limits& limits);
    ~CertificateChecker();
    CertificateChecker(const CertificateChecker&) = delete;
    CertificateChecker& operator=(const CertificateChecker&) = delete;
    CertificateChecker(CertificateChecker&&) = delete;
    CertificateChecker& operator=(CertificateChecker&&) = delete;

    /// "" if the certificate proves its case; otherwise a sentence that says what is wrong.
    std::string problem_of(const Certificate& certificate);
    /// The assumptions of the last certificate beyond its text: "a != 0" for a pivot that was left open.
    const std::vector<std::string>& added_conditions() const { return added_conditions_; }
    /// All cases of all lines `claim` of a text. Errors: those of the second reader.
    const std::vector<Case>& claimed_cases(const std::string& text);

private:
    struct Text;
    Text& read(const std::string& text);

    Limits limits_;
    std::vector<std::string> added_conditions_;
    std::unique_ptr<Text> text_;
};

}  // namespace blossom::proofs::second
