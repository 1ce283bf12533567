#pragma once

#include <blossom/proofs/certificate.hpp>
#include <blossom/proofs/fraction.hpp>
#include <blossom/proofs/ground.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace blossom::proofs {

/// A map of a counterexample, written out.
struct WitnessMap {
    std::string name;
    std::string text;  ///< "1 + t^2", in t, or x1, x2, ... when there are several variables
    std::vector<Direction> directions;
};

/// One value of a map that the counterexample needs.
struct WitnessValue {
    std::string text;     ///< "b[0, 1, delta] = 2"
    std::string command;  ///< "blossom blossom \"t^2\" --degree 3 --at 0,1,delta", or empty
};

/// Where a claim fails: every map and variable of the claim, its hypotheses and its assumptions, and both
/// sides there.
struct Counterexample {
    Parameters parameters;
    std::vector<WitnessMap> maps;
    std::vector<std::pair<std::string, Rational>> variables;
    std::vector<std::string>
        roots;         ///< "w^2 - 1/2 == 0": variables without a rational value, by their relations
    std::string left;  ///< a number, or an expression in variables without one
    std::string right;
    std::vector<WitnessValue> values;
};

enum class Verdict {
    proved,       ///< for all maps of the degrees and all values of the variables, on both roads
    refuted,      ///< with a counterexample
    undecided,    ///< with an error: what the statement says is not defined, does not fit, or exceeds a limit
    disagreement  ///< with an error: the two roads came to different ends, so one of them is wrong
};

std::string_view verdict_name(Verdict verdict);

/// Something that must not vanish for a claim to be defined, or to be proved.
struct Condition {
    std::string text;      ///< "a != b", "w(t) != 0"
    bool assumed = false;  ///< a line `assume` says so

    friend bool operator==(const Condition&, const Condition&) = default;
};

/// What became of one case of a line: one choice of the parameters.
struct CaseDecision {
    Parameters parameters;
    Verdict verdict = Verdict::proved;
    std::size_t terms = 0;  ///< of the normal form of the left side
    std::vector<Condition> conditions;
    std::vector<std::string> open;      ///< "a == 0": what a pivot excluded and could not be decided
    std::vector<std::string> holds_if;  ///< of a refuted case: "a != 0", where it is proved
    std::optional<Counterexample> counterexample;
    std::optional<Error> error;
};

/// What a line says of its claim.
enum class Expectation {
    proof,           ///< claim: proved in every case
    refutation,      ///< refute: refuted in every case
    some_refutation  ///< refute some: refuted in at least one case
};

/// What became of one line `claim` or `refute`.
struct Decision {
    std::size_t statement = 0;  ///< its number in the block
    std::size_t offset = 0;
    Expectation expectation = Expectation::proof;
    std::vector<CaseDecision> cases;

    /// The worst of all cases: a disagreement, then refuted, then undecided, which a line without cases is
    /// too.
    Verdict verdict() const;
    bool as_expected() const;
    std::size_t terms() const;
    /// Those of all cases, each once.
    std::vector<Condition> conditions() const;
    /// Of the first case that has one, or nullptr.
    const Counterexample* counterexample() const;
    const Error* error() const;
};

/// One case of a claim that was proved, while its expansion is at hand.
struct ProvedCase {
    const GroundBlock& block;
    const Relation& relation;
    const Fraction& left;                          ///< the normal form of the left side
    const std::vector<SparsePolynomial>& factors;  ///< those of its denominator, by number
    const second::Certificate& certificate;        ///< accepted by the checker
};
using ProofListener = std::function<void(const ProvedCase& proved)>;

/// Who hears of proofs.
struct DecisionOptions {
    ProofListener on_proof;
};

/// Decides every claim and refutation of a block, for every choice of the parameters, exactly and on two
/// roads.
///
/// First road: both sides are expanded to rational functions of the coefficients and the variables, and the
/// hypotheses are solved, with a case of its own for every pivot that may vanish. A case is proved when the
/// difference of the sides is zero in every branch; otherwise a counterexample is found in one that it is
/// not. Second road: the text of the block is read anew by code that shares nothing with this, both sides are
/// evaluated at points that satisfy the hypotheses, and the certificate of the case is checked from the text;
/// a counterexample is evaluated there too. A verdict is what both say. See docs/identity-language.md.
///
/// Cost: that of the expansions, within `limits.expansion_terms` and `limits.expansion_work` for each case.
/// Errors are in the decisions, each with its offset in the text; an error in one case leaves the others
/// alone.
std::vector<Decision> decide(const Block& block, const Limits& limits = {},
                             const DecisionOptions& options = {});

}  // namespace blossom::proofs
