#pragma once

#include <blossom/proofs/prover.hpp>
#include <blossom/worked/document.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Statements of the identity language as mathematicians write them: not one case with numbers for its
/// parameters, but the statement with its ranges, and what the prover says of it.

namespace blossom::worked {

/// An expression of a block as a formula: t{n-k} as Farin's t^<n-k>, sums and products with their signs,
/// indices and functions as in the literature.
Formula formula_of(const proofs::Block& block, const proofs::Expression& expression);

/// A relation or an expression of the prover, such as "b[0, t] != 0", as a formula; as words if it is
/// not one.
Formula formula_of_text(std::string_view text);

/// The declarations of a block in words: "Let b be a polynomial of formal degree n. Suppose that a ≠ b."
/// Empty for a block that declares nothing.
Text declarations_in_words(const proofs::Block& block);

/// A line `claim` or `refute`.
struct ClaimInWords {
    std::string before;  ///< the opening, and for `refute` "it is not true that"
    Formula claim;
    Text after;  ///< "for n = 1, ..., 8.", or nothing
};
ClaimInWords claim_in_words(const proofs::Block& block, const proofs::Statement& line,
                            const std::string& opening);

/// "Proved for n = 1, ..., 8, if a ≠ b." "Refuted for n = 2; it holds for n = 1."
Text verdict_in_words(const proofs::Block& block, const proofs::Decision& decision);

/// The theorem of a block with the verdict on each of its claims, for a document that takes it in with
/// \\input and has amsmath: the title, the declarations, each claim as a displayed formula with its ranges,
/// its verdict, and a counterexample if it is refuted.
std::string render_latex_theorem(const proofs::Block& block, const std::vector<proofs::Decision>& decisions);

/// "For n = 2, b(t) = t^2 of degree 2 and a = 0 the left side is 1 and the right side 2."
Text counterexample_in_words(const proofs::Counterexample& counterexample);

}  // namespace blossom::worked
