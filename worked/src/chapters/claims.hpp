#pragma once

#include <blossom/proofs/prover.hpp>
#include <blossom/worked/document.hpp>
#include <blossom/worked/proof_chapter.hpp>

#include "curve_pictures.hpp"
#include "ground_formulas.hpp"

namespace blossom::worked {

/// A decided claim with its block.
struct DecidedClaim {
    const proofs::Block& block;
    const proofs::Decision& decision;
};

/// One case of a claim in which the claim is written out.
struct WrittenCase {
    proofs::GroundBlock block;
    proofs::Relation relation;
};

/// The lines of the statement with one of its claims.
Table statement_table(const DecidedClaim& claim);

/// "for n = 3" in words, or "" without parameters.
Text parameters_text(const std::vector<std::pair<std::string, long long>>& parameters);

/// A letter for the parameter of the maps that is not one of the variables.
std::string free_letter(const proofs::GroundBlock& block);

/// The two sides with the sign that asks whether they are equal.
Formula question(const WrittenCase& written);

/// The applications of maps in both sides, each once as it is written.
std::vector<proofs::NodeId> applications_of(const WrittenCase& written);

/// Appends the proof or the refutation to a document that contains the statement.
void append_proof(Document& document, const DecidedClaim& claim, const std::optional<WrittenCase>& written,
                  const Limits& limits);
void append_refutation(Document& document, const DecidedClaim& claim,
                       const std::optional<WrittenCase>& written, const Limits& limits);

}  // namespace blossom::worked
