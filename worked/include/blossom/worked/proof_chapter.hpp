#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/worked/document.hpp>

#include <string_view>
#include <vector>

namespace blossom::worked {

/// The proof or refutation of each claim of a statement: first the claim in general, with its
/// indices and ranges; then for a proof the expansion of every value, and with it of both sides, in the
/// largest case that can be read; for a refutation the counterexample with both sides computed from it.
///
/// The statement is a text of the identity language; each line `claim` or `refute` has a page. Values of maps
/// with several arguments, and claims with hypotheses, are not written out; all else is. Errors: `syntax`,
/// with the place in the message and its offset; `wrong_arity` for no claim; those of the prover.
std::vector<Document> claims_decided(std::string_view statement, const Limits& limits = {});

}  // namespace blossom::worked
