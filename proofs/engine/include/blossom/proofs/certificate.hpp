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
    std::size_t line = 0;  ///< among the claim and refute lines of the block, from 0
    std::vector<std::pair<std::string, long long>>
        parameters;  ///< the block's, then the line's own, in order
};

/// coefficient * prod symbol^exponent
struct NamedTerm {
    Rational coefficient;
    std::vector<std::pair<std::string, std::size_t>> powers;
};

using NamedPolynomial = std::vector<NamedTerm>;

/// One use of a hypothesis: after the earlier steps some hypothesis says `relation` == 0, up to factors that
/// do not vanish. It is linear in `symbol`, whose cofactor does not vanish (degree 1), or monic in it (degree
/// 2 and more, up to a number). From here on the symbol, or its powers from `degree` on, are replaced.
struct Step {
    std::string symbol;
    std::size_t degree = 1;
    NamedPolynomial relation;
};

/// What follows from the hypotheses of a case, after a row of steps.
struct Branch {
    enum class End {
        agree,       ///< the difference of the sides reduces to 0
        impossible,  ///< a hypothesis reduces to what does not vanish, or what must not vanish to 0
        split,       ///< `pivot` does not vanish in branches[0] and is 0 in branches[1]
        open,        ///< left open: only for branches[1], where the pivot is among the conditions
    };
    std::vector<Step> steps;
    End end = End::agree;
    NamedPolynomial pivot;
    std::vector<Branch> branches;
};

/// Why the two sides of one case of a claim agree wherever the conditions do not vanish.
struct Certificate {
    std::string id;
    std::string title;
    std::string text;  ///< of the block
    Case which;
    /// Every divisor, every difference that is assumed not to vanish and every pivot left open is a product
    /// of factors of these.
    std::vector<NamedPolynomial> conditions;
    Branch root;
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
    std::vector<std::string> where =
        {};               ///< "a != 0": what is assumed beyond the text, a pivot that was left open
    std::string problem;  ///< the first one met, or nothing
};

/// For each line `claim` of each text, in the order of the first certificate of each text. A text that cannot
/// be read has one entry with the problem.
std::vector<Confirmed> confirmed_theorems(std::span<const Certificate> certificates, const Limits& limits);

}  // namespace blossom::proofs::second
