// A file is either refused because it is not a certificate, or its proofs are checked. The prover does not
// refute a claim that is confirmed without conditions.

#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "certificates/proof_certificate.hpp"
#include "json/json_text.hpp"

namespace {

using namespace blossom;

Limits small_limits() {
    Limits limits;
    limits.degree = 12;
    limits.digits = 300;
    limits.nesting = 30;
    limits.variables = 32;
    limits.expansion_terms = 1 << 8;
    limits.expansion_work = 20'000;
    limits.numbers = 1 << 10;
    limits.work = 50'000'000;
    return limits;
}

bool is_refuted(const std::string& text, std::size_t line, const Limits& limits) {
    const proofs::Document document = proofs::parse(text, limits);
    if (!document.errors.empty() || document.blocks.empty()) return false;
    const auto decisions = proofs::decide(document.blocks.front(), limits);
    return line < decisions.size() && decisions[line].verdict() == proofs::Verdict::refuted;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Limits limits = small_limits();
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const ResourceBudget budget(limits);
        const auto certificates = protocol::read_certificates(protocol::parse_json(text, limits), limits);
        const bool one_text = std::ranges::all_of(
            certificates, [&](const auto& other) { return other.text == certificates.front().text; });
        for (const auto& found : proofs::second::confirmed_theorems(certificates, limits)) {
            if (found.confirmed && found.where.empty() && one_text &&
                is_refuted(certificates.front().text, found.line, limits))
                std::abort();
        }
    } catch (const Error& error) {
        if (error.code() == ErrorCode::internal) std::abort();
    }
    return 0;
}
