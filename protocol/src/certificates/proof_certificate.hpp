#pragma once

#include <blossom/proofs/certificate.hpp>
#include <blossom/proofs/ground.hpp>

#include <span>
#include <vector>

#include <blossom/protocol/json.hpp>

/// Certificates of proofs as JSON.

namespace blossom::protocol {

/// {"n": 3, ...}: the values of the parameters of a case.
Json parameters_json(const proofs::Parameters& parameters);

/// {"certificate": 2, "proofs": [{"id", "title", "text", "line", "parameters", "conditions", "proof"}, ...]}:
/// of each proved case the text of its block, the line, what must not vanish, and the steps of the
/// elimination.
Json certificates_json(std::span<const proofs::second::Certificate> certificates);

/// Errors: `missing_field`, `wrong_kind` and the like, each with its place, for what is no certificate.
std::vector<proofs::second::Certificate> read_certificates(const Json& json, const Limits& limits);

}  // namespace blossom::protocol
