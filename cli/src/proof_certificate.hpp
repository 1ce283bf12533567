#pragma once

#include <blossom/proofs/prover.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include "json.hpp"

/// Records of proofs that can be checked without the prover.

namespace blossom::cli {

/// One proved case as an entry of a certificate: the expressions of both sides node by node, their common
/// normal form, and the symbols for which hypotheses were solved.
Json certificate_entry(const proofs::ProvedCase& proved, const std::string& id, const std::string& statement);

/// The certificate with its seal, which shows damage.
Json sealed_certificate(Json::Array entries);

/// What a check of a certificate gave: the number of entries that are proofs, and what is wrong with the
/// others.
struct CertificateCheck {
    std::size_t confirmed = 0;
    std::vector<std::string> problems;
};

/// Checks every entry: expands both sides with arithmetic of its own and the definition of the blossom by
/// sums over subsets, and compares with the normal form that is recorded. It shares nothing with the prover
/// but exact numbers. Errors: `syntax`, `missing_field` and the like for what is no certificate.
CertificateCheck check_certificate(const Json& certificate);

/// The seal over the entries: an FNV-1a hash of their text.
std::string seal_of(const Json& entries);

}  // namespace blossom::cli
