#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

/// One choice of the parameters of a claim.
struct Case {
    std::size_t line = 0;  ///< the number of the line among the claim and refute lines of the block, from 0
    std::vector<std::pair<std::string, long long>>
        parameters;  ///< those of the block, then those of the line, in order
};

/// coefficient * prod symbol^exponent
struct NamedTerm {
    Rational coefficient;
    std::vector<std::pair<std::string, std::size_t>> powers;
};

using NamedPolynomial = std::vector<NamedTerm>;

/// One use of a hypothesis: after the earlier steps, some hypothesis gives `relation` == 0, up to factors
/// that do not vanish. The relation is linear in `symbol` with a cofactor that does not vanish (degree 1), or
/// monic in it up to a number (degree 2 and more). Later steps replace the symbol, or its powers from
/// `degree` on.
struct Step {
    std::string symbol;
    std::size_t degree = 1;
    NamedPolynomial relation;
};

/// The conclusion from the hypotheses of a case after a sequence of steps.
struct Branch {
    enum class End {
        agree,       ///< the difference of the sides reduces to 0
        impossible,  ///< a hypothesis reduces to something that does not vanish, or a nonzero condition to 0
        split,       ///< `pivot` does not vanish in branches[0] and is 0 in branches[1]
        open,        ///< left undecided: only for branches[1] if the pivot is among the conditions
    };
    std::vector<Step> steps;
    End end = End::agree;
    NamedPolynomial pivot;
    std::vector<Branch> branches;
};

/// Why the two sides of one case of a claim agree if the conditions do not vanish.
struct Certificate {
    std::string id;
    std::string title;
    std::string text;  ///< the text of the block
    Case which;
    /// Every divisor, every difference that is assumed not to vanish and every open pivot is a product of
    /// factors of these.
    std::vector<NamedPolynomial> conditions;
    Branch root;
};

/// "" if the certificate proves its case; otherwise a sentence that says what is wrong.
std::string problem_of(const Certificate& certificate, const Limits& limits);

/// What a list of certificates proves about one line `claim` of a block.
struct Confirmed {
    std::string id;
    std::string title;
    /// the number of the line among the claim and refute lines of the block, from 0
    std::size_t line = 0;
    bool confirmed = false;  ///< whether all cases of its ranges are proved
    std::size_t cases = 0;   ///< the number of cases of its ranges
    std::size_t proved = 0;  ///< the number of proved cases
    /// "a != 0": assumptions beyond the text, from pivots that were left open
    std::vector<std::string> where;
    std::string problem;  ///< the first problem, or ""
};

/// One entry per line `claim` of each text, in the order of the first certificate of each text. A text that
/// cannot be read has one entry with the problem.
std::vector<Confirmed> confirmed_theorems(std::span<const Certificate> certificates, const Limits& limits);

}  // namespace blossom::proofs::second
