#pragma once

#include <blossom/proofs/parser.hpp>

#include <string>

namespace blossom::proofs {

/// The text in canonical form: one space around `+`, `-`, `==` and `!=`, none around `*`, `/` and `^`, only
/// necessary parentheses, one empty line between blocks, comments at their places. It parses to the same
/// document, and is its own canonical form. Errors: the first error of `document`, if it has one.
std::string formatted(const Document& document);

std::string to_text(const Expression& expression);
std::string to_text(const Statement& statement);

}  // namespace blossom::proofs
